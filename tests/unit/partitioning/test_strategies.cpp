// Strategies: cells tile the plan, cuts lie where the thesis puts them, and floors are listed where they have area.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>

#include <QtTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "core/partitioning/strategies.hpp"
#include "footfall/errors.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using test::Soup;

namespace {

using Borders = std::array<std::vector<double>, 2>;

// Each strategy, with parameters that make several cells.
const std::vector<std::pair<FilterType, std::vector<double>>> kStrategies{
    {FilterType::GridStrategy, {3, 4}},
    {FilterType::RecursiveStrategy, {5, 3, 0}},
    {FilterType::SortedRecursiveStrategy, {5, 4, 1}},
    {FilterType::HeightAwareStrategy, {5, 4, 0}},
    {FilterType::AutoStrategy, {}}};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An environment as strategies see it; what faces up is a floor.
struct Case {
  SourceMesh mesh;
  std::vector<char> walkable, removed;
  double clearance = 2;
  int threads = 4;

  explicit Case(const Environment& environment)
      : mesh(makeSourceMesh(SoupView(environment.vertices, environment.triangles), false)),
        walkable(mesh.triangles.size()),
        removed(mesh.triangles.size(), 0) {
    for (std::size_t t = 0; t < walkable.size(); ++t) walkable[t] = static_cast<char>(mesh.facing[t] > 0);
  }
  explicit Case(const Soup& soup) : Case(*soup.environment()) {}

