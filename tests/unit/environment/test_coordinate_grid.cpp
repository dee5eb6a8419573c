// The grid of coordinates: its step, rounding, welding whatever the order, and the limits that include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/environment/coordinate_grid.hpp"
#include "footfall/edit.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

GridExtent extentOf(double side, double offset = 0) {
  GridExtent extent;
  for (const Vec3& p : {Vec3{offset, 0, 0}, Vec3{offset + side, side / 2, side / 4}}) {
    extent.include(p);
    extent.includeVertex(p);
  }
  return extent;
}

Environment environmentOf(std::vector<Vec3> vertices, std::vector<Triangle> triangles) {
  Environment environment;
  environment.vertices = std::move(vertices);
  environment.triangles = std::move(triangles);
  return environment;
}

/// The welds of places, looked for in slabs that end at `ends`.
WeldedPlaces weldsOf(std::vector<GridPlace> places, std::vector<std::int64_t> ends) {
  std::sort(places.begin(), places.end());
  GridWelder welder;
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  ends.push_back(std::numeric_limits<std::int64_t>::max());
  for (const std::int64_t end : ends) {
    std::vector<GridPlace> slab;
    for (const GridPlace& place : places)
      if (place[0] >= first && place[0] <= end) slab.push_back(place);
    welder.addSlab(slab, end, {});
    first = end;
  }
  return welder.finish();
}

/// The same by comparing each place with each other.
WeldedPlaces slowWelds(std::vector<GridPlace> places) {
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> first(places.size());
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = i;
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = 0; j < places.size(); ++j) {
        std::int64_t squared = 0;
        for (std::size_t k = 0; k < 3; ++k) squared += (places[i][k] - places[j][k]) * (places[i][k] - places[j][k]);
        if (squared >= 4 || first[j] <= first[i]) continue;
        first[j] = first[i];
        isChanged = true;
      }
  }
  WeldedPlaces welded;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (first[i] != i) welded.emplace(places[i], places[first[i]]);
  return welded;
}

}  // namespace

class TestCoordinateGrid : public QObject {
  Q_OBJECT

 private slots:
  void stepIsThePowerOfTwoNearestAboveTheExtent() {
    QCOMPARE(usualGridStep(extentOf(64), 1), 64 * 0x1p-24);  // itself a power of two
    QCOMPARE(usualGridStep(extentOf(65), 1), 128 * 0x1p-24);
    QCOMPARE(usualGridStep(extentOf(127), 1), 128 * 0x1p-24);
    QCOMPARE(usualGridStep(extentOf(0.5), 1), 0x1p-25);
  }

  void stepIsNeverAboveAQuarterOfAMillimetre() {
    QCOMPARE(usualGridStep(extentOf(1e5), 1), 0x1p-12);
    QCOMPARE(usualGridStep(extentOf(1e5), 0.01), 0x1p-7);  // 0.0078 of 0.01 m
    QVERIFY(usualGridStep(extentOf(1e7), 0.001) * 0.001 <= 0.00025);
  }

  void stepIsNeverFinerThanDoublesAre() {
    QCOMPARE(usualGridStep(extentOf(1, 0x1p40), 1), 0x1p-11);  // of coordinates up to 2^41
    GridExtent none;
    QCOMPARE(usualGridStep(none, 1), 0.0);
    QCOMPARE(usualGridStep(extentOf(1e308, -9e307), 1) >= 0, true);
  }

  void choices() {
    const GridExtent extent = extentOf(64);
    ImportOptions options;
    QCOMPARE(chosenGridStep(options, false, extent, 1), 0.0);
    QCOMPARE(chosenGridStep(options, true, extent, 1), 0x1p-18);
    options.keptGridStep = 0x1p-16;  // the level has become four times smaller at most
    QCOMPARE(chosenGridStep(options, true, extent, 1), 0x1p-16);
    options.keptGridStep = 0x1p-15;
    QCOMPARE(chosenGridStep(options, true, extent, 1), 0x1p-18);
    options.grid = GridChoice::Off;
    QCOMPARE(chosenGridStep(options, true, extent, 1), 0.0);
    options.grid = GridChoice::Step;
    options.gridStep = 0.001;
    QCOMPARE(chosenGridStep(options, false, extent, 1), 0x1p-10);
    options.grid = GridChoice::On;
    options.keptGridStep = 0;
    QCOMPARE(chosenGridStep(options, false, extent, 1), 0x1p-18);
  }

  void verticesThatAreApartByRoundingsBecomeOne() {
    const double step = 64 * 0x1p-24;
    // Two triangles that share an edge in a modeller, and miss each other by a little on either side of a boundary
    // between two places of the grid.
    Environment level = environmentOf(
        {{0, 0, 0}, {64, 0, 0}, {64, 32 + 0.49 * step, 0}, {64, 32 + 0.51 * step, 0}, {0, 0, step / 4}, {0, 32, 0}},
        {{0, 1, 2}, {4, 3, 5}});
    putOnGrid(level, step, {});
    QCOMPARE(level.vertices[2], level.vertices[3]);
    QCOMPARE(level.vertices[0], level.vertices[4]);
    QCOMPARE(level.grid.step, step);
    QCOMPARE(level.grid.bits, 25U);  // 2^24 steps
    QCOMPARE(level.grid.weldedVertices, std::uint64_t{1});
    QVERIFY(level.grid.largestMovement > 0.5 * step && level.grid.largestMovement < 0.52 * step);
    QCOMPARE(level.grid.degenerateTriangles, std::uint64_t{0});
  }

