// Splitting polygons: the triangles cover the polygon exactly once, whatever its shape and plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/environment/polygon_triangulation.hpp"

using namespace footfall;

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

  void hugeAndTinyCoordinates() {
    for (const double scale : {1e-300, 1e-160, 1e160, 1.5e307}) {
      std::vector<Vec3> polygon = {{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}};
      for (Vec3& p : polygon) p = {p.x * scale, p.y * scale, 0};
      QVERIFY(split(polygon, allOf(polygon)) == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
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
