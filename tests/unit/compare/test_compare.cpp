// Comparing meshes: distances, components, steps, real products, and what must not matter.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/compare/compared_soups.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Steps on one of a few lines, by whole numbers along it: level, rising, and at an angle in the plan.
struct StepLine {
  Vec3 origin, direction;
  double rise, riseGrowth;
};
const std::array<StepLine, 6> kStepLines = {{{{0, 0, 0}, {0, 1, 0}, 0.5, 0},
                                             {{0, 0, 0}, {0, 1, 0}, 0.75, 0},
                                             {{0, 0, 0}, {0, 1, 0}, 0.5, 0.125},
                                             {{0, 0, 0}, {0, 1, 1}, 0.5, 0},
                                             {{5, 7, 1}, {3, -4, 0.5}, 0.25, 0},
                                             {{5, 7, 1}, {-3, 4, -0.5}, 0.25, 0}}};

void addStep(NavigationMesh& mesh, const StepLine& line, double from, double to, bool isTurned) {
  const auto add = [&](double t, bool isUpper) {
    const double z = line.origin.z + t * line.direction.z + (isUpper ? line.rise + t * line.riseGrowth : 0);
    mesh.vertices.push_back({line.origin.x + t * line.direction.x, line.origin.y + t * line.direction.y, z});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  };
  StepLink step{{add(from, false), add(to, false)}, {add(to, true), add(from, true)}, 0, 0, line.rise};
  if (isTurned) std::swap(step.from, step.to);
  mesh.links.push_back(step);
}

}  // namespace

class TestCompare : public QObject {
  Q_OBJECT
 private slots:
  void degenerateTrianglesAreNoPartOfASet();
  void emptyMeshes();
  void extremeCoordinates();
  void distancesOfKnownShapes();
  void hausdorffBoundsHold();
  void nearlyEqualSurfacesAreBoundedTightly();
  void componentsByIndex();
  void componentsOverSteps();
  void stepsAsSets();
  void sameBitsWithAnyNumberOfThreads();
  void wrongOptions();
  void cancelled();
  void ownProducts_data();
  void ownProducts();
  void approximateSimplification();
};

void TestCompare::degenerateTrianglesAreNoPartOfASet() {
  const Soup floor = Soup().floor(0, 0, 4, 4, 0);
  Soup more = floor;
  more.triangle({0, 0, 0}, {9, 9, 9}, {18, 18, 18}).triangle({1, 1, 1}, {1, 1, 1}, {5, 5, 1});
  const auto c = compare(floor, more);
  QVERIFY(isEqualInAll(c));
  QCOMPARE(c.meshes[1].whole.degenerate, std::size_t{2});
  QCOMPARE(c.meshes[1].whole.triangles, std::size_t{4});
}

void TestCompare::emptyMeshes() {
  const Soup floor = Soup().floor(0, 0, 4, 4, 0);
  const auto both = compare(Soup(), Soup());
  QVERIFY(both.equal() && !both.distances && both.covered() == 1 && !both.areaRatio());
  const auto one = compare(floor, Soup());
  QVERIFY(!one.equal() && !one.distances);
  QCOMPARE(one.sets.areas[0].surface, 16.0);
  QCOMPARE(one.covered(), 0.0);
  QCOMPARE(*one.areaRatio(), 0.0);
  QCOMPARE(compare(Soup(), floor).covered(), 1.0);
}

void TestCompare::extremeCoordinates() {
  for (const double unit : {0x1p-300, 0x1p300}) {
    const auto c = compare(Soup().floor(0, 0, 4 * unit, 4 * unit, 0), Soup().floor(0, 0, 3 * unit, 4 * unit, 0));
    QVERIFY(c.sets.hasArea[0] && !c.sets.hasArea[1]);
    QCOMPARE(c.sets.areas[0].surface, 4 * unit * unit);
    QVERIFY(isNear(c.distances->at(0).upper, unit, 0.01));
  }
  // Far apart and small: no digit is lost.
  Soup a = Soup().floor(0, 0, 0x1p-60, 0x1p-60, 0).floor(0x1p40, 0, 0x1p41, 1, 0), b = a;
  b.floor(0x1p-60, 0, 0x1.8p-60, 0x1p-60, 0);
  QCOMPARE(compare(a, b).sets.areas[1].surface, 0x1p-121);
}