  [[nodiscard]] StrategyInput input() const { return {mesh, walkable, removed, clearance, threads}; }
  [[nodiscard]] Partition partition(FilterType strategy, const std::vector<double>& values) const {
    return makePartition(strategy, values, input());
  }
};

// Floors of all sizes on several heights, with walls and slabs among them.
Soup randomLevel(int triangles) {
  std::mt19937_64 random(7);
  const auto number = [&](int count) { return static_cast<double>(random() % static_cast<unsigned>(count)); };
  Soup soup = Soup().floor(0, 0, 64, 64, 0);
  while (soup.size() < static_cast<std::size_t>(triangles)) {
    const double x = number(600) / 10, y = number(600) / 10, z = number(40) / 4;
    const double width = 0.5 + number(8) * number(8) / 16, depth = 0.5 + number(8) * number(8) / 16;
    const double right = std::min(x + width, 64.0), back = std::min(y + depth, 64.0);
    if (random() % 3 == 0)
      soup.wall(x, y, right, back, z, z + 3);
    else if (random() % 3 == 0)
      soup.ramp(x, y, right, back, z, z + 1);
    else
      soup.floor(x, y, right, back, z);
  }
  return soup;
}

// The floor below everything.
bool isGround(const SourceMesh& mesh, Index triangle) {
  const Box box = boxOf(mesh, triangle);
  return box.upper[2] == 0 && box.upper[0] - box.lower[0] == 64;
}

bool isSame(const Partition& a, const Partition& b) {
  if (a.borders != b.borders || a.cells.size() != b.cells.size() || a.strategy != b.strategy || a.reason != b.reason)
    return false;
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const auto &n = a.nodes[i], &m = b.nodes[i];
    if (n.axis != m.axis || n.coordinate != m.coordinate || n.below != m.below || n.above != m.above) return false;
  }
  for (std::size_t c = 0; c < a.cells.size(); ++c) {
    const Cell &x = a.cells[c], &y = b.cells[c];
    if (x.bounds.lower != y.bounds.lower || x.bounds.upper != y.bounds.upper || x.cost != y.cost ||
        x.floors != y.floors || x.obstacles != y.obstacles)
      return false;
  }
  return true;
}

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
    const Partition partition = given.partition(FilterType::GridStrategy, {3, 2});
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
    QCOMPARE(nothing.partition(FilterType::GridStrategy, {7, 9}).cells.size(), std::size_t{1});
    const Case wall(Soup().wall(1, 0, 1, 4, 0, 3));
    const Partition cutWall = wall.partition(FilterType::GridStrategy, {4, 4});
    QVERIFY(cutWall.borders[0].empty());
    QCOMPARE(cutWall.borders[1].size(), std::size_t{3});
    const double next = std::nextafter(1.0, 2.0);
    const Case narrow(Soup().floor(1, 0, std::nextafter(next, 2.0), 1, 0));
    QVERIFY((narrow.partition(FilterType::GridStrategy, {1000, 1}).borders[0] == std::vector<double>{next}));
    const Case tiny(Soup().floor(0, 0, 5e-324, 1e-323, 0));
    QVERIFY(isSound(tiny.partition(FilterType::GridStrategy, {50, 50})));
    for (const double size : {1e300, std::numeric_limits<double>::max()}) {
      const Case enormous(Soup().floor(-size, -size, size, size, 0));
      const Partition partition = enormous.partition(FilterType::GridStrategy, {4, 3});
      QCOMPARE(partition.cells.size(), std::size_t{12});
      QVERIFY(isSound(partition));
      QVERIFY(areFloorsListed(enormous, partition));
    }
  }

  void tooManyCellsAreRefused() {
    const Case given(Soup().floor(0, 0, 6, 4, 0));
    for (const auto& values : {std::vector<double>{2147483647, 2147483647}, {65537, 1}, {1, 2147483647}, {257, 256}})
      QVERIFY_THROWS_EXCEPTION(InputError, given.partition(FilterType::GridStrategy, values));
    QCOMPARE(given.partition(FilterType::GridStrategy, {256, 256}).cells.size(), std::size_t{65536});
  }

  void removedTrianglesDoNotCount() {
    Case given(Soup().floor(0, 0, 4, 4, 0).floor(100, 100, 104, 104, 0));
    for (std::size_t t = 0; t < given.mesh.triangles.size(); ++t)
      given.removed[t] = given.walkable[t] = static_cast<char>(given.mesh.vertices[given.mesh.triangles[t][0]].x < 50);
    std::fill(given.walkable.begin(), given.walkable.end(), 0);
    QVERIFY((given.partition(FilterType::GridStrategy, {2, 1}).borders[0] == std::vector<double>{102}));
  }

  // A diagonal leaves out the cells beside it, also those that its box holds.
  void floorsAreNotListedWhereTheyHaveNoArea() {
    const Case given(Soup().triangle({0, 0, 0}, {8, 7, 0}, {7, 8, 0}));
    Partition partition = given.partition(FilterType::GridStrategy, {8, 8});
    std::size_t spare = 0;
    QVERIFY(areFloorsListed(given, partition, &spare));
    QCOMPARE(spare, std::size_t{0});
    const CellFloors listed = assignFloors(partition, given.input());
    QVERIFY(listed.cellCount[0] < 32);
  }

  // Figure 11: only the crowded quarter is cut again.
  void recursiveCutsCrowdedQuartersAgain() {
    Soup soup;
    soup.floor(0, 0, 1, 1, 0).floor(7, 0, 8, 1, 0).floor(0, 7, 1, 8, 0);
    for (const double x : {4.5, 6.5})
      for (const double y : {4.5, 6.5}) soup.floor(x, y, x + 1, y + 1, 0);
    soup.floor(7, 7, 8, 8, 0);
    const Case given(soup);
    const Partition partition = given.partition(FilterType::RecursiveStrategy, {4, 5, 1});
    QVERIFY((partition.borders == Borders{{{4, 6}, {4, 6}}}));
    QCOMPARE(partition.cells.size(), std::size_t{7});
    QCOMPARE(partition.strategy, std::string("RecursiveStrategy 4 5 true"));
    QVERIFY(isSound(partition));
    // Cells with no more triangles than the first parameter are not cut, and no cell more often than the second.
    QCOMPARE(given.partition(FilterType::RecursiveStrategy, {16, 5, 0}).cells.size(), std::size_t{1});
    QCOMPARE(given.partition(FilterType::RecursiveStrategy, {15, 5, 0}).cells.size(), std::size_t{4});
    QCOMPARE(given.partition(FilterType::RecursiveStrategy, {1, 1, 0}).cells.size(), std::size_t{4});
  }

  // Triangles are cut as the recursion goes on: one counts where it has a part, and not where only its box has.
  void recursiveCountsWhatCutsLeave() {
    const Case given(Soup().triangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0}).triangle({0, 0, 5}, {8, 0, 5}, {0, 8, 5}));
    QCOMPARE(given.partition(FilterType::RecursiveStrategy, {2, 2, 0}).cells.size(), std::size_t{1});
    const Partition partition = given.partition(FilterType::RecursiveStrategy, {1, 2, 0});
    QCOMPARE(partition.cells.size(), std::size_t{13});
    const auto isUncut = [](const Cell& cell) { return cell.bounds.lower[0] == 4 && cell.bounds.lower[1] == 4; };
    const auto cell = std::find_if(partition.cells.begin(), partition.cells.end(), isUncut);
    QVERIFY(cell != partition.cells.end());
    QVERIFY(cell->bounds.upper[0] == kInfinity && cell->bounds.upper[1] == kInfinity);
  }

  void recursiveStopsWhereDoublesEnd() {
    Soup stack;
    const double end = std::nextafter(std::nextafter(1.0, 2), 2);
    for (int i = 0; i < 9; ++i) stack.floor(1, 1, end, end, i);
    const Partition partition = Case(stack).partition(FilterType::RecursiveStrategy, {1, 32, 0});
    QCOMPARE(partition.cells.size(), std::size_t{4});
    Soup walls;
    for (int i = 0; i < 9; ++i) walls.wall(1, 0, 1, 8, i, i + 1);
    const Partition cutWalls = Case(walls).partition(FilterType::RecursiveStrategy, {1, 2, 0});
    QVERIFY((cutWalls.borders == Borders{{{}, {2, 4, 6}}}));
  }

  void recursionWithTooManyCellsIsRefused() {
    Soup soup;
    for (int i = 0; i < 3; ++i) soup.triangle({0, 0, double(i)}, {8, 0, double(i)}, {0, 7, double(i)});
    const Case given(soup);
    for (const FilterType strategy : {FilterType::RecursiveStrategy, FilterType::SortedRecursiveStrategy})
      QCOMPARE(given.partition(strategy, {8, 32, 0}).cells.size(), std::size_t{1});
    std::string message;
    try {
      QCOMPARE(given.partition(FilterType::RecursiveStrategy, {1, 32, 1}).cells.size(), std::size_t{0});
    } catch (const InputError& error) {
      message = error.what();
    }
    QCOMPARE(message, std::string("RecursiveStrategy 1 32 true would make more than 65536 cells; give a larger min "
                                  "or a smaller depth"));
  }

  // Figure 15: the cut is the largest coordinate of the triangle in the middle, which is below it.
  void sortedCutsAtTheMiddleTriangle() {
    const auto row = [](const std::vector<double>& ends) {
      Soup soup;
      for (std::size_t i = 0; i < ends.size(); ++i)
        soup.triangle({ends[i] - 0.5, double(i), 0}, {ends[i], double(i), 0}, {ends[i], i + 0.5, 0});
      return Case(soup);
    };
    const auto cut = [&](const std::vector<double>& ends) {
      return row(ends).partition(FilterType::SortedRecursiveStrategy, {1, 1, 0}).borders[0];
    };
    QVERIFY((cut({1, 2, 3, 4, 5, 6, 7, 8}) == std::vector<double>{5}));
    QVERIFY((cut({6, 1, 5, 3, 2, 7, 4}) == std::vector<double>{4}));
    // Figure 17: a group with the same end stays together below the cut.
    QVERIFY((cut({1, 2, 3, 3, 5, 6}) == std::vector<double>{3}));
    const Case group = row({1, 2, 3, 4, 4, 6});
    Partition partition = group.partition(FilterType::SortedRecursiveStrategy, {1, 1, 0});
    QVERIFY((partition.borders[0] == std::vector<double>{4}));
    assignFloors(partition, group.input());
    QCOMPARE(partition.cells[0].floors, std::uint64_t{5});
    QCOMPARE(partition.cells[1].floors, std::uint64_t{1});
    // Figure 16: all end at the same coordinate; any cut would leave one side empty, so there is none.
    QCOMPARE(row({4, 4, 4, 4, 4}).partition(FilterType::SortedRecursiveStrategy, {1, 8, 0}).cells.size(),
             std::size_t{1});
    QVERIFY(cut({1, 2, 3, 3}).empty());
    // The next cut is across the other axis.
    const Partition twice = row({1, 2, 3, 4, 5, 6, 7, 8}).partition(FilterType::SortedRecursiveStrategy, {2, 2, 0});
    QVERIFY((twice.borders == Borders{{{5}, {2.5, 6.5}}}));
    QCOMPARE(twice.cells.size(), std::size_t{4});
    QVERIFY(isSound(twice));
    QCOMPARE(row({1, 2, 3, 4}).partition(FilterType::SortedRecursiveStrategy, {4, 5, 0}).cells.size(), std::size_t{1});
  }

  void storeysAreCutApart() {
    Soup soup;
    for (int storey = 0; storey < 4; ++storey)
      for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y) soup.floor(x * 4, y * 4, x * 4 + 4, y * 4 + 4, storey * 3);
    const Case given(soup);
    Partition partition = given.partition(FilterType::HeightAwareStrategy, {1, 2, 0});
    QCOMPARE(partition.cells.size(), std::size_t{4});
    QVERIFY(partition.borders[0].empty() && partition.borders[1].empty());
    QVERIFY(isSound(partition));
    const CellFloors listed = assignFloors(partition, given.input());
    for (const Cell& cell : partition.cells) {
      QCOMPARE(cell.floors, std::uint64_t{128});
      QCOMPARE(cell.obstacles, std::uint64_t{128});  // the next storey is above the clearance
      QCOMPARE(cell.cost, 128.0);
    }
    QCOMPARE(listed.floors.size(), std::size_t{512});
  }

  // A single floor that carries everything is cut where its obstacles are.
  void giantFloorsAreCut() {
    Soup soup = Soup().floor(0, 0, 1000, 1000, 0);
    for (int x = 0; x < 20; ++x)
      for (int y = 0; y < 20; ++y) soup.wall(x * 4 + 10, y * 4 + 10, x * 4 + 12, y * 4 + 10, 0, 3);
    const Case given(soup);
    Partition partition = given.partition(FilterType::HeightAwareStrategy, {20, 3, 0});
    QCOMPARE(partition.cells.size(), std::size_t{8});
    QVERIFY(isSound(partition));
    double largest = 0, total = 0;
    for (const Cell& cell : partition.cells) largest = std::max(largest, cell.cost), total += cell.cost;
    QVERIFY(largest * 8 < total * 1.3);
    for (int axis = 0; axis < 2; ++axis)
      for (const double border : partition.borders[axis]) QVERIFY(border > 10 && border < 90);
    QVERIFY(areFloorsListed(given, partition));
    // Without a clearance every floor is the same work.
    Case plain(soup);
    plain.clearance = 0;
    const Partition flat = plain.partition(FilterType::HeightAwareStrategy, {20, 3, 0});
    QCOMPARE(flat.cells.size(), std::size_t{1});
    QCOMPARE(flat.cells[0].cost, 2.0);
  }

  // The estimate comes from a sample: against the obstacles above all floors, counted one by one.
  void cellsHaveAboutEqualWork() {
    for (const int triangles : {5000, 18000}) {
      Case given(randomLevel(triangles));
      int kept = 0;
      for (std::size_t t = 0; t < given.walkable.size(); ++t)
        if (given.walkable[t] != 0 && kept++ % (triangles / 1000) != 0 && !isGround(given.mesh, static_cast<Index>(t)))
          given.walkable[t] = 0;
      const Partition partition = given.partition(FilterType::HeightAwareStrategy, {50, 3, 0});
      QCOMPARE(partition.cells.size(), std::size_t{8});
      QVERIFY(isSound(partition));
      std::vector<double> work(8, 0);
      for (std::size_t t = 0; t < given.walkable.size(); ++t) {
        if (given.walkable[t] == 0) continue;
        Box box = boxOf(given.mesh, static_cast<Index>(t));
        const double z = box.lower[2];
        box.upper[2] += given.clearance;
        for (std::size_t o = 0; o < given.walkable.size(); ++o) {
          const Box other = boxOf(given.mesh, static_cast<Index>(o));
          std::array<double, 2> middle{};
          bool overlaps = o != t && other.upper[2] > z && other.lower[2] < box.upper[2];
          for (int axis = 0; axis < 2 && overlaps; ++axis) {
            const double low = std::max(box.lower[axis], other.lower[axis]);
            const double high = std::min(box.upper[axis], other.upper[axis]);
            overlaps = low < high;
            middle[axis] = (low + high) / 2;
          }
          if (overlaps) partition.visitCells(middle, middle, z, [&](Index cell) { ++work[cell]; });
        }
      }
      const double mean = std::accumulate(work.begin(), work.end(), 0.0) / 8;
      for (const double one : work)
        QVERIFY2(one > mean / 2 && one < mean * 1.6, qPrintable(QString("%1 of %2").arg(one).arg(mean)));
    }
  }

  // A slope of many steps is no house of many storeys.
  void hillsideIsCutInThePlan() {
    Soup hill, house;
    for (int x = 0; x < 64; ++x)
      for (int y = 0; y < 8; ++y) {
        hill.floor(x, y, x + 1, y + 1, x * 0.25);
        house.floor(x / 8, y, x / 8 + 1, y + 1, (x % 8) * 3);
      }
    const auto heights = [](const Soup& soup) {
      const Partition partition = Case(soup).partition(FilterType::HeightAwareStrategy, {10, 3, 0});
      return std::count_if(partition.nodes.begin(), partition.nodes.end(),
                           [](const Partition::Node& node) { return node.axis == 2; });
    };
    QCOMPARE(heights(hill), 0);
    QCOMPARE(heights(house), 7);
  }

  void automaticChoosesFromWorkAndThreads() {
    const Case small(Soup().floor(0, 0, 4, 4, 0));
    const Partition one = small.partition(FilterType::AutoStrategy, {});
    QCOMPARE(one.cells.size(), std::size_t{1});
    QCOMPARE(one.strategy, std::string("GridStrategy 1 1"));
    QVERIFY(one.reason.str().find("2 triangles") != std::string::npos);
    QCOMPARE(one.cells[0].cost, 2.0);

    Case large(randomLevel(18000));
    std::set<int> seen;
    for (const int threads : {1, 2, 4, 16}) {
      large.threads = threads;
      const Partition partition = large.partition(FilterType::AutoStrategy, {});
      QVERIFY(!partition.reason.empty());
      QVERIFY(isSound(partition));
      if (threads == 1) {
        QCOMPARE(partition.cells.size(), std::size_t{1});
        continue;
      }
      const auto cells = static_cast<int>(partition.cells.size());
      double largest = 0, total = 0;
      for (const Cell& cell : partition.cells) largest = std::max(largest, cell.cost), total += cell.cost;
      // Two for each thread, as far as each has 4,000 units of work; a power of two.
      const double wanted = std::min(2.0 * threads, total / 4000);
      QVERIFY2(wanted >= 2 ? cells > 1 && cells < 2 * wanted + 1 : cells == 1,
               qPrintable(QString("%1 cells for %2 units").arg(cells).arg(total)));
      if (cells == 1) continue;
      QVERIFY(partition.strategy.starts_with("HeightAwareStrategy 50 "));
      QVERIFY(largest * cells < total * 1.6);
      seen.insert(cells);
    }
    QVERIFY(seen.size() > 1);
    Case walls(Soup(randomLevel(3000)).mapped([](const Vec3& v) { return Vec3{v.x, v.z, v.y}; }));
    std::fill(walls.walkable.begin(), walls.walkable.end(), 0);
    QCOMPARE(walls.partition(FilterType::AutoStrategy, {}).cells.size(), std::size_t{1});
  }

  void anythingCanBePartitioned() {
    std::vector<Case> cases;
    cases.emplace_back(Soup());
    cases.emplace_back(Soup().triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}));
    cases.emplace_back(Soup().triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
    cases.emplace_back(Soup().wall(0, 0, 5, 5, 0, 2).wall(3, 0, 3, 9, 0, 2));
    for (const double size : {5e-324, 1e-300, 1e300, std::numeric_limits<double>::max()})
      cases.emplace_back(randomLevel(400).mapped([&](const Vec3& v) {
        return Vec3{v.x / 64 * size, v.y / 64 * size, v.z / 64 * size};
      }));
    cases.emplace_back(randomLevel(300).mapped([](const Vec3& v) { return Vec3{v.x + 1e17, v.y - 1e17, v.z}; }));
    for (Case& given : cases)
      for (const double clearance : {0.0, 2.0, 1e308}) {
        given.clearance = clearance;
        for (const auto& [strategy, values] : kStrategies) {
          const Partition partition = given.partition(strategy, values);
          QVERIFY(isSound(partition));
          QVERIFY(areFloorsListed(given, partition));
        }
      }
  }

  void orderAndThreadsDoNotMatter() {
    const auto environment = randomLevel(9000).environment();
    std::mt19937_64 random(3);
    std::vector<std::uint32_t> order(environment->triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    const Case given(*environment), other(*test::shuffled(*environment, order, 1));
    for (const auto& [strategy, values] : kStrategies) {
      Partition expected = given.partition(strategy, values);
      const CellFloors listed = assignFloors(expected, given.input());
      for (const int threads : {1, 2, 4})
        runWithThreads(threads, [&, name = strategy, parameters = values] {
          Partition partition = other.partition(name, parameters);
          const CellFloors again = assignFloors(partition, other.input());
          QVERIFY(isSame(partition, expected));
          QVERIFY(again.first == listed.first && again.floors == listed.floors && again.cellCount == listed.cellCount);
        });
    }
  }

  void partitioningCanBeCancelled() {
    const Case given(randomLevel(20000));
    for (const auto& [strategy, values] : kStrategies) {
      StrategyInput input = given.input();
      std::atomic<int> polls{0};
      const auto count = [&] { ++polls; };
      input.poll = count;
      Partition partition = makePartition(strategy, values, input);
      const int making = polls;
      assignFloors(partition, input);
      QVERIFY(making >= 3 && polls >= making + 8);
      const auto cancel = [] { throw Cancelled(); };
      input.poll = cancel;
      QVERIFY_THROWS_EXCEPTION(Cancelled, makePartition(strategy, values, input));
      QVERIFY_THROWS_EXCEPTION(Cancelled, assignFloors(partition, input));
    }
  }

  void obstaclesAreCounted() {
    // Two storeys, and a beam above one half of each: within the clearance only of the upper one.
    const Case given(Soup().floor(0, 0, 8, 4, 0).floor(0, 0, 8, 4, 10).ceiling(4, 0, 8, 4, 11).ceiling(4, 0, 8, 4, 5));
    Partition partition = given.partition(FilterType::HeightAwareStrategy, {1, 1, 0});
    QCOMPARE(partition.cells.size(), std::size_t{2});
    assignFloors(partition, given.input());
    QCOMPARE(partition.nodes[0].axis, 2);
    QCOMPARE(partition.cells[0].obstacles, std::uint64_t{2});
    QCOMPARE(partition.cells[1].obstacles, std::uint64_t{4});
    Partition grid = given.partition(FilterType::GridStrategy, {2, 1});
    assignFloors(grid, given.input());
    QCOMPARE(grid.cells[0].obstacles, std::uint64_t{4});
    QCOMPARE(grid.cells[1].obstacles, std::uint64_t{8});
  }

  void randomSoups() {
    QVERIFY(test::check("cells and floors", 200, [] {
      const bool isBuilding = *test::below(2) == 1;
      Case given(isBuilding ? test::buildingOf(*test::buildingParts(12))
                            : test::soupOf(*test::gridTriangles(20, 7, 4)));
      given.clearance = *test::below(3);
      const double first = 1 + *test::below(5), second = 1 + *test::below(4);
      for (const auto& entry : kStrategies) {
        const bool isAuto = entry.second.empty();
        const Partition partition =
            given.partition(entry.first, isAuto ? std::vector<double>{} : std::vector<double>{first, second, 0});
        RC_ASSERT(isSound(partition));
        RC_ASSERT(areFloorsListed(given, partition));
      }
    }));
  }

  // Not every z lies on a node's height, and not every box is a point.
  void boxesVisitWhatTheyOverlap() {
    const Case given(randomLevel(3000));
    std::mt19937_64 random(8);
    const auto number = [&] { return static_cast<double>(random() % 640) / 10; };
    for (const auto& [strategy, values] : kStrategies) {
      const Partition partition = given.partition(strategy, values);
      for (int i = 0; i < 200; ++i) {
        std::array<double, 2> lower{number(), number()}, upper{number(), number()};
        for (int axis = 0; axis < 2; ++axis)
          if (lower[axis] > upper[axis]) std::swap(lower[axis], upper[axis]);
        const double z = number() / 4;
        std::vector<Index> visited, expected;
        partition.visitCells(lower, upper, z, [&](Index cell) { visited.push_back(cell); });
        for (std::size_t c = 0; c < partition.cells.size(); ++c) {
          const CellBounds& b = partition.cells[c].bounds;
          bool overlaps = b.lower[2] <= z && z < b.upper[2];
          for (int axis = 0; axis < 2; ++axis)
            overlaps = overlaps && lower[axis] < b.upper[axis] &&
                       (upper[axis] > b.lower[axis] || lower[axis] >= b.lower[axis]);
          if (overlaps) expected.push_back(static_cast<Index>(c));
        }
        std::sort(visited.begin(), visited.end());
        QVERIFY(visited == expected);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestStrategies)
#include "test_strategies.moc"
