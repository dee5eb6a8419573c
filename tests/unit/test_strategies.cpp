// Strategies: cells tile the plan, cuts lie where the thesis puts them, and floors are listed where they have area.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>

#include <QtTest>
#include <cmath>
#include <limits>
#include <random>

#include "core/errors.hpp"
#include "core/partitioning/strategies.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using test::Soup;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An environment as strategies see it; what faces up is a floor.
struct Case {
  SourceMesh mesh;
  std::vector<char> walkable, removed;
  double clearance = 2;
  int threads = 4;

  explicit Case(const Environment& environment)
      : mesh(makeSourceMesh(SourceSoupView(environment.vertices, environment.triangles), false)),
        walkable(mesh.triangles.size()),
        removed(mesh.triangles.size(), 0) {
    for (std::size_t t = 0; t < walkable.size(); ++t) walkable[t] = static_cast<char>(mesh.facing[t] > 0);
  }
  explicit Case(const Soup& soup) : Case(*soup.environment()) {}

  [[nodiscard]] StrategyInput input() const { return {mesh, walkable, removed, clearance, threads}; }
  [[nodiscard]] Partition partition(std::string_view strategy, const std::vector<double>& values) const {
    return makePartition(strategy, values, input());
  }
};

bool isInside(const CellBounds& bounds, double x, double y, double z) {
  return bounds.lower[0] <= x && x < bounds.upper[0] && bounds.lower[1] <= y && y < bounds.upper[1] &&
         bounds.lower[2] <= z && z < bounds.upper[2];
}

// What must hold for any partition.
bool isSound(const Partition& partition) {
  if (partition.cells.empty() || partition.nodes.size() + 1 != partition.cells.size()) return false;
  std::array<std::vector<double>, 3> at;  // every coordinate, and places beside it
  for (int axis = 0; axis < 2; ++axis) {
    const auto& borders = partition.borders[axis];
    if (std::adjacent_find(borders.begin(), borders.end(), std::greater_equal<>()) != borders.end()) return false;
  }
  for (const auto& node : partition.nodes) {
    if (!std::isfinite(node.coordinate)) return false;
    if (node.axis < 2 &&
        !std::binary_search(partition.borders[node.axis].begin(), partition.borders[node.axis].end(), node.coordinate))
      return false;
    at[node.axis].push_back(node.coordinate);
  }
  for (const Cell& cell : partition.cells)
    for (int axis = 0; axis < 3; ++axis) {
      const double lower = cell.bounds.lower[axis], upper = cell.bounds.upper[axis];
      if (!(lower < upper) || !std::isfinite(cell.cost) || cell.cost < 0) return false;
      if (axis == 2) continue;
      const Index below = cell.bounds.lowerBorder[axis], above = cell.bounds.upperBorder[axis];
      if (below < 0 ? lower != -kInfinity : partition.borders[axis][below] != lower) return false;
      if (above < 0 ? upper != kInfinity : partition.borders[axis][above] != upper) return false;
    }
  for (auto& places : at) {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (places.size() > 12) places.resize(12);
    for (const double place : std::vector<double>(places)) places.push_back(std::nextafter(place, -kInfinity));
    places.push_back(0);
  }
  // Every point lies in exactly one cell, and a box without width is shown to that one.
  for (const double x : at[0])
    for (const double y : at[1])
      for (const double z : at[2]) {
        std::vector<Index> holding, visited;
        for (std::size_t c = 0; c < partition.cells.size(); ++c)
          if (isInside(partition.cells[c].bounds, x, y, z)) holding.push_back(static_cast<Index>(c));
        partition.visitCells({x, y}, {x, y}, z, [&](Index cell) { visited.push_back(cell); });
        if (holding.size() != 1 || visited != holding) return false;
      }
  return true;
}

using Point = std::array<mpq_class, 2>;

// The area of a floor in a cell, times two, by cutting its outline at each side of the cell in rationals.
mpq_class areaIn(const SourceMesh& mesh, Index floor, const CellBounds& bounds) {
  std::vector<Point> outline;
  for (const Index v : mesh.triangles[floor])
    outline.push_back({mpq_class(mesh.vertices[v].x), mpq_class(mesh.vertices[v].y)});
  const auto cut = [&](int axis, double side, int keep) {
    if (std::isinf(side)) return;
    const mpq_class at(side);
    std::vector<Point> rest;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
      const mpq_class da = (a[axis] - at) * keep, db = (b[axis] - at) * keep;
      if (da >= 0) rest.push_back(a);
      if (sgn(da) * sgn(db) >= 0) continue;
      const mpq_class part = da / (da - db);
      rest.push_back({a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])});
    }
    outline = rest;
  };
  for (int axis = 0; axis < 2; ++axis) {
    cut(axis, bounds.lower[axis], 1);
    cut(axis, bounds.upper[axis], -1);
  }
  mpq_class area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

double lowestOf(const SourceMesh& mesh, Index triangle) {
  const auto& f = mesh.triangles[triangle];
  return std::min({mesh.vertices[f[0]].z, mesh.vertices[f[1]].z, mesh.vertices[f[2]].z});
}

