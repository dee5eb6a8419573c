// Edits compute only what they can affect, and give what a run from nothing gives, to the last byte.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/io/import.hpp"
#include "core/pipeline/cell_reuse.hpp"
#include "footfall/edit.hpp"
#include "footfall/errors.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

std::string sample(const std::string& name) {
  return std::string(FOOTFALL_SOURCE_DIR) + "/samples/" + name + "/" + name + ".obj";
}

}  // namespace

class TestLiveEdits : public QObject {
  Q_OBJECT

 private slots:
  // Random buildings in which random parts come, move and go, under random pipelines.
  void obstaclesInRandomBuildings() {
    QVERIFY(check("obstacles in random buildings", 300, [] {
      const auto level = buildingOf(*buildingParts(12)).environment(*below(4) == 0);
      const std::array<std::string, 9> pipelines{
          "SlopeFilter 45\nVerticalClearanceFilter 2\n",
          defaultFilters(45, 1),
          "VerticalClearanceFilter 1\nVerticalClearanceFilter 2\nRoundingFilter\nSlopeFilter 30\n",
          "SlopeFilter 60\nAreaFilter 1\nVerticalClearanceFilter 1.5\nLayerSubdivisionFilter\n",
          "VerticalClearanceFilter 1\nLayerSubdivisionFilter\nSimplificationFilter\nLayerSubdivisionFilter\n",
          "SimplificationFilter\nVerticalClearanceFilter 1\nSimplificationFilter true 0.01\nLayerSubdivisionFilter\n",
          "GridStrategy 2 3\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter\n",
          "SlopeFilter 50\nHeightAwareStrategy 1 4\nVerticalClearanceFilter 1\nCollapse\nLayerSubdivisionFilter\n",
          "SortedRecursiveStrategy 1 4 false\nDegeneracyFilter\nVerticalClearanceFilter 1\nRoundingFilter\nCollapse\n"};
      const std::string pipeline = pipelines[static_cast<std::size_t>(*below(static_cast<int>(pipelines.size())))];
      EditableEnvironment editable(level);
      ResultCache cache;
      RC_ASSERT(agrees(level, pipeline, cache));
      std::vector<ObstacleId> obstacles;
      for (int i = 0; i < 5; ++i) {
        const TriangleSoup soup = soupFor(buildingOf(*buildingParts(2)));
        const int choice = *below(4);
        if (obstacles.empty() || choice < 2)
          obstacles.push_back(editable.add(soup));
        else if (choice == 2)
          editable.replace(obstacles.back(), soup);
        else {
          editable.remove(obstacles.back());
          obstacles.pop_back();
        }
        RC_ASSERT(agrees(editable.environment(), pipeline, cache));
      }
    }));
  }

  // Many obstacles lie above one another over floors. Floors count as covered without testing all obstacles above them,
  // and become open when an obstacle is removed.
  void obstaclesInCrowds() {
    for (const std::string pipeline : {"SlopeFilter 45\nVerticalClearanceFilter 2\n",
                                       "VerticalClearanceFilter 1\nVerticalClearanceFilter 2\nRoundingFilter\n",
                                       "GridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"}) {
      std::mt19937 random(1);
      const auto number = [&](int end) { return static_cast<double>(random() % static_cast<unsigned>(end)); };
      Soup soup;
      soup.floor(0, 0, 16, 16, 0).box({30, 30, 0}, {31, 31, 4});
      for (int i = 0; i < 60; ++i) {
        const auto corner = [&] {
          const double x = number(17), y = number(17), z = number(4);
          return Vec3{x, y, z};
        };
        const Vec3 a = corner(), b = corner(), c = corner();
        soup.triangle(a, b, c);
      }
      EditableEnvironment editable(soup.environment());
      ResultCache cache;
      QVERIFY(agrees(editable.environment(), pipeline, cache));
      // A roof in two layers of large plates, of which one comes and goes.
      Soup roof, plate;
      for (int depth = 0; depth < 14; ++depth)
        for (int x = -1; x < 16; x += 6)
          for (int y = -1; y < 16; y += 6)
            if (x != 5 || y != 5) roof.floor(x - 0.4, y, x + 7 + depth / 16.0, y + 7, 0.25 + depth / 1024.0);
      plate.floor(4.5, 4.5, 12, 12, 0.5).floor(4, 4, 12, 12.5, 0.625);
      std::vector<ObstacleId> obstacles{editable.add(soupFor(roof)), editable.add(soupFor(plate))};
      QVERIFY(agrees(editable.environment(), pipeline, cache));
      editable.remove(obstacles.back());
      QVERIFY(agrees(editable.environment(), pipeline, cache));
      obstacles.back() = editable.add(soupFor(plate));
      QVERIFY(agrees(editable.environment(), pipeline, cache));
      for (int i = 0; i < 4; ++i) {
        const double x = number(15), y = number(15);
        editable.replace(obstacles.back(), soupFor(Soup().box({x, y, 0}, {x + 1.5, y + 1, 1.25})));
        QVERIFY(agrees(editable.environment(), pipeline, cache));
      }
      editable.remove(obstacles.front());
      QVERIFY(agrees(editable.environment(), pipeline, cache));
    }
  }