void TestCompare::distancesOfKnownShapes() {
  const Soup floor = Soup().floor(0, 0, 4, 4, 0), above = Soup().floor(0, 0, 4, 4, 2);
  const auto parallel = compare(floor, above);
  for (const auto& d : *parallel.distances) {
    QCOMPARE(d.samples, std::size_t{4});
    QVERIFY(d.min == 2 && d.max == 2 && d.mean == 2 && d.rms == 2);
    QVERIFY(d.lower <= 2 && d.lower >= 1.999 && d.upper >= 2 && d.upper <= 2.01);
  }
  // A pyramid's tip.
  Soup pyramid;
  const std::array<Vec3, 4> corners = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  for (std::size_t k = 0; k < 4; ++k) pyramid.triangle(corners[k], corners[(k + 1) % 4], {2, 2, 3});
  const auto tip = compare(pyramid, floor).distances->at(0);
  QVERIFY(tip.min == 0 && tip.max == 3 && isNear(tip.mean, 0.6) && isNear(tip.rms, 3 / std::sqrt(5.0)));
  QVERIFY(tip.farthest == (Vec3{2, 2, 3}));
  // A hole that no vertex of A sees: its middle is 1 away from the rim.
  const Soup frame = Soup().floor(0, 0, 4, 1, 0).floor(0, 3, 4, 4, 0).floor(0, 1, 1, 3, 0).floor(3, 1, 4, 3, 0);
  const auto hole = compare(floor, frame, std::nullopt, 1e-3);
  QCOMPARE(hole.distances->at(0).max, 0.0);
  QVERIFY(hole.distances->at(0).lower <= 1 && hole.distances->at(0).upper >= 1);
  QVERIFY(hole.distances->at(0).upper - hole.distances->at(0).lower <= 1.001e-3);
  QVERIFY(hole.distances->at(0).boundReached);
  QCOMPARE(hole.distances->at(1).upper, 0.0);
}

void TestCompare::hausdorffBoundsHold() {
  QVERIFY(check("Hausdorff bounds", 60, [] {
    const Soup a = soupOf(*gridTriangles(4, 9, 5)), b = soupOf(*gridTriangles(5, 9, 5));
    const double error = 0.05;
    const auto c = compare(a, b, std::nullopt, error);
    if (!c.distances) return;
    // Distances of many points of A to many of B are off by at most the width of either net.
    constexpr int kNet = 40;
    const auto forNet = [](const Corners& t, const auto& visit) {
      for (int i = 0; i <= kNet; ++i)
        for (int j = 0; i + j <= kNet; ++j)
          visit(mix(mix(t[0], t[1], i == kNet ? 0 : double(j) / (kNet - i)), t[2], double(i) / kNet));
    };
    const auto hasArea = [](const Corners& t) {
      return compare(Soup().triangle(t[0], t[1], t[2]), Soup()).sets.hasArea[0];
    };
    std::vector<Vec3> net;
    for (const Corners& t : b.triangles())
      if (hasArea(t)) forNet(t, [&](const Vec3& p) { net.push_back(p); });
    double farthest = 0;
    for (const Corners& t : a.triangles()) {
      if (!hasArea(t)) continue;
      int number = 0;
      forNet(t, [&](const Vec3& p) {
        if (number++ % 7 != 0) return;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& q : net) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
        farthest = std::max(farthest, nearest);
      });
    }
    const double width = 2 * 12.1 / kNet;  // share of a triangle's longest side
    const auto& d = c.distances->at(0);
    RC_ASSERT(d.lower <= d.upper);
    RC_ASSERT(d.upper - d.lower <= error + 1e-9);
    RC_ASSERT(d.max <= d.upper);
    RC_ASSERT(farthest <= d.upper + width);
    RC_ASSERT(d.lower <= farthest + 3 * width);
  }));
}

void TestCompare::nearlyEqualSurfacesAreBoundedTightly() {
  // A slope that rounding bends, in two triangulations.
  Soup a, b;
  const auto point = [](int i, int j) { return Vec3{i / 3.0, j / 3.0, i / 7.0 + j / 11.0}; };
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) a.quad(point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
  }
  b.quad(point(0, 0), point(20, 0), point(20, 20), point(0, 20));
  const auto c = compare(a, b);
  QVERIFY(!c.equal());
  for (const std::size_t side : {0, 1}) {
    QVERIFY(c.meshes[side].whole.uncovered.plan < 1e-13);
    QVERIFY(c.distances->at(side).max < 1e-14);
    QVERIFY(c.distances->at(side).upper < 1e-5);
  }
}

void TestCompare::componentsByIndex() {
  NavigationMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  NavigationMesh apart = mesh;
  apart.triangles[1] = {4, 5, 6};
  apart.obstacleEdges = {{0, 2}};
  apart.connections = {{1, 2}};
  const auto c = compare(mesh, apart);
  QVERIFY(isEqualInAll(c));
  QCOMPARE(c.meshes[0].whole.components, std::size_t{1});
  QCOMPARE(c.meshes[1].whole.components, std::size_t{2});
  QCOMPARE(c.meshes[1].obstacleEdges, std::size_t{1});
  QVERIFY(isNear(c.meshes[1].obstacleEdgeLength, std::sqrt(2.0)));
  QCOMPARE(c.meshes[1].connectionLength, 1.0);
}