  void trianglesThatCollapseAreCounted() {
    Environment level = environmentOf({{0, 0, 0}, {16, 0, 0}, {16, 0.25, 0}, {0, 16, 0}}, {{0, 1, 2}, {0, 2, 3}});
    putOnGrid(level, 1, {});
    QCOMPARE(level.grid.degenerateTriangles, std::uint64_t{1});
    QCOMPARE(level.triangles.size(), std::size_t{2});
  }

  void chainsBecomeTheirFirstPlace() {
    const WeldedPlaces welded = weldsOf({{5, 5, 5}, {6, 6, 6}, {7, 5, 6}, {9, 5, 6}, {5, 5, 7}}, {});
    QCOMPARE(welded.size(), std::size_t{2 + 1});  // (5, 5, 7) is a neighbour of (6, 6, 6)
    for (const auto& [from, to] : welded) QVERIFY((to == GridPlace{5, 5, 5}));
    QVERIFY(!welded.contains({9, 5, 6}));  // two steps away
  }

  void weldingIsThatOfEachWithEach() {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
      std::vector<GridPlace> places(40);
      const int side = 6 + round % 9;
      for (GridPlace& place : places)
        for (std::int64_t& x : place) x = static_cast<std::int64_t>(random() % static_cast<unsigned>(side)) - side / 2;
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      const WeldedPlaces expected = slowWelds(places);
      QVERIFY(weldsOf(places, {}) == expected);
      QVERIFY(weldsOf(places, {-1, 0, 2}) == expected);  // in slabs, as packing does
    }
  }

  void orderOfTheInputDoesNotMatter() {
    std::mt19937 random(3);
    std::vector<Vec3> vertices;
    for (int i = 0; i < 300; ++i)
      vertices.push_back({0.1 * (random() % 40), 0.1 * (random() % 40) + 0.03 * (random() % 3), 0.02 * (random() % 9)});
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i + 2 < 300; i += 3) triangles.push_back({i, i + 1, i + 2});
    Environment level = environmentOf(vertices, triangles);
    putOnGrid(level, 0x1p-5, {});
    std::vector<std::uint32_t> order(vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Vec3> shuffled(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) shuffled[order[i]] = vertices[i];
    Environment other = environmentOf(shuffled, {});
    putOnGrid(other, 0x1p-5, {});
    for (std::size_t i = 0; i < order.size(); ++i) QCOMPARE(other.vertices[order[i]], level.vertices[i]);
    QVERIFY(level.grid.weldedVertices > 0);
  }

  void roundingAgainChangesNothing() {
    Environment level = environmentOf({{0.1, 0.2, 0.3}, {3.3, 0.7, 1.1}, {0.4, 9.1, 2.3}}, {{0, 1, 2}});
    putOnGrid(level, 0x1p-10, {});
    const std::vector<Vec3> once = level.vertices;
    putOnGrid(level, 0x1p-10, {});
    QVERIFY(level.vertices == once);
    QCOMPARE(level.grid.largestMovement, 0.0);
  }

  void limitsIncludeAStep() {
    CoordinateGrid grid;
    QCOMPARE(clearanceOnGrid(grid, 2), 2.0);
    QCOMPARE(climbOnGrid(grid, 0.4), 0.4);
    grid.step = 0x1p-10;
    QCOMPARE(clearanceOnGrid(grid, 2), 2 - 0x1p-10);
    QCOMPARE(climbOnGrid(grid, 0.5), 0.5 + 0x1p-10);
    QVERIFY(climbOnGrid(grid, 0.4) > 0.4);
    double before = 0;
    for (double height = 0x1p-14; height < 0x1p-7; height += 0x1p-14) {
      QVERIFY(clearanceOnGrid(grid, height) > 0 && clearanceOnGrid(grid, height) >= before);
      before = clearanceOnGrid(grid, height);
    }
  }

  void editsAreRoundedToTheGrid() {
    auto level = std::make_shared<Environment>(environmentOf({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}}));
    level->grid.step = 0.25;
    const auto edited = editEnvironment(level, {}, {{{1.1, 1.2, 1.3}, {2, 1, 1}, {1, 2, 1}}, {{0, 1, 2}}});
    QCOMPARE(edited->vertices[3], (Vec3{1, 1.25, 1.25}));
    QCOMPARE(edited->grid.step, 0.25);
  }
};

QTEST_APPLESS_MAIN(TestCoordinateGrid)
#include "test_coordinate_grid.moc"
