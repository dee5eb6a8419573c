// Shapes that are placed into environments: closed, facing outward, exact where it matters, and solid.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/environment/placed_obstacle.hpp"
#include "footfall/edit.hpp"
#include "footfall/errors.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using Shape = PlacedObstacle::Shape;

namespace {

PlacedObstacle obstacle(Shape shape, const Vec3& base, const Vec3& size, double turn = 0) {
  return {1, shape, "thing", base, size, turn};
}

/// Every edge is used once in each direction.
bool isClosed(const TriangleSoup& soup) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    if (count != 1 || opposite == uses.end() || opposite->second != 1) return false;
  }
  return !uses.empty();
}

/// The volume: above 0 when a closed surface faces outward.
double volume(const TriangleSoup& soup) {
  double six = 0;
  const Vec3& o = soup.vertices[0];
  for (const Triangle& t : soup.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = soup.vertices[t[k]];
      p[k] = {v.x - o.x, v.y - o.y, v.z - o.z};
    }
    six += p[0].x * (p[1].y * p[2].z - p[1].z * p[2].y) - p[0].y * (p[1].x * p[2].z - p[1].z * p[2].x) +
           p[0].z * (p[1].x * p[2].y - p[1].y * p[2].x);
  }
  return six / 6;
}

double walkableArea(const TriangleSoup& soup, const std::string& pipeline, double floor = 10) {
  const auto level = Soup().floor(-floor, -floor, floor, floor, 0).environment();
  return area(navigationMesh(runFilters(editEnvironment(level, {}, soup), pipeline)));
}

}  // namespace

class TestPlacedObstacle : public QObject {
  Q_OBJECT

