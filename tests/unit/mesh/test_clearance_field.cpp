// The clearance field: against looking in all directions, exactly on small meshes and in doubles on large ones.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>

#include "core/mesh/clearance_field.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/clearance.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Random = std::mt19937_64;

NavigationMesh withSteps(const Soup& soup) {
  return navigationMesh(
      runFilters(soup.environment(), minimalPipeline(0.5, 60) + "\nStepFilter 0.4 0.3\nLayerSubdivisionFilter"));
}

/// Compares with the exact distances at places in the faces; returns how many.
int compareExactly(const NavigationMesh& mesh, const FieldOptions& options, Random& random, int places) {
  const ClearanceField field(mesh, options);
  const NavigationMesh bridged = withBridges(mesh);
  const SurfaceTopology topology = makeSurfaceTopology(bridged);
  reference::SeenBorder<mpq_class> seen(bridged, topology);
  const double tolerance = 0x1p-38 * field.surface().scale;
  int compared = 0;
  for (std::uint32_t t = 0; t < bridged.triangles.size(); ++t) {
    if (topology.components[t] == SurfaceTopology::kNone) continue;
    for (int i = 0; i < places; ++i) {
      const int u = 1 + static_cast<int>(random() % 14), v = 1 + static_cast<int>(random() % (15 - u));
      const auto p = seen.inside(t, mpq_class(u) / 16, mpq_class(v) / 16);
      const auto squared = seen.squaredDistance(t, p);
      const double expected = squared ? std::sqrt(squared->get_d()) : kInfinity;
      const double found = field.at(t, p.x.get_d(), p.y.get_d()).distance;
      const bool isRight = found == expected || (expected > options.bound ? found > options.bound - tolerance
                                                                          : std::fabs(found - expected) <= tolerance);
      if (!isRight)
        qWarning("triangle %u at %.17g %.17g: %.17g, must be %.17g", t, p.x.get_d(), p.y.get_d(), found, expected);
      RC_ASSERT(isRight);
      ++compared;
    }
  }
  return compared;
}

/// The same at places strewn evenly, in doubles.
void compareLarge(const QString& path) {
  const auto environment = importEnvironment(path.toStdString());
  RunContext context;
  const auto mesh = runPipeline(environment, defaultPipeline(*environment), context).mesh;
  const NavigationMesh bridged = withBridges(*mesh);
  const SurfaceTopology topology = makeSurfaceTopology(bridged);
  reference::SeenBorder<double> seen(bridged, topology);
  std::vector<double> sums;
  double sum = 0;
  for (const Triangle& t : bridged.triangles) {
    const Vec3 &a = bridged.vertices[t[0]], &b = bridged.vertices[t[1]], &c = bridged.vertices[t[2]];
    sums.push_back(sum += std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
  }
  for (const double metres : {0.3, 1.0, kInfinity}) {
    FieldOptions options;
    options.bound = metres / environment->metresPerUnit;
    const ClearanceField field(*mesh, options);
    Random random(seed());
    std::uniform_real_distribution<> share(0, 1);
    int compared = 0;
    for (int i = 0; i < rounds(20000); ++i) {
      const auto at = std::upper_bound(sums.begin(), sums.end(), share(random) * sum);
      const auto t = static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(at - sums.begin(), std::ssize(sums) - 1));
      double u = share(random), v = share(random);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      if (topology.components[t] == SurfaceTopology::kNone) continue;
      const auto p = seen.inside(t, u, v);
      const double expected = std::sqrt(seen.squaredDistance(t, p).value_or(kInfinity));
      const double found = field.at(t, p.x, p.y).distance;
      if (expected > options.bound && found > options.bound) continue;
      ++compared;
      QVERIFY2(std::fabs(found - expected) <= 1e-10 * field.surface().scale,
               qPrintable(QStringLiteral("%1 %2: %3, must be %4").arg(p.x).arg(p.y).arg(found).arg(expected)));
    }
    qInfo("%s, up to %g m: %d places", qPrintable(path), metres, compared);
    QVERIFY(compared > 0);
  }
}