  // Floors side by side in cells of their own: only the cell of an obstacle is computed again.
  void cellsThatAnEditLeavesAloneAreReused() {
    Soup soup;
    for (int i = 0; i < 8; ++i) soup.floor(4 * i, 0, 4 * i + 3, 3, 0).box({4.0 * i + 1, 1, 0}, {4.0 * i + 2, 2, 1});
    EditableEnvironment editable(soup.environment());
    const Pipeline pipeline = parsePipeline("GridStrategy 8 1\nVerticalClearanceFilter 2\nCollapse\n", "test");
    ResultCache cache;
    const auto reuse = [&] {
      RunContext context;
      runPipeline(editable.environment(), pipeline, context, &cache);
      return cellReuse(editable.environment(), pipeline, cache);
    };
    const std::vector<std::vector<CellReuse>> first = reuse();
    QCOMPARE(first.size(), std::size_t{1});
    QVERIFY(first[0].size() > 4);
    for (const CellReuse& cell : first[0]) QCOMPARE(cell.reused, std::uint64_t{0});
    editable.add(soupFor(Soup().box({0.25, 0.25, 0}, {0.75, 0.75, 1})));
    const std::vector<std::vector<CellReuse>> second = reuse();
    QCOMPARE(second[0].size(), first[0].size());
    std::size_t all = 0, some = 0;
    for (const CellReuse& cell : second[0]) {
      all += cell.all() ? 1 : 0;
      some += !cell.all() && cell.floors > 0 ? 1 : 0;
    }
    QVERIFY(some >= 1);
    QCOMPARE(all + some, second[0].size());
    QVERIFY(all + 2 >= second[0].size());
    // The whole block comes from the cache: the same as in the run that computed it.
    QCOMPARE(reuse()[0].front().reused, second[0].front().reused);
    cache.clear();
    QVERIFY(cellReuse(editable.environment(), pipeline, cache)[0].empty());
  }

  // The same among triangles that are mostly degenerate.
  void obstaclesInRandomSoups() {
    QVERIFY(check("obstacles in random soups", 200, [] {
      const auto level = soupOf(*gridTriangles(20, 4, 3)).environment();
      EditableEnvironment editable(level);
      ResultCache cache;
      RC_ASSERT(agrees(level, defaultFilters(60, 1), cache));
      const ObstacleId obstacle = editable.add(soupFor(soupOf(*gridTriangles(4, 4, 3))));
      RC_ASSERT(agrees(editable.environment(), defaultFilters(60, 1), cache));
      editable.replace(obstacle, soupFor(soupOf(*gridTriangles(4, 5, 4))));
      RC_ASSERT(agrees(editable.environment(), defaultFilters(60, 1), cache));
      editable.remove(obstacle);
      RC_ASSERT(agrees(editable.environment(), defaultFilters(60, 1), cache));
    }));
  }

  // Sliders: only what a parameter affects is computed again.
  void parametersInRandomBuildings() {
    QVERIFY(check("parameters in random buildings", 300, [] {
      const auto level = buildingOf(*buildingParts(14)).environment();
      ResultCache cache;
      double slope = 45, clearance = 1;
      for (int i = 0; i < 6; ++i) {
        RC_ASSERT(agrees(level, defaultFilters(slope, clearance), cache));
        if (*below(2) == 0)
          slope = std::array<double, 4>{10, 30, 45, 70}[static_cast<std::size_t>(*below(4))];
        else
          clearance = 0.5 + 0.5 * *below(6);
      }
    }));
  }

