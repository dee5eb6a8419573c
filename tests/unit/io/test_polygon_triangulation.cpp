// Splitting polygons: the triangles cover the polygon exactly once, whatever its shape and plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "core/exact/source_predicates.hpp"
#include "core/io/polygon_triangulation.hpp"
#include "footfall/errors.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

/// Twice the signed area in the plan; exact for the small integers that the tests use.
double doubleArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double doubleArea(const std::vector<Vec3>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

std::vector<std::uint32_t> allOf(const std::vector<Vec3>& polygon) {
  std::vector<std::uint32_t> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), 0U);
  return corners;
}

std::vector<Triangle> split(const std::vector<Vec3>& vertices, const std::vector<std::uint32_t>& corners) {
  std::vector<Triangle> triangles;
  if (!triangulatePolygon(corners, vertices, triangles)) triangles.clear();
  return triangles;
}

/// n - 2 triangles, all turning the polygon's way: for a simple polygon that is an exact cover.
bool coversOnce(const std::vector<Vec3>& polygon, const std::vector<Triangle>& triangles) {
  const double whole = doubleArea(polygon);
  double sum = 0;
  for (const Triangle& t : triangles) {
    const double area = doubleArea(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    if (area * whole <= 0) return false;
    sum += area;
  }
  return triangles.size() == polygon.size() - 2 && sum == whole;
}

/// A simple polygon: corners around the origin by angle, at random distances, on an integer grid.
std::vector<Vec3> star(std::mt19937& random, std::size_t count) {
  std::vector<Vec3> polygon;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    const double radius = 1000.0 + static_cast<double>(random() % 100000);
    polygon.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)), 0});
  }
  return polygon;
}