void TestCompare::componentsOverSteps() {
  Soup soup;
  for (int i = 0; i < 3; ++i) soup.floor(i, 0, i + 1, 2, 0.25 * i);
  // The upper tread lies over nothing else, but is given a layer of its own.
  NavigationMesh with = navigationMesh(
                     runFilters(soup.environment(), minimalPipeline(2) + "StepFilter 0.25\nLayerSubdivisionFilter")),
                 without = with;
  without.links.clear();
  const auto c = compare(with, without);
  QVERIFY(c.equal() && !c.hasEqualLinks());
  QCOMPARE(c.meshes[0].whole.components, std::size_t{1});
  QCOMPARE(c.meshes[1].whole.components, std::size_t{3});
  QCOMPARE(c.meshes[0].links, std::size_t{2});
  QCOMPARE(c.meshes[0].linkLength, 4.0);
  QCOMPARE(c.meshes[0].highestLink, 0.25);
  QCOMPARE(c.meshes[1].highestLink, 0.0);
  QVERIFY((c.links.hasLength == std::array<bool, 3>{true, false, false}));
  QVERIFY((c.links.lengths == std::array<double, 3>{4, 0, 0}));
  NavigationMesh parted = with;
  parted.layerCount = 2;
  for (std::size_t t = 0; t < parted.triangles.size(); ++t)
    parted.layers[t] = parted.vertices[parted.triangles[t][0]].z > 0.3 ? 1 : 0;
  const auto layers = compare(parted, with).meshes[0].layers;
  QCOMPARE(layers[0].components, std::size_t{1});
  QCOMPARE(layers[1].components, std::size_t{1});
}

// Pieces of a few lines, given in any order, cut anywhere and overlapping, against marks on each unit of each line.
void TestCompare::stepsAsSets() {
  QVERIFY(check("steps as sets", 150, [](unsigned seed) {
    std::mt19937 random(seed);
    std::array<NavigationMesh, 2> meshes = {meshOf(Soup().floor(0, 0, 1, 1, 0)), meshOf(Soup().floor(0, 0, 1, 1, 0))};
    constexpr int kUnits = 12;
    // The fifth and the sixth line are one, in both directions.
    std::array<std::array<std::array<bool, 2 * kUnits>, 5>, 2> marks{};
    for (const std::size_t side : {0, 1}) {
      const int pieces = static_cast<int>(random() % 9);
      for (int i = 0; i < pieces; ++i) {
        const std::size_t line = random() % 6;
        const int from = static_cast<int>(random() % (kUnits - 1)),
                  to = from + 1 + static_cast<int>(random() % (kUnits - from - 1));
        addStep(meshes[side], kStepLines[line], from, to, random() % 2 == 0);
        for (int unit = from; unit < to; ++unit)
          marks[side][std::min<std::size_t>(line, 4)][line == 5 ? kUnits - 1 - unit : kUnits + unit] = true;
      }
    }
    std::array<double, 3> expected{};
    for (std::size_t line = 0; line < 5; ++line)
      for (std::size_t unit = 0; unit < 2 * kUnits; ++unit) {
        const bool a = marks[0][line][unit], b = marks[1][line][unit];
        if (a || b) expected[a && b ? 2 : b ? 1 : 0] += line == 4 ? 5 : 1;
      }
    const LinkDifference found = compare(meshes[0], meshes[1]).links;
    for (std::size_t part = 0; part < 3; ++part) {
      RC_ASSERT(isNear(found.lengths[part], expected[part], 1e-14));
      RC_ASSERT(found.hasLength[part] == (expected[part] > 0));
    }
  }));
  // One unit in the last place is another step.
  NavigationMesh a = meshOf(Soup().floor(0, 0, 1, 1, 0)), b = a;
  addStep(a, kStepLines[0], 0, 1, false);
  addStep(b, {{0, 0, 0}, {0, 1, 0}, std::nextafter(0.5, 1.0), 0}, 0, 1, false);
  const LinkDifference other = compare(a, b).links;
  QVERIFY((other.hasLength == std::array<bool, 3>{true, true, false}));
}