  // The first of two floors in one plane stays, while it is a floor: the cuts of the other depend on it.
  void floorsInOnePlane() {
    const auto level = Soup().floor(1, 1, 2, 2, 0).floor(0, 0, 4, 4, 0).floor(0, 0, 4, 1.5, 0).environment();
    ResultCache cache;
    for (const char* smallest : {"0.5", "2", "7", "0.5", "7"})
      QVERIFY(agrees(level, std::string("AreaFilter ") + smallest + "\nVerticalClearanceFilter 1\n", cache));
  }

  // No triangle of a floor changes, but one of its vertices has to stay, because the new triangle touches the floor
  // there.
  void floorTouchedAtOnePoint() {
    const std::string pipeline = "VerticalClearanceFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n";
    EditableEnvironment editable(Soup()
                                     .triangle({0, 0, 0}, {4, 0, 0}, {2, 4, 0})
                                     .triangle({0, 0, 0}, {2, 4, 0}, {0, 4, 0})
                                     .triangle({4, 0, 0}, {4, 4, 0}, {2, 4, 0})
                                     .environment());
    ResultCache cache;
    QVERIFY(agrees(editable.environment(), pipeline, cache));
    const ObstacleId id = editable.add(soupFor(Soup().triangle({2, 4, 0}, {3, 6, 0}, {1, 6, 0})));
    QVERIFY(agrees(editable.environment(), pipeline, cache));
    QCOMPARE(run(editable.environment(), pipeline, &cache).mesh->triangles.size(), std::size_t{4});
    editable.remove(id);
    QVERIFY(agrees(editable.environment(), pipeline, cache));
  }

  // No triangle of a floor changes, and all of them are still one region, but two of them are no longer joined: a ramp
  // meets their edge, which would be flipped otherwise.
  void rampAtAnEdgeOfARing() {
    const Vec3 a{0, 0, 0}, b{8, 0, 0}, c{4, 2, 0}, d{2, 2, 0}, e{8, 8, 0}, f{4, 4, 0}, g{0, 8, 0}, h{2, 4, 0};
    const std::string pipeline = "SlopeFilter 60\nSimplificationFilter\n";
    EditableEnvironment editable(Soup()
                                     .triangle(a, b, d)
                                     .triangle(b, c, d)
                                     .triangle(b, e, f)
                                     .triangle(b, f, c)
                                     .triangle(e, g, h)
                                     .triangle(e, h, f)
                                     .triangle(g, a, d)
                                     .triangle(g, d, h)
                                     .environment());
    ResultCache cache;
    QVERIFY(agrees(editable.environment(), pipeline, cache));
    const ObstacleId id = editable.add(soupFor(Soup().triangle(b, d, {2, -2, -1})));
    QVERIFY(agrees(editable.environment(), pipeline, cache));
    editable.remove(id);
    QVERIFY(agrees(editable.environment(), pipeline, cache));
  }