bool areEqual(const ClearanceField& a, const ClearanceField& b) {
  if (a.surface().edges.size() != b.surface().edges.size()) return false;
  for (std::uint32_t e = 0; e < a.surface().edges.size(); ++e) {
    const auto first = a.windowsOf(e), second = b.windowsOf(e);
    if (first.size() != second.size()) return false;
    for (std::size_t i = 0; i < first.size(); ++i)
      if (first[i].lo != second[i].lo || first[i].hi != second[i].hi || first[i].feature != second[i].feature ||
          first[i].into != second[i].into || first[i].offset != second[i].offset || first[i].slope != second[i].slope)
        return false;
  }
  return true;
}

}  // namespace

class TestClearanceField : public QObject {
  Q_OBJECT

 private slots:
  void isExactOnBuildings();
  void isExactOnWalks();
  void isExactOnGrids();
  void isExactUpToABound();
  void isRightOnSamples_data();
  void isRightOnSamples();
  void isTheSameForAllThreads();
  void canBeCancelled();
  void takesAnyMesh();
};

void TestClearanceField::isExactOnBuildings() {
  QVERIFY(check("exact distances in buildings", 40, [] {
    Random random(*rc::gen::arbitrary<std::uint32_t>());
    compareExactly(withSteps(buildingOf(*buildingParts(10))), {}, random, 4);
  }));
}

void TestClearanceField::isExactOnWalks() {
  QVERIFY(check("exact distances on walks over themselves", 30, [] {
    Random random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *upTo<int>(40, below(64));
    compareExactly(withSteps(walkOf(steps)), {}, random, 3);
  }));
}

void TestClearanceField::isExactOnGrids() {
  QVERIFY(check("exact distances in triangles on a small grid", 40, [] {
    Random random(*rc::gen::arbitrary<std::uint32_t>());
    compareExactly(withSteps(soupOf(*gridTriangles(12, 5, 3))), {}, random, 4);
  }));
}

void TestClearanceField::isExactUpToABound() {
  QVERIFY(check("exact distances up to a bound", 30, [] {
    Random random(*rc::gen::arbitrary<std::uint32_t>());
    FieldOptions options;
    options.bound = 0.125 * (1 + *below(12));
    compareExactly(withSteps(buildingOf(*buildingParts(10))), options, random, 4);
  }));
}

void TestClearanceField::isRightOnSamples_data() {
  QTest::addColumn<QString>("path");
  for (const char* name : {"rooms", "house", "arena", "tower", "villa", "docks"})
    QTest::newRow(name) << QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name);
  const QString folder = sharedEnvironments();
  if (folder.isEmpty()) return;
  for (const char* name : {"nav_test", "complex", "dutility", "steelribs", "fortitude"})
    QTest::newRow(name) << QStringLiteral("%1/%2.obj").arg(folder, name);
}

void TestClearanceField::isRightOnSamples() {
  QFETCH(QString, path);
  if (!QFile::exists(path)) QSKIP("this environment is not here");
  compareLarge(path);
}

void TestClearanceField::isTheSameForAllThreads() {
  const auto environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj");
  RunContext context;
  const auto mesh = runPipeline(environment, defaultPipeline(*environment), context).mesh;
  std::unique_ptr<ClearanceField> one;
  runWithThreads(1, [&] { one = std::make_unique<ClearanceField>(*mesh); });
  for (const int threads : {2, 5}) runWithThreads(threads, [&] { QVERIFY(areEqual(*one, ClearanceField(*mesh))); });
}

void TestClearanceField::canBeCancelled() {
  const NavigationMesh mesh = withSteps(Soup().floor(0, 0, 9, 9, 0));
  RunContext context;
  context.cancel();
  QVERIFY_THROWS_EXCEPTION(Cancelled, ClearanceField(mesh, {}, context));
}

void TestClearanceField::takesAnyMesh() {
  QVERIFY(ClearanceField(NavigationMesh{}).surface().edges.empty());
  NavigationMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}};  // up, down, no area
  const ClearanceField field(mesh);
  QCOMPARE(field.at(0, 0.25, 0.125).distance, 0.125);
  QCOMPARE(field.at(1, 0.25, 0.125).distance, kInfinity);
}

QTEST_GUILESS_MAIN(TestClearanceField)
#include "test_clearance_field.moc"