void TestCompare::sameBitsWithAnyNumberOfThreads() {
  std::mt19937 random(5);
  Soup a, b;
  for (int i = 0; i < 120; ++i) {
    const auto corner = [&] { return Vec3{random() % 97 / 7.0, random() % 97 / 7.0, random() % 5 / 3.0}; };
    const Vec3 p = corner(), q = corner(), r = corner();
    a.triangle(p, q, r);
    b.triangle(p, q, i % 3 == 0 ? corner() : r);
  }
  const NavigationMesh meshA = meshOf(a), meshB = meshOf(b);
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 5}) {
    runWithThreads(threads, [&] {
      const auto c = compare(meshA, meshB, 0.1, 0.05);
      auto& numbers = results.emplace_back();
      for (const std::size_t k : {0, 1}) {
        const auto& d = c.distances->at(k);
        numbers.insert(numbers.end(),
                       {c.sets.areas[k].surface, c.meshes[k].whole.uncovered.plan, d.mean, d.rms, d.lower, d.upper});
      }
      numbers.push_back(c.sets.areas[2].surface);
    });
  }
  QVERIFY(results[0] == results[1]);
  QVERIFY(results[0] == results[2]);
}

void TestCompare::wrongOptions() {
  const Soup floor = Soup().floor(0, 0, 4, 4, 0);
  QVERIFY_EXCEPTION_THROWN(compare(floor, floor, -1), InputError);
  QVERIFY_EXCEPTION_THROWN(compare(floor, floor, std::nan("")), InputError);
  QVERIFY_EXCEPTION_THROWN(compare(floor, floor, 0, 0), InputError);
  QVERIFY_EXCEPTION_THROWN(compare(floor, floor, 0, std::numeric_limits<double>::infinity()), InputError);
}

void TestCompare::cancelled() {
  RunContext context;
  context.cancel();
  const NavigationMesh mesh = meshOf(Soup().floor(0, 0, 4, 4, 0));
  QVERIFY_EXCEPTION_THROWN(compareMeshes(mesh, mesh, {}, &context), Cancelled);
}

void TestCompare::ownProducts_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<double>("clearance");
  for (const char* sample : {"house", "villa"}) {
    QTest::newRow(sample) << QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(sample) << 2.0;
  }
  const QString shared = sharedEnvironments();
  QTest::newRow("nav_test") << (shared.isEmpty() ? QString() : shared + "/nav_test.obj") << 2.0;
  QTest::newRow("complex") << (shared.isEmpty() ? QString() : shared + "/complex.obj") << 40.0;
}

// The same walkable area, simplified or not: equal but for what rounding vertices to doubles moves.
void TestCompare::ownProducts() {
  QFETCH(QString, file);
  QFETCH(double, clearance);
  if (!QFile::exists(file)) QSKIP("there is no folder of real environments; set FOOTFALL_SHARED");
  const auto environment = importEnvironment(file.toStdString());
  const StatePtr walkable = runFilters(environment, minimalPipeline(clearance));
  const NavigationMesh plain = navigationMesh(walkable);
  const NavigationMesh simplified = navigationMesh(runFilters(walkable, "SimplificationFilter"));
  const NavigationMesh layered = navigationMesh(runFilters(walkable, "LayerSubdivisionFilter"));
  QVERIFY(simplified.triangles.size() < plain.triangles.size());
  QVERIFY(isEqualInAll(compare(plain, layered)));

  const auto c = compare(plain, simplified);
  for (const std::size_t side : {0, 1}) {
    const MeshPart& whole = c.meshes[side].whole;
    QVERIFY2(whole.uncovered.surface <= 1e-12 * whole.areas.surface,
             qPrintable(QString::number(whole.uncovered.surface)));
    QVERIFY(c.distances->at(side).max <= 1e-9);
    QVERIFY(c.distances->at(side).upper <= 1e-2);
  }
  QVERIFY(isNear(*c.areaRatio(), 1, 1e-11));
  QVERIFY(c.covered() > 1 - 1e-12);
}

// The thesis's case (5.5): what it did to coordinates, seen from the exact result.
void TestCompare::approximateSimplification() {
  const auto environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj");
  const StatePtr walkable = runFilters(environment, minimalPipeline(2));
  const double tolerance = 0.001;
  const auto c =
      compare(navigationMesh(walkable), navigationMesh(runFilters(walkable, "SimplificationFilter true 0.001")));
  Vec3 low = environment->vertices[0], high = low;
  for (const Vec3& v : environment->vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  const double diagonal = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
  QVERIFY(!c.equal() && c.covered() < 1 && c.covered() > 0.5);
  const auto& d = c.distances->at(0);
  QVERIFY(d.max > 0 && d.max <= 1.000001 * tolerance * diagonal);  // the bound that the filter promises
  QVERIFY(d.min == 0 && d.mean <= d.rms && d.rms <= d.max && d.max <= d.upper);
  QVERIFY(isNear(*c.areaRatio(), 1, 0.01));
}

QTEST_GUILESS_MAIN(TestCompare)
#include "test_compare.moc"