 private slots:
  void closedAndOutward_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("turn");
    QTest::addColumn<double>("expected");
    for (const double turn : {0.0, 90.0, -90.0, 180.0, 33.0, 1e9 + 0.25}) {
      const auto name = [turn](const char* shape) { return std::string(shape) + ' ' + std::to_string(turn); };
      QTest::newRow(name("box").c_str()) << static_cast<int>(Shape::Box) << turn << 24.0;
      QTest::newRow(name("ramp").c_str()) << static_cast<int>(Shape::Ramp) << turn << 12.0;
      const double sector = 24 * std::sin(2 * M_PI / 24) / 2;  // area of a sector of the unit circle
      QTest::newRow(name("cylinder").c_str()) << static_cast<int>(Shape::Cylinder) << turn << sector * 1 * 1.5 * 4;
    }
  }
  void closedAndOutward() {
    QFETCH(int, shape);
    QFETCH(double, turn);
    QFETCH(double, expected);
    const TriangleSoup soup = soupOf(obstacle(static_cast<Shape>(shape), {100, -7.5, 3}, {2, 3, 4}, turn));
    QVERIFY(isClosed(soup));
    QVERIFY(std::abs(volume(soup) - expected) < 1e-5 * expected);
    for (const Vec3& v : soup.vertices) QVERIFY(v.z == 3 || v.z == 7);
  }

  void turnsByRightAnglesAreExact() {
    for (int quarter = -9; quarter <= 9; ++quarter) {
      const auto [c, s] = directionOf(90.0 * quarter);
      QVERIFY((std::abs(c) == 1 && s == 0) || (c == 0 && std::abs(s) == 1));
      const bool across = quarter % 2 != 0;
      // 0.1 and 0.3 have all digits; corners are those of the extents, not of a product with a cosine.
      for (const Shape shape : {Shape::Box, Shape::Ramp}) {
        const TriangleSoup soup = soupOf(obstacle(shape, {0.7, 0.9, 0.1}, {0.1, 0.3, 0.2}, 90.0 * quarter));
        for (const Vec3& v : soup.vertices) {
          const double halfX = across ? 0.15 : 0.05, halfY = across ? 0.05 : 0.15;
          QVERIFY(v.x == 0.7 + halfX || v.x == 0.7 - halfX);
          QVERIFY(v.y == 0.9 + halfY || v.y == 0.9 - halfY);
        }
      }
    }
    // A cylinder touches its extents.
    double most = 0;
    for (const Vec3& v : soupOf(obstacle(Shape::Cylinder, {0, 0, 0}, {0.3, 0.1, 1})).vertices)
      most = std::max(most, v.x);
    QCOMPARE(most, 0.15);
  }

  void degenerateSizesAreRefused() {
    const double inf = std::numeric_limits<double>::infinity();
    for (const Vec3& size : {Vec3{0, 1, 1}, Vec3{1, -1, 1}, Vec3{1, 1, 0}, Vec3{1, inf, 1}, Vec3{1, 1, std::nan("")}})
      QVERIFY_EXCEPTION_THROWN(soupOf(obstacle(Shape::Box, {0, 0, 0}, size)), InputError);
    QVERIFY_EXCEPTION_THROWN(soupOf(obstacle(Shape::Box, {inf, 0, 0}, {1, 1, 1})), InputError);
    QVERIFY_EXCEPTION_THROWN(soupOf(obstacle(Shape::Ramp, {0, 0, 0}, {1, 1, 1}, inf)), InputError);
    QVERIFY_EXCEPTION_THROWN(soupOf(obstacle(Shape::Box, {1.7e308, 0, 0}, {1.7e308, 1, 1})), InputError);
    // The size is below the precision of its place: flat, but a soup.
    for (const Shape shape : {Shape::Box, Shape::Cylinder, Shape::Ramp})
      for (const double size : {1e-300, 5e-324, 1e-3, 1e5})
        for (const Vec3& v : solidSoupOf(obstacle(shape, {1e6, 1, 1}, {size, 1, size}, 20), 0.4).vertices)
          QVERIFY(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
  }

  void placesFollowTheTurn() {
    const PlacedObstacle box = obstacle(Shape::Box, {1, 2, 3}, {1, 1, 1}, 90);
    QCOMPARE(placeOn(box, {2, 0, 1}), (Vec3{1, 4, 4}));
  }

  void topOfABoxIsAFloor() {
    const TriangleSoup soup = soupOf(obstacle(Shape::Box, {0, 0, 0}, {2, 2, 1}));
    QCOMPARE(walkableArea(soup, "SlopeFilter 45\nVerticalClearanceFilter 2\n"), 400.0);  // 4 less below, 4 more on top
    QCOMPARE(walkableArea(soup, "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 10\n"), 396.0);
  }

  void rampJoinsTheFloor() {
    // 26.6 degrees: walkable, and one part with the floor at its foot.
    const auto level = Soup().floor(-10, -10, 10, 10, 0).environment();
    for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
      const TriangleSoup soup = soupOf(obstacle(Shape::Ramp, {0, 0, 0}, {4, 2, 2}, turn));
      const StatePtr state =
          runFilters(editEnvironment(level, {}, soup), "SlopeFilter 30\nVerticalClearanceFilter 1\n");
      const NavigationMesh mesh = navigationMesh(state);
      QCOMPARE(countParts(mesh), std::size_t{2});  // and the floor under its high end
      QVERIFY(std::abs(area(mesh) - (400 - 4 + 4 * std::sqrt(5.0))) < 1e-6);
    }
  }

  // Higher than the clearance, with the floor anywhere inside.
  void nobodyWalksInside() {
    for (const Shape shape : {Shape::Box, Shape::Cylinder, Shape::Ramp}) {
      for (const double below : {0.0, 0.3, 2.6, 5.0}) {
        const PlacedObstacle tall = obstacle(shape, {0, 0, -below}, {3, 3, 9}, 30);
        const NavigationMesh mesh = navigationMesh(
            runFilters(editEnvironment(Soup().floor(-10, -10, 10, 10, 0).environment(), {}, solidSoupOf(tall, 0.4)),
                       "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
        std::size_t onFloor = 0;
        for (const Triangle& t : mesh.triangles) {
          Vec3 middle{};
          for (const std::uint32_t v : t) {
            middle.x += mesh.vertices[v].x / 3;
            middle.y += mesh.vertices[v].y / 3;
            middle.z += mesh.vertices[v].z / 3;
          }
          if (middle.z > 0.1) continue;
          ++onFloor;
          const double distance = std::hypot(middle.x, middle.y);
          QVERIFY2(distance > 0.9, qPrintable(QString::number(distance)));
        }
        QVERIFY(onFloor > 0);
      }
    }
    // Hollow, the floor in the middle would be one.
    const PlacedObstacle tall = obstacle(Shape::Box, {0, 0, 0}, {3, 3, 9});
    const std::string pipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
    QCOMPARE(walkableArea(soupOf(tall), pipeline), 409.0);
    QCOMPARE(walkableArea(solidSoupOf(tall, 0.4), pipeline), 400.0);
  }

  // Faces inside stay inside: nothing outside of obstacles differs.
  void facesInsideChangeNothingOutside() {
    for (const Shape shape : {Shape::Box, Shape::Cylinder, Shape::Ramp}) {
      const PlacedObstacle low = obstacle(shape, {0.1, 0.2, 0}, {3, 2, 1.5}, 17);
      const std::string pipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
      QVERIFY(std::abs(walkableArea(soupOf(low), pipeline) - walkableArea(solidSoupOf(low, 0.4), pipeline)) < 1e-9);
    }
  }
};

QTEST_GUILESS_MAIN(TestPlacedObstacle)
#include "test_placed_obstacle.moc"
