// Free height above places against looking at every triangle in exact arithmetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>

#include "core/inspect/headroom.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "tests/reference/walkable_area.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using reference::Rational;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The free height above a place: every triangle is looked at. Empty where the place is above an edge, or where a plane
/// passes so close that rounding may decide.
std::optional<double> slowHeadroom(const Environment& environment, const Vec3& place, double cap) {
  const reference::Point3 p = reference::toPoint(place);
  double lowest = cap;
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    const auto corners = reference::cornersOf(environment, t);
    const reference::Polygon triangle = reference::planTriangle(corners);
    if (triangle.empty()) continue;
    bool inside = true;
    for (std::size_t k = 0; k < 3 && inside; ++k) {
      const int side = reference::turn(triangle[k], triangle[(k + 1) % 3], reference::planOf(p));
      if (side == 0) return std::nullopt;
      inside = side > 0;
    }
    if (!inside) continue;
    const Rational height = reference::planeThrough(corners)->at(reference::planOf(p)) - p.z;
    if (height != 0 && abs(height) < 1e-9) return std::nullopt;
    if (height > 0) lowest = std::min(lowest, height.get_d());
  }
  return lowest;
}

double single(const Environment& environment, const Vec3& place, double cap = kInfinity) {
  const HeadroomTree tree(std::make_shared<Environment>(environment));
  return headroomAt(tree, std::array{place}, cap).at(0);
}

}  // namespace

class TestHeadroom : public QObject {
  Q_OBJECT
 private slots:
  void belowCeilingAndRamp() {
    const auto room = Soup().floor(0, 0, 4, 4, 0).ceiling(0, 0, 2, 4, 2.5).ramp(2, 0, 4, 4, 0, 2).environment();
    QCOMPARE(single(*room, {1, 1, 0}), 2.5);
    QCOMPARE(single(*room, {3, 1, 0}), 1.0);
    QCOMPARE(single(*room, {3, 1, 1}), kInfinity);    // The place is on the ramp itself.
    QCOMPARE(single(*room, {1, 1, 2.5}), kInfinity);  // The place is on the ceiling.
    QCOMPARE(single(*room, {1, 1, 0}, 2.0), 2.0);
    QCOMPARE(single(*room, {9, 9, 0}), kInfinity);
    QVERIFY(headroomAt(HeadroomTree(room), {}, 2).empty());
  }

  void wallsCoverNothing() {
    const auto room = Soup().floor(0, 0, 4, 4, 0).wall(1, 0, 1, 4, 0.5, 3).environment();
    QCOMPARE(single(*room, {1, 1, 0}), kInfinity);
  }

  void lowestTriangleIsNamed() {
    const auto room = Soup().floor(0, 0, 4, 4, 0).ceiling(0, 0, 4, 4, 3).ceiling(0, 0, 4, 4, 2).environment();
    const HeadroomTree tree(room);
    std::vector<std::int32_t> stack;
    const auto above = tree.lowestAbove({1, 2, 0}, kInfinity, stack);
    QVERIFY(above && (above->triangle == 4 || above->triangle == 5));
    QCOMPARE(above->height, 2.0);
    QVERIFY(!tree.lowestAbove({1, 2, 0}, 2, stack));
  }

  void randomSoups() {
    std::mt19937_64 random(test::seed());
    int compared = 0;
    for (int round = 0; round < rounds(60); ++round) {
      std::uniform_real_distribution<double> anywhere(-3, 3);
      const double offset = round % 3 == 0 ? 0 : std::ldexp(1, round % 12);
      Soup soup;
      const auto corner = [&] {
        const auto place = [&] { return round % 2 == 0 ? anywhere(random) : std::round(anywhere(random)); };
        return Vec3{place() + offset, place() + offset, place() + offset};
      };
      for (int t = 0; t < 40; ++t) soup.triangle(corner(), corner(), corner());
      const auto environment = soup.environment();
      std::vector<Vec3> places(200);
      for (Vec3& p : places) p = {anywhere(random) + offset, anywhere(random) + offset, anywhere(random) + offset};
      const double cap = round % 4 == 0 ? kInfinity : 1.5;
      const auto heights = headroomAt(HeadroomTree(environment), places, cap);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto expected = slowHeadroom(*environment, places[i], cap);
        if (!expected) continue;
        ++compared;
        if (std::isinf(*expected))
          QCOMPARE(heights[i], std::numeric_limits<float>::infinity());
        else
          QVERIFY2(std::fabs(heights[i] - *expected) <= 1e-6 * *expected,
                   qPrintable(QString("%1 for %2").arg(heights[i]).arg(*expected)));
      }
    }
    QVERIFY(compared > rounds(60) * 150);
  }

  void realEnvironments_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"nav_test", "complex"}) QTest::newRow(name) << name;
  }
  // Places of the walkable area: none that the clearance filter left may have less headroom than the clearance.
  void realEnvironments() {
    QFETCH(QString, name);
    if (sharedEnvironments().isEmpty()) QSKIP("the real environments are not here");
    const auto environment = importEnvironment((sharedEnvironments() + "/" + name + ".obj").toStdString());
    RunContext context;
    const double clearance = 2 / environment->metresPerUnit;
    const Pipeline pipeline =
        parsePipeline("DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter " + std::to_string(clearance), "test");
    const RunResult result = runPipeline(environment, pipeline, context);
    const HeadroomTree tree(environment);
    std::vector<Vec3> middles;
    for (const Triangle& t : result.mesh->triangles) {
      const Vec3 &a = result.mesh->vertices[t[0]], &b = result.mesh->vertices[t[1]], &c = result.mesh->vertices[t[2]];
      const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      if (area < 1e-6 * clearance * clearance) continue;  // so thin that rounding decides where its middle is
      middles.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3});
    }
    QVERIFY(middles.size() > 100);
    for (const float height : headroomAt(tree, middles, kInfinity)) QVERIFY(height >= clearance * (1 - 1e-5));
  }

  void cancels() {
    Soup soup;
    for (int i = 0; i < 100; ++i) soup.floor(i, 0, i + 1, 1, 0);
    const auto environment = soup.environment();
    const auto poll = [] { throw Cancelled(); };
    QVERIFY_EXCEPTION_THROWN(HeadroomTree(environment, poll), Cancelled);
    const HeadroomTree tree(environment);
    const std::vector<Vec3> places(5000, {0.5, 0.5, 0});
    QVERIFY_EXCEPTION_THROWN(headroomAt(tree, places, 2, poll), Cancelled);
    std::atomic<int> calls{0};
    headroomAt(tree, places, 2, [&] { ++calls; });
    QVERIFY(calls >= 5);
  }
};

QTEST_APPLESS_MAIN(TestHeadroom)
#include "test_headroom.moc"
