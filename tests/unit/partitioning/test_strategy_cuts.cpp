// Strategies that cut again and again: cuts lie where the thesis puts them, and cells have about equal work.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "footfall/errors.hpp"
#include "footfall/filter_type.hpp"
#include "tests/unit/partitioning/partitioned_levels.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using test::Soup;

class TestStrategyCuts : public QObject {
  Q_OBJECT

 private slots:
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
    // Every floor is the same work without a clearance.
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

  // The thesis's parameter is read, has no effect on the cells, and the report says why.
  void roundingOfCutsIsReported() {
    const Case given(Soup().floor(0, 0, 8, 8, 0));
    for (const auto& [strategy, values] : {std::pair{FilterType::GridStrategy, std::vector<double>{2, 2}},
                                           {FilterType::RecursiveStrategy, {1, 2}},
                                           {FilterType::SortedRecursiveStrategy, {1, 2}}}) {
      std::vector<double> with = values, without = values;
      with.push_back(1);
      without.push_back(0);
      const Partition rounded = given.partition(strategy, with), plain = given.partition(strategy, without);
      QCOMPARE(rounded.borders, plain.borders);
      QVERIFY(plain.reason.empty());
      QVERIFY(rounded.reason.str().find("round changes nothing") != std::string::npos);
      QVERIFY(rounded.reason.str().find("footfall-rounding-experiment") != std::string::npos);
      QVERIFY(rounded.strategy.ends_with(" true") && !plain.strategy.ends_with(" true"));
    }
    QCOMPARE(given.partition(FilterType::GridStrategy, {2, 2, 0}).strategy, std::string("GridStrategy 2 2"));
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
};

QTEST_APPLESS_MAIN(TestStrategyCuts)
#include "test_strategy_cuts.moc"