  void parametersAndObstaclesInSamples_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"house", "tower", "arena"}) QTest::newRow(name) << name;
  }
  void parametersAndObstaclesInSamples() {
    QFETCH(QString, name);
    const auto level = importEnvironment(sample(name.toStdString()));
    ResultCache cache;
    QVERIFY(agrees(level, defaultFilters(45, 2), cache));
    QVERIFY(agrees(level, defaultFilters(45, 2.1), cache));
    QVERIFY(agrees(level, defaultFilters(40, 2.1), cache));
    EditableEnvironment editable(level);
    const Vec3 corner = level->vertices[level->vertices.size() / 2];
    const auto crate = [&](double x, double z) {
      return soupFor(Soup().box({corner.x + x, corner.y - 0.25, corner.z + z},
                                {corner.x + x + 1.5, corner.y + 1, corner.z + z + 1}));
    };
    const ObstacleId id = editable.add(crate(0, 0));
    QVERIFY(agrees(editable.environment(), defaultFilters(40, 2.1), cache));
    for (int i = 1; i <= 4; ++i) {
      editable.replace(id, crate(i * 0.375, i * -0.125));
      QVERIFY(agrees(editable.environment(), defaultFilters(40, 2.1), cache));
    }
    editable.remove(id);
    QVERIFY(agrees(editable.environment(), defaultFilters(40, 2.1), cache));
    QCOMPARE(editable.environment()->vertices.size(), level->vertices.size());
  }

  // Slits between slanting floors get vertices at places of the plan that no file has. Their numbers change when a
  // crate brings or takes such places; layers, simplification and rounding know them again.
  void cratesAmongSlits() {
    QVERIFY(check("crates among slits", 40, [] {
      Soup soup;
      for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y) {
          const double left = 2 * x, front = 2 * y, turn = *below(3) / 64.0, z = *below(3) / 8.0;
          soup.quad({left, front, z}, {left + 1.96875, front + turn, z}, {left + 1.96875 - turn, front + 1.96875, z},
                    {left, front + 1.96875 - turn, z});
        }
      soup.floor(1, 1, 6, 6, 3);
      const bool hasRadius = *below(4) == 0;
      const std::string pipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\n" +
                                   std::string(hasRadius ? "RadiusFilter 0.25\n" : "") +
                                   "AreaFilter 0.1\nSimplificationFilter\nLayerSubdivisionFilter\nRoundingFilter\n";
      EditableEnvironment editable(soup.environment());
      ResultCache cache;
      RC_ASSERT(agrees(editable.environment(), pipeline, cache));
      std::optional<ObstacleId> crate;
      for (int i = 0; i < 5; ++i) {
        const double x = *below(60) / 8.0, y = *below(60) / 8.0, width = 0.25 + *below(8) / 8.0;
        const TriangleSoup box = soupFor(Soup().box({x, y, 0}, {x + width, y + 0.5, 1}));
        if (crate)
          editable.replace(*crate, box);
        else
          crate = editable.add(box);
        RC_ASSERT(agrees(editable.environment(), pipeline, cache));
      }
      editable.remove(*crate);
      RC_ASSERT(agrees(editable.environment(), pipeline, cache));
    }));
  }

  // Each run of a RadiusFilter makes a generation of its own. What the filters behind it copy from the one before does
  // not show.
  void cratesBehindARadius() {
    const auto level = importEnvironment(sample("arena"));
    const std::string pipeline =
        "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nRadiusFilter 0.3\n"
        "AreaFilter 2\nSimplificationFilter\nLayerSubdivisionFilter\n";
    ResultCache cache;
    const RunResult first = run(level, pipeline, &cache);
    EditableEnvironment editable(level);
    std::mt19937 random(21);
    std::optional<ObstacleId> crate;
    for (int i = 0; i < 4; ++i) {
      const Triangle& floor = first.mesh->triangles[random() % first.mesh->triangles.size()];
      const Vec3 foot = first.mesh->vertices[floor[0]];
      for (const double move : {0.0, 0.5}) {
        const TriangleSoup box = soupFor(
            Soup().box({foot.x + move - 0.4, foot.y - 0.4, foot.z}, {foot.x + move + 0.4, foot.y + 0.4, foot.z + 1}));
        if (crate)
          editable.replace(*crate, box);
        else
          crate = editable.add(box);
        QVERIFY(agrees(editable.environment(), pipeline, cache));
      }
    }
  }

  // The tree of a level that is turned follows its edges. That of an edit follows those of the level before, and so
  // finds other triangles beside those that a query needs. Drops and ledges do not depend on it.
  void turnedCratesOnALevelAlongTheAxes() {
    QVERIFY(check("turned crates on a level along the axes", 4, [] {
      const auto jitter = [] { return *below(2000) * 1e-10; };
      const double x = 0.8572, y = 0.5150;  // about 31 degrees
      const auto turned = [&](const Vec3& p) {
        return Vec3{x * p.x - y * p.y + jitter(), y * p.x + x * p.y + jitter(), p.z + 0.0017 * p.x + jitter()};
      };
      Soup crates;
      for (int i = 0; i < 24; ++i) {
        const double left = *below(40) / 4.0, front = *below(40) / 4.0, width = 0.5 + *below(8) / 4.0;
        const Soup crate = Soup().box({left, front, -0.5}, {left + width, front + 1, 0.25 + *below(8) / 4.0});
        crates.add(crate.mapped(turned));
      }
      EditableEnvironment editable(Soup().floor(-10, -10, 20, 20, 0).environment());
      const std::string pipeline =
          "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.2\nRadiusFilter 0.1 0.05\nDropFilter 1.5 0.5\n";
      ResultCache cache;
      RC_ASSERT(agrees(editable.environment(), pipeline, cache));
      const ObstacleId id = editable.add(soupFor(crates));
      RC_ASSERT(agrees(editable.environment(), pipeline, cache));
      editable.remove(id);
      RC_ASSERT(agrees(editable.environment(), pipeline, cache));
    }));
  }

  // An obstacle that reaches farther than the level changes the scale of the grid: everything is computed again.
  void obstacleBeyondTheLevel() {
    const auto level = Soup().floor(0, 0, 4, 4, 0).environment();
    EditableEnvironment editable(level);
    ResultCache cache;
    QVERIFY(agrees(level, defaultFilters(45, 2), cache));
    const ObstacleId id = editable.add(soupFor(Soup().box({1, 1, 0.5}, {1000, 2, 1e6})));
    QVERIFY(agrees(editable.environment(), defaultFilters(45, 2), cache));
    editable.replace(id, soupFor(Soup().box({1, 1, 1e-12}, {2, 2, 1})));
    QVERIFY(agrees(editable.environment(), defaultFilters(45, 2), cache));
  }

  // A finer coordinate far away changes what doubles are worth for small floors.
  void obstacleOnAFinerGrid() {
    std::mt19937_64 random(3);
    const auto below = [&](int count) { return static_cast<double>(random() % static_cast<unsigned>(count)); };
    const auto corner = [&](int storey) {
      constexpr int kSize = 1 << 27;
      const double x = below(kSize), y = below(kSize), z = storey * kSize + below(kSize / 4);
      return Vec3{x * 0x1p-72, y * 0x1p-72, z * 0x1p-72};
    };
    for (int round = 0; round < 20; ++round) {
      Soup soup = Soup().triangle({0.5, 0, 0}, {0.75, 0, 0}, {0.5, 0, 0.5});
      for (int i = 0; i < 24; ++i) {
        const Vec3 a = corner(i % 2), b = corner(i % 2), c = corner(i % 2);
        soup.triangle(a, b, c);
      }
      const auto level = soup.environment();
      ResultCache cache;
      QVERIFY(agrees(level, "VerticalClearanceFilter 0.001\n", cache));
      const Soup fine = Soup().triangle({0.625, 0.5, 0x1p-80}, {0.75, 0.5, 0}, {0.625, 0.5, 0.25});
      const auto edited = editEnvironment(level, {}, soupFor(fine));
      QVERIFY(agrees(edited, "VerticalClearanceFilter 0.001\n", cache));
    }
  }

  // The environment that an edit was made of may be gone by the time of the run.
  void baseIsGone() {
    ResultCache cache;
    auto level = Soup().floor(0, 0, 4, 4, 0).environment();
    auto edited = editEnvironment(level, {}, soupFor(Soup().box({1, 1, 0}, {2, 2, 1})));
    level.reset();
    QVERIFY(agrees(edited, defaultFilters(45, 2), cache));
  }

  void wrongObstaclesChangeNothing() {
    EditableEnvironment editable(Soup().floor(0, 0, 4, 4, 0).environment());
    const ObstacleId id = editable.add(soupFor(Soup().box({1, 1, 0}, {2, 2, 1})));
    const auto before = editable.environment();
    TriangleSoup outOfRange = soupFor(Soup().floor(0, 0, 1, 1, 1));
    outOfRange.triangles[0][1] = 99;
    QVERIFY_EXCEPTION_THROWN(editable.add(outOfRange), InputError);
    TriangleSoup infinite = soupFor(Soup().floor(0, 0, 1, 1, 1));
    infinite.vertices[0].z = std::numeric_limits<double>::infinity();
    QVERIFY_EXCEPTION_THROWN(editable.replace(id, infinite), InputError);
    QVERIFY_EXCEPTION_THROWN(editable.remove(id + 1), InputError);
    QVERIFY_EXCEPTION_THROWN(editEnvironment(before, {9999}, {}), InputError);
    QCOMPARE(editable.environment(), before);
    editable.remove(id);
    QCOMPARE(editable.environment()->triangles.size(), std::size_t{2});
  }
};

QTEST_GUILESS_MAIN(TestLiveEdits)
#include "test_live_edits.moc"
