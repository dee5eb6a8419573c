// Cutting along cells: exact tiling and conformity on random soups and real environments, whatever the threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/partitioning/checked_cuts.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestRandomCuts : public QObject {
  Q_OBJECT

 private slots:
  void extremeNumbers() {
    for (const double factor : {0x1p-1060, 0x1p-600, 0x1p600, 0x1p1010}) {
      const test::Soup soup =
          test::Soup().floor(0, 0, 4, 4, 0).ramp(1, 1, 7, 3, 0, 5).wall(0, 1, 5, 4, 0, 3).mapped([&](const Vec3& p) {
            return Vec3{p.x * factor, p.y * factor, p.z * factor};
          });
      for (std::uint64_t seed = 0; seed < 6; ++seed) QCOMPARE(checkSoup(soup, seed, 6), std::string());
    }
  }

  void randomSoups() {
    QVERIFY(test::check("triangles on a grid", 300, [] {
      const auto soup = test::soupOf(*test::gridTriangles(8, 5, 3));
      RC_ASSERT(checkSoup(soup, *rc::gen::arbitrary<std::uint64_t>(), 6) == "");
    }));
    QVERIFY(test::check("buildings", 120, [] {
      const auto soup = test::buildingOf(*test::buildingParts(6));
      RC_ASSERT(checkSoup(soup, *rc::gen::arbitrary<std::uint64_t>(), 8) == "");
    }));
    QVERIFY(test::check("walks", 80, [] {
      const auto soup = test::walkOf(*test::upTo(10, test::below(16)));
      RC_ASSERT(checkSoup(soup, *rc::gen::arbitrary<std::uint64_t>(), 10) == "");
    }));
    QVERIFY(test::check("decimals", 120, [] {
      const auto soup = scaled(test::soupOf(*test::gridTriangles(8, 7, 3)), 0.1, *test::below(2) == 0 ? 0 : 122000.123);
      RC_ASSERT(checkSoup(soup, *rc::gen::arbitrary<std::uint64_t>(), 8) == "");
    }));
    QVERIFY(test::check("many cells", 20, [] {
      const auto soup = test::soupOf(*test::gridTriangles(6, 9, 3));
      RC_ASSERT(checkSoup(soup, *rc::gen::arbitrary<std::uint64_t>(), 60) == "");
    }));
  }

  void threads() {
    Random random(test::seed());
    test::Soup soup;
    for (int i = 0; i < 6000; ++i) {
      const auto at = [&] { return integer(random, 0, 400) / 4.0; };
      const double x = at(), y = at(), z = integer(random, 0, 3);
      soup.triangle({x, y, z}, {x + 3, y + integer(random, 0, 1), z + 1}, {x + integer(random, 0, 2), y + 2, z});
    }
    const SourceMesh mesh = meshOf(soup);
    const Partition partition = randomPartition(random, mesh, 40);
    CutEnvironment one, four;
    runWithThreads(1, [&] { one = cutEnvironment(mesh, partition, {}, false); });
    runWithThreads(4, [&] { four = cutEnvironment(mesh, partition, {}, false); });
    QVERIFY(one.triangles.size() > mesh.triangles.size());
    QVERIFY(one.vertices == four.vertices);
    QVERIFY(one.triangles == four.triangles);
    QCOMPARE(Check(mesh, partition, one).run({}), std::string());
  }

  void realEnvironments() {
    if (test::sharedEnvironments().isEmpty()) QSKIP("the shared environments are not here; set FOOTFALL_SHARED");
    for (const char* name : {"/nav_test.obj", "/dutility.obj"}) {
      const auto environment = importEnvironment(test::sharedEnvironments().toStdString() + name);
      const SourceMesh mesh = makeSourceMesh(SoupView(environment->vertices, environment->triangles), false);
      std::vector<char> walkable(mesh.triangles.size()), removed(mesh.triangles.size(), 0);
      for (std::size_t t = 0; t < walkable.size(); ++t) walkable[t] = static_cast<char>(mesh.facing[t] > 0);
      for (const auto& [strategy, values] :
           {std::pair{FilterType::RecursiveStrategy, std::vector<double>{500, 4, 0}},
            std::pair{FilterType::HeightAwareStrategy, std::vector<double>{500, 4, 0}}}) {
        const Partition partition = makePartition(strategy, values, {mesh, walkable, removed, 2, 2});
        QVERIFY(partition.cells.size() > 1);
        const CutEnvironment cut = cutEnvironment(mesh, partition, {}, false);
        QVERIFY(cut.triangles.size() >= mesh.triangles.size());
        const std::string wrong = Check(mesh, partition, cut).run({});
        QVERIFY2(wrong.empty(),
                 (std::string(name) + ' ' + std::string(filterDescriptor(strategy).name) + ": " + wrong).c_str());
      }
    }
  }

  void cancels() {
    const SourceMesh mesh = meshOf(test::Soup().floor(0, 0, 4, 4, 0));
    QVERIFY_THROWS_EXCEPTION(int, cutEnvironment(mesh, Cells().partition(), {}, false, [] { throw 1; }));
  }
};

QTEST_APPLESS_MAIN(TestRandomCuts)
#include "test_random_cuts.moc"
