// Strategies: cells tile the plan, and floors are listed where they have area, whatever is partitioned.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "footfall/errors.hpp"
#include "footfall/filter_type.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/unit/partitioning/partitioned_levels.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using test::Soup;

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

  // Some z lie between the heights of nodes, and some boxes have an extent.
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