// Every cell in which a floor has area lists it; what is listed without area is counted.
bool areFloorsListed(const Case& given, Partition partition, std::size_t* spare = nullptr) {
  const CellFloors listed = assignFloors(partition, given.input());
  const std::size_t triangles = given.mesh.triangles.size();
  std::vector<Index> counts(triangles, 0);
  if (listed.first.size() != partition.cells.size() + 1 || listed.cellCount.size() != triangles) return false;
  for (std::size_t c = 0; c < partition.cells.size(); ++c) {
    const std::vector<Index> floors(listed.floors.begin() + static_cast<std::ptrdiff_t>(listed.first[c]),
                                    listed.floors.begin() + static_cast<std::ptrdiff_t>(listed.first[c + 1]));
    if (!std::is_sorted(floors.begin(), floors.end(), std::less_equal<>())) return false;
    if (partition.cells[c].floors != floors.size()) return false;
    for (const Index floor : floors) ++counts[floor];
    const CellBounds& bounds = partition.cells[c].bounds;
    for (std::size_t t = 0; t < triangles; ++t) {
      if (given.walkable[t] == 0) continue;
      const auto floor = static_cast<Index>(t);
      const double z = lowestOf(given.mesh, floor);
      const bool hasArea = bounds.lower[2] <= z && z < bounds.upper[2] && areaIn(given.mesh, floor, bounds) > 0;
      const bool isListed = std::binary_search(floors.begin(), floors.end(), floor);
      if (hasArea && !isListed) return false;
      if (spare != nullptr && isListed && !hasArea) ++*spare;
    }
  }
  for (std::size_t t = 0; t < triangles; ++t)
    if (counts[t] != listed.cellCount[t] || (given.walkable[t] != 0) != (counts[t] > 0)) return false;
  return true;
}

}  // namespace

class TestStrategies : public QObject {
  Q_OBJECT

 private slots:
  // Figures 7 and 8 of the thesis: three columns, two rows.
  void gridCutsIntoEqualRectangles() {
    const Case given(Soup().floor(0, 0, 6, 4, 0));
    const Partition partition = given.partition("GridStrategy", {3, 2});
    QVERIFY((partition.borders[0] == std::vector<double>{2, 4}));
    QVERIFY((partition.borders[1] == std::vector<double>{2}));
    QCOMPARE(partition.cells.size(), std::size_t{6});
    QCOMPARE(partition.strategy, std::string("GridStrategy 3 2"));
    QVERIFY(isSound(partition));
    std::size_t spare = 0;
    QVERIFY(areFloorsListed(given, partition, &spare));
    QCOMPARE(spare, std::size_t{0});
  }

  void gridOfDegenerateEnvironments() {
    const Case nothing{Soup()};
    QCOMPARE(nothing.partition("GridStrategy", {7, 9}).cells.size(), std::size_t{1});
    const Case wall(Soup().wall(1, 0, 1, 4, 0, 3));
    const Partition cutWall = wall.partition("GridStrategy", {4, 4});
    QVERIFY(cutWall.borders[0].empty());
    QCOMPARE(cutWall.borders[1].size(), std::size_t{3});
    const double next = std::nextafter(1.0, 2.0);
    const Case narrow(Soup().floor(1, 0, std::nextafter(next, 2.0), 1, 0));
    QVERIFY((narrow.partition("GridStrategy", {1000, 1}).borders[0] == std::vector<double>{next}));
    const Case tiny(Soup().floor(0, 0, 5e-324, 1e-323, 0));
    QVERIFY(isSound(tiny.partition("GridStrategy", {50, 50})));
    for (const double size : {1e300, std::numeric_limits<double>::max()}) {
      const Case enormous(Soup().floor(-size, -size, size, size, 0));
      const Partition partition = enormous.partition("GridStrategy", {4, 3});
      QCOMPARE(partition.cells.size(), std::size_t{12});
      QVERIFY(isSound(partition));
      QVERIFY(areFloorsListed(enormous, partition));
    }
  }

  void tooManyCellsAreRefused() {
    const Case given(Soup().floor(0, 0, 6, 4, 0));
    for (const auto& values : {std::vector<double>{2147483647, 2147483647}, {65537, 1}, {1, 2147483647}, {257, 256}})
      QVERIFY_THROWS_EXCEPTION(InputError, given.partition("GridStrategy", values));
    QCOMPARE(given.partition("GridStrategy", {256, 256}).cells.size(), std::size_t{65536});
  }

  void removedTrianglesDoNotCount() {
    Case given(Soup().floor(0, 0, 4, 4, 0).floor(100, 100, 104, 104, 0));
    for (std::size_t t = 0; t < given.mesh.triangles.size(); ++t)
      given.removed[t] = given.walkable[t] = static_cast<char>(given.mesh.vertices[given.mesh.triangles[t][0]].x < 50);
    std::fill(given.walkable.begin(), given.walkable.end(), 0);
    QVERIFY((given.partition("GridStrategy", {2, 1}).borders[0] == std::vector<double>{102}));
  }

  // A diagonal leaves out the cells beside it, also those that its box holds.
  void floorsAreNotListedWhereTheyHaveNoArea() {
    const Case given(Soup().triangle({0, 0, 0}, {8, 7, 0}, {7, 8, 0}));
    Partition partition = given.partition("GridStrategy", {8, 8});
    std::size_t spare = 0;
    QVERIFY(areFloorsListed(given, partition, &spare));
    QCOMPARE(spare, std::size_t{0});
    const CellFloors listed = assignFloors(partition, given.input());
    QVERIFY(listed.cellCount[0] < 32);
  }

  void floorsOfRandomSoups() {
    QVERIFY(test::check("floors of a grid", 150, [] {
      const Case given(test::soupOf(*test::gridTriangles(20, 7, 4)));
      const Partition partition = given.partition("GridStrategy", {1.0 + *test::below(5), 1.0 + *test::below(5)});
      RC_ASSERT(isSound(partition));
      RC_ASSERT(areFloorsListed(given, partition));
    }));
  }
};

QTEST_APPLESS_MAIN(TestStrategies)
#include "test_strategies.moc"