/// An exact cover of a simple polygon: no triangle turns the other way, and what is not between two of them is the
/// outline, once each.
bool hasThisOutline(const std::vector<Vec3>& polygon, const std::vector<std::uint32_t>& corners,
                    const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  const auto add = [&](std::uint32_t a, std::uint32_t b, int count) {
    edges[std::minmax(a, b)] += a < b ? count : -count;
  };
  int turn = 0;
  for (const Triangle& t : triangles) {
    const int facesUp = facing(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    if (facesUp == 0 || facesUp == -turn) return false;
    turn = facesUp;
    for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) add(corners[i], corners[(i + 1) % corners.size()], -1);
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Teeth from a back of thickness 1; every next tooth is `slant` higher along its length.
std::vector<Vec3> comb(std::size_t teeth, double length, double slant, const Vec3& origin = {}) {
  std::vector<Vec3> polygon;
  for (std::size_t i = 0; i < teeth; ++i) {
    const double y = 2 * static_cast<double>(i);
    for (const auto& [x, dy] : {std::pair{0.0, 0.0}, {length, slant}, {length, slant + 0.5}, {0.0, 1.0}})
      polygon.push_back({origin.x + x, origin.y + y + dy, 0});
  }
  polygon.push_back({origin.x - 1, origin.y + 2 * static_cast<double>(teeth), 0});
  polygon.push_back({origin.x - 1, origin.y - 1, 0});
  return polygon;
}

/// A band that winds around the origin `turns` times, with `perTurn` corners on each side of a turn.
std::vector<Vec3> spiral(std::size_t turns, std::size_t perTurn) {
  std::vector<Vec3> polygon;
  for (const bool outwards : {true, false}) {
    for (std::size_t i = 0; i < turns * perTurn; ++i) {
      const std::size_t step = outwards ? i : turns * perTurn - 1 - i;
      const double round = static_cast<double>(step) / static_cast<double>(perTurn);
      const double radius = 1000 * (round + (outwards ? 1.5 : 1));
      polygon.push_back({std::round(radius * std::cos(6.283185307179586 * round)),
                         std::round(radius * std::sin(6.283185307179586 * round)), 0});
    }
  }
  return polygon;
}

/// The outline of a random maze without loops, of `side` by `side` cells: all of it corners of a grid.
std::vector<Vec3> maze(std::mt19937& random, int side) {
  const int width = 2 * side + 1;
  std::vector<bool> open(static_cast<std::size_t>(width * width), false);
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
  constexpr std::array<std::array<int, 2>, 4> kWays{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::vector<std::array<int, 2>> path{{1, 1}};
  open[at(1, 1)] = true;
  while (!path.empty()) {
    const auto [x, y] = path.back();
    std::vector<std::array<int, 2>> ways;
    for (const auto& way : kWays) {
      const int u = x + 2 * way[0], v = y + 2 * way[1];
      if (u > 0 && u < width && v > 0 && v < width && !open[at(u, v)]) ways.push_back(way);
    }
    if (ways.empty()) {
      path.pop_back();
      continue;
    }
    const auto way = ways[random() % ways.size()];
    open[at(x + way[0], y + way[1])] = open[at(x + 2 * way[0], y + 2 * way[1])] = true;
    path.push_back({x + 2 * way[0], y + 2 * way[1]});
  }
  // The outline is followed with the open cells on the left: from a corner (x, y), the cell on the left of way d.
  const auto isOpenAt = [&](int x, int y) { return x >= 0 && y >= 0 && x < width && y < width && open[at(x, y)]; };
  const auto leftOf = [&](int x, int y, int d) {
    return isOpenAt(x - (d == 1 || d == 2 ? 1 : 0), y - (d == 2 || d == 3 ? 1 : 0));
  };
  std::vector<Vec3> outline;
  int x = 1, y = 1, d = 0;
  do {
    outline.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    x += kWays[static_cast<std::size_t>(d)][0];
    y += kWays[static_cast<std::size_t>(d)][1];
    if (leftOf(x, y, (d + 3) % 4))
      d = (d + 3) % 4;
    else if (!leftOf(x, y, d))
      d = (d + 1) % 4;
  } while (x != 1 || y != 1);
  return outline;
}

/// A square of 3 n by 3 n with n by n square holes of area 1; bridges lead from the left border to the first of each
/// row and on from hole to hole.
std::vector<Vec3> holes(int n) {
  std::vector<Vec3> polygon{{0, 3.0 * n, 0}};
  for (int row = n - 1; row >= 0; --row) {
    const double y = 3.0 * row + 1;
    polygon.push_back({0, y, 0});
    for (int i = 0; i < n; ++i) {  // The way out goes over the left, upper and right side of each.
      const double x = 3.0 * i + 1;
      for (const auto& [dx, dy] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}}) polygon.push_back({x + dx, y + dy, 0});
    }
    for (int i = n - 1; i >= 0; --i) {  // The way back goes over the lower one.
      const double x = 3.0 * i + 1;
      if (i + 1 < n) polygon.push_back({x + 1, y, 0});
      polygon.push_back({x, y, 0});
    }
    polygon.push_back({0, y, 0});
  }
  polygon.push_back({0, 0, 0});
  polygon.push_back({3.0 * n, 0, 0});
  polygon.push_back({3.0 * n, 3.0 * n, 0});
  return polygon;
}

double sumOfAreas(const std::vector<Vec3>& polygon, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += doubleArea(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
  return sum;
}

}  // namespace

class TestPolygonTriangulation : public QObject {
  Q_OBJECT
 private slots:
  void convexPolygonsAreFansFromTheFirstCorner() {
    const std::vector<Vec3> pentagon = {{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {1, 4, 0}, {-1, 2, 0}};
    QVERIFY(split(pentagon, allOf(pentagon)) == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  }

  void concavePolygonsInEveryPlaneAndDirection() {
    const std::vector<Vec3> flat = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {6, 8, 0},
                                    {6, 2, 0}, {2, 2, 0}, {2, 8, 0}, {0, 8, 0}};
    for (int plane = 0; plane < 4; ++plane) {
      std::vector<Vec3> polygon;
      for (const Vec3& p : flat) {
        polygon.push_back(plane == 0   ? p
                          : plane == 1 ? Vec3{p.x, 0, p.y}
                          : plane == 2 ? Vec3{0, p.x, p.y}
                                       : Vec3{p.x, p.y, 3 * p.x - 2 * p.y});
      }
      for (std::size_t first = 0; first < flat.size(); ++first) {
        for (const bool reversed : {false, true}) {
          std::vector<std::uint32_t> corners = allOf(flat);
          std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end());
          if (reversed) std::reverse(corners.begin(), corners.end());
          std::vector<Triangle> triangles = split(polygon, corners);
          for (Triangle& t : triangles) {
            if (reversed) std::swap(t[1], t[2]);
          }
          QVERIFY(coversOnce(flat, triangles));
        }
      }
    }
  }

  void collinearCornersGiveNoFlatTriangles() {
    const std::vector<Vec3> polygon = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0},
                                       {4, 4, 0}, {2, 4, 0}, {0, 4, 0}, {0, 2, 0}};
    QVERIFY(coversOnce(polygon, split(polygon, allOf(polygon))));
    const std::vector<Vec3> triangle = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    QVERIFY(coversOnce(triangle, split(triangle, allOf(triangle))));
  }

  void turnsAreExactFarFromTheOrigin() {
    // the reflex corner lies one unit in the last place inside the edge
    const double x = 487000.456, next = std::nextafter(x, 0);
    const std::vector<Vec3> polygon = {{x, 0, 0},      {x, 8, 0},  {x - 4, 8, 0}, {x - 4, 0, 0},
                                       {x - 4, -8, 0}, {x, -8, 0}, {next, -4, 0}};
    const std::vector<Triangle> triangles = split(polygon, allOf(polygon));
    QCOMPARE(triangles.size(), std::size_t{5});
    for (const Triangle& t : triangles) {
      QVERIFY((polygon[t[0]].x != polygon[t[1]].x || polygon[t[1]].x != polygon[t[2]].x));
    }
  }

  void holesReachedByABridge() {
    // outer square, bridge to a square hole and back: corners 4 and 9 and corners 0 and 10 share positions
    const std::vector<Vec3> polygon = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                                       {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
    QVERIFY(coversOnce(polygon, split(polygon, allOf(polygon))));
  }

  void randomStars() {
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
      const std::vector<Vec3> polygon = star(random, 4 + random() % 60);
      const std::vector<Triangle> triangles = split(polygon, allOf(polygon));
      QVERIFY(coversOnce(polygon, triangles));
    }
  }

  void manyCorners() {
    std::mt19937 random(2);
    const std::vector<Vec3> polygon = star(random, 2000);
    QVERIFY(coversOnce(polygon, split(polygon, allOf(polygon))));
  }

  void largePolygons_data() {
    QTest::addColumn<std::vector<Vec3>>("polygon");
    std::mt19937 random(3);
    QTest::newRow("comb") << comb(1000, 10, 0);
    QTest::newRow("slanted comb") << comb(1000, 100, 1000);
    QTest::newRow("comb far from the origin") << comb(1000, 0.001, 0.0007, {487000.456, 122000.123, 0});
    QTest::newRow("spiral") << spiral(20, 100);
    QTest::newRow("star") << star(random, 4000);
    std::vector<Vec3> square;
    for (int i = 0; i < 4000; ++i) {
      const int side = i / 1000, along = i % 1000;
      const std::array<std::array<int, 2>, 4> places{
          {{along, 0}, {1000, along}, {1000 - along, 1000}, {0, 1000 - along}}};
      square.push_back({double(places[side][0]), double(places[side][1]), 0});
    }
    QTest::newRow("collinear corners") << square;
    for (int i = 0; i < 5; ++i) QTest::addRow("maze %d", i) << maze(random, 20);
  }
  void largePolygons() {
    QFETCH(std::vector<Vec3>, polygon);
    QVERIFY(polygon.size() > kMostClippedCorners);
    std::vector<std::uint32_t> corners = allOf(polygon);
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(corners.begin(), corners.end());
      const std::vector<Triangle> triangles = split(polygon, corners);
      QCOMPARE(triangles.size(), polygon.size() - 2);
      QVERIFY(hasThisOutline(polygon, corners, triangles));
      QVERIFY(split(polygon, corners) == triangles);
    }
    // upright, in every plane
    std::vector<Vec3> upright;
    for (const Vec3& p : polygon) upright.push_back({p.y, 3, p.x});
    const std::vector<Triangle> triangles = split(upright, corners);
    QCOMPARE(triangles.size(), polygon.size() - 2);
    QVERIFY(hasThisOutline(polygon, corners, triangles));
  }

  void largePolygonsWithHoles() {
    const std::vector<Vec3> places = holes(20);
    QVERIFY(places.size() > kMostClippedCorners);
    // Corners at one place are one vertex, or a vertex each: the same area, once.
    std::vector<std::uint32_t> shared = allOf(places);
    for (std::size_t i = 0; i < places.size(); ++i)
      shared[i] = static_cast<std::uint32_t>(std::find(places.begin(), places.end(), places[i]) - places.begin());
    for (const auto& corners : {allOf(places), shared}) {
      const std::vector<Triangle> triangles = split(places, corners);
      QCOMPARE(sumOfAreas(places, triangles), 2.0 * (60 * 60 - 20 * 20));
      for (const Triangle& t : triangles) QVERIFY(facing(places[t[0]], places[t[1]], places[t[2]]) > 0);
    }
  }

  void whatALargePolygonCannotBeIsCoveredByAFan() {
    std::mt19937 random(4);
    std::vector<Vec3> crossing = star(random, 1001), twice, helix, flat;
    for (std::uint32_t i = 0; i < 1001; ++i) std::swap(crossing[i], crossing[random() % 1001]);
    for (int i = 0; i < 1000; ++i) {
      const double angle = 6.283185307179586 * i / 500;
      twice.push_back({std::cos(angle), std::sin(angle), 0});  // the same way around, a second time
      helix.push_back({std::round(1e6 * std::cos(angle)), std::round(1e6 * std::sin(angle)), double(i / 500)});
      flat.push_back({double(i), 2.0 * i, 3.0 * i});
    }
    for (const auto& polygon : {crossing, twice, helix, flat}) {
      const std::vector<Triangle> triangles = split(polygon, allOf(polygon));
      QCOMPARE(triangles.size(), polygon.size() - 2);
      for (std::uint32_t i = 0; i < triangles.size(); ++i) QVERIFY(triangles[i] == (Triangle{0, i + 1, i + 2}));
    }
  }

  void aLargePolygonThatIsNotPlanarIsCoveredAsSeenFromItsNormal() {
    std::mt19937 random(5);
    std::vector<Vec3> polygon = star(random, 3000), plan = polygon;
    for (Vec3& p : polygon) p.z = static_cast<double>(random() % 1000);
    const std::vector<Triangle> triangles = split(polygon, allOf(polygon));
    QCOMPARE(triangles.size(), polygon.size() - 2);
    QVERIFY(hasThisOutline(plan, allOf(plan), triangles));
  }

  // Polls are a measure of the work: so many for each corner, however many corners there are, and none after which
  // much happens.
  void workOnLargePolygonsGrowsWithTheirCorners() {
    for (const std::size_t teeth : {250, 1000, 4000, 16000}) {
      const std::vector<Vec3> polygon = comb(teeth, 100, static_cast<double>(teeth));
      std::size_t polls = 0;
      std::vector<Triangle> triangles;
      QVERIFY(triangulatePolygon(allOf(polygon), polygon, triangles, [&] { ++polls; }));
      QVERIFY(polls >= 3 * polygon.size() && polls <= 8 * polygon.size());
    }
  }

  void cancellingLeavesNothing() {
    const std::vector<Vec3> polygon = comb(4000, 10, 0);
    for (const std::size_t last : {0, 1, 10000, 20000, 40000}) {
      std::vector<Triangle> triangles;
      std::size_t polls = 0;
      const auto poll = [&] {
        if (polls++ == last) throw Cancelled();
      };
      QVERIFY_EXCEPTION_THROWN(triangulatePolygon(allOf(polygon), polygon, triangles, poll), Cancelled);
      QVERIFY(triangles.empty());
    }
  }

  void hugeAndTinyCoordinates() {
    for (const double scale : {1e-300, 1e-160, 1e160, 1.5e307}) {
      std::vector<Vec3> polygon = {{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}};
      for (Vec3& p : polygon) p = {p.x * scale, p.y * scale, 0};
      QVERIFY(split(polygon, allOf(polygon)) == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));

      const std::vector<Vec3> plain = comb(300, 1, 0.25);
      std::vector<Vec3> scaled;
      for (const Vec3& p : plain) scaled.push_back({p.x * (scale / 1024), p.y * (scale / 1024), 0});
      const std::vector<Triangle> triangles = split(scaled, allOf(scaled));
      QCOMPARE(triangles.size(), plain.size() - 2);
      QVERIFY(hasThisOutline(scaled, allOf(scaled), triangles));
    }
  }

  void repeatedCornersCountOnce() {
    const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    QVERIFY(split(square, {0, 1, 1, 2, 3, 0}) == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    QVERIFY(split(square, {0, 1, 1, 2}) == (std::vector<Triangle>{{0, 1, 2}}));
    for (const std::vector<std::uint32_t>& corners :
         std::vector<std::vector<std::uint32_t>>{{}, {0}, {0, 1}, {0, 1, 0}, {0, 1, 0, 1}, {2, 2, 2, 2}}) {
      QVERIFY(split(square, corners).empty());
    }
  }

  void polygonsWithoutAreaOrWithCrossingsStillGiveTriangles() {
    const std::vector<Vec3> line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    QCOMPARE(split(line, allOf(line)).size(), std::size_t{2});
    const std::vector<Vec3> bowTie = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
    QCOMPARE(split(bowTie, allOf(bowTie)).size(), std::size_t{2});
  }
};

QTEST_GUILESS_MAIN(TestPolygonTriangulation)
#include "test_polygon_triangulation.moc"
