// Walking freely over a result: never off it, along what stops it, over steps and gaps, down drops.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <memory>
#include <random>

#include "core/exact/source_predicates.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "ui/path/walk/ground_walk.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using namespace footfall::ui;

namespace {

constexpr double kMargin = 0.1;

std::shared_ptr<const PathFinder> finderOf(const Soup& soup, const std::string& filters = "LayerSubdivisionFilter") {
  return std::make_shared<PathFinder>(std::make_shared<NavigationMesh>(
      navigationMesh(runFilters(soup.environment(), minimalPipeline(2, 60) + "\n" + filters))));
}

bool isOnGround(const PathFinder& finder, const SurfacePlace& place) {
  const NavigationMesh& mesh = finder.mesh();
  const Triangle& f = mesh.triangles.at(place.triangle);
  for (const std::size_t i : {0, 1, 2})
    if (facing(mesh.vertices[f[i]], mesh.vertices[f[(i + 1) % 3]], place.position) < 0) return false;
  return true;
}

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

class TestGroundWalk : public QObject {
  Q_OBJECT

 private slots:
  void itStandsOnWhatIsNearest() {
    const auto finder = finderOf(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 5));
    GroundWalk walk(finder, kMargin, 0);
    QVERIFY(walk.standAt({1, 1, 5.5}, 1));
    QCOMPARE(walk.place()->position, (Vec3{1, 1, 5}));
    QVERIFY(walk.standAt({7, 1, 0}, 1));  // beside it
    QCOMPARE(walk.place()->position, (Vec3{4, 1, 0}));
    GroundWalk nowhere(std::make_shared<PathFinder>(std::make_shared<NavigationMesh>()), kMargin, 0);
    QVERIFY(!nowhere.standAt({0, 0, 0}, 1));
    QVERIFY(!nowhere.go(1, 0));
  }

  void wallsStopItAndItSlidesAlongThem() {
    const auto finder = finderOf(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 3, 0, 1));
    GroundWalk walk(finder, kMargin, 0);
    QVERIFY(walk.standAt({2, 1, 0}, 1));
    walk.go(5, 0);
    QVERIFY(std::fabs(walk.place()->position.x - (4 - kMargin)) < 1e-9);
    QCOMPARE(walk.place()->position.y, 1.0);
    // Aslant against the wall, the part along it remains.
    walk.go(0.5, 0.5);
    QVERIFY(std::fabs(walk.place()->position.x - (4 - kMargin)) < 1e-3);
    QVERIFY(std::fabs(walk.place()->position.y - 1.5) < 0.05);
    // Into the corner of wall and border, and out of it.
    walk.go(3, -9);
    QVERIFY(planDistance(walk.place()->position, {4, 0, 0}) < 3 * kMargin);
    walk.go(-1, 1);
    QVERIFY(std::fabs(planDistance(walk.place()->position, {4, 0, 0}) - std::sqrt(2)) < 4 * kMargin);
    // Past the end of the wall.
    QVERIFY(walk.standAt({3, 3.5, 0}, 1));
    walk.go(2, 0);
    QCOMPARE(walk.place()->position, (Vec3{5, 3.5, 0}));
  }

  void itNeverLeavesTheAreaNorPassesAWall() {
    // Walls without thickness, one of them aslant; places on them lie on both sides.
    const auto finder =
        finderOf(Soup().floor(0, 0, 8, 8, 0).wall(4, 0, 4, 6, 0, 1).box({1, 4, 0}, {2, 6, 1}).ramp(5, 2, 7, 4, 0, 1));
    std::mt19937_64 random(11);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    GroundWalk walk(finder, kMargin, 0);
    QVERIFY(walk.standAt({3, 1, 0}, 1));
    int wallsMet = 0, passed = 0;
    double turn = 0;
    for (int i = 0; i < 20000; ++i) {
      if (i % 40 == 0) turn = 2 * M_PI * unit();
      const Vec3 before = walk.place()->position;
      const double step = i % 7 == 0 ? 0.5 : 0.03;
      walk.go(step * std::cos(turn), step * std::sin(turn));
      const Vec3 after = walk.place()->position;
      QVERIFY2(isOnGround(*finder, *walk.place()), qPrintable(QString("step %1").arg(i)));
      QVERIFY(planDistance(before, after) < step + 0.15);
      if (planDistance(before, after) < step / 2) ++wallsMet;
      if ((before.x < 4) == (after.x < 4)) continue;
      ++passed;
      // The straight line between both is no proof where it slid round the end; a step below it is.
      QVERIFY2(std::max(before.y, after.y) > 6 - 0.5, qPrintable(QString("step %1 at %2").arg(i).arg(after.y)));
    }
    QVERIFY(wallsMet > 100);
    QVERIFY(passed > 2);
  }

  void stairsAndGapsAreTaken() {
    Soup stairs;
    for (int i = 0; i < 8; ++i) stairs.floor(i, 0, i + 1, 4, 0.2 * i);
    GroundWalk up(finderOf(stairs, "StepFilter 0.4 0.05"), kMargin, 0.05);
    QVERIFY(up.standAt({0.5, 2, 0}, 1));
    for (int i = 0; i < 350; ++i) up.go(0.02, 0);
    QVERIFY(std::fabs(up.place()->position.x - 7.5) < 1e-6);
    QCOMPARE(up.place()->position.z, 0.2 * 7);
    GroundWalk over(finderOf(Soup().floor(0, 0, 2, 4, 0).floor(2.25, 0, 4, 4, 0), "StepFilter 0.4 0.5"), kMargin, 0.5);
    QVERIFY(over.standAt({1, 2, 0}, 1));
    for (int i = 0; i < 100; ++i) over.go(0.02, 0);
    QVERIFY(over.place()->position.x > 2.5);
    GroundWalk stops(finderOf(Soup().floor(0, 0, 2, 4, 0).floor(2.25, 0, 4, 4, 0)), kMargin, 0);
    QVERIFY(stops.standAt({1, 2, 0}, 1));
    for (int i = 0; i < 100; ++i) stops.go(0.02, 0);
    QVERIFY(stops.place()->position.x < 2);
  }

  void dropsAreFallen() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 2).floor(4, 0, 8, 4, 0).wall(4, 0, 4, 4, 0, 2);
    GroundWalk walk(finderOf(soup, "LayerSubdivisionFilter\nDropFilter 3"), kMargin, 0);
    QVERIFY(walk.standAt({3, 2, 2}, 1));
    std::optional<GroundWalk::Fall> fall;
    for (int i = 0; i < 100 && !fall; ++i) fall = walk.go(0.02, 0);
    QVERIFY(fall);
    QCOMPARE(fall->from.z, 2.0);
    QCOMPARE(walk.place()->position.z, 0.0);
    // Nothing leads back.
    for (int i = 0; i < 100; ++i) QVERIFY(!walk.go(-0.02, 0));
    QCOMPARE(walk.place()->position.z, 0.0);
    GroundWalk stays(finderOf(soup), kMargin, 0);
    QVERIFY(stays.standAt({3, 2, 2}, 1));
    for (int i = 0; i < 100; ++i) QVERIFY(!stays.go(0.02, 0));
    QCOMPARE(stays.place()->position.z, 2.0);
  }
};

QTEST_GUILESS_MAIN(TestGroundWalk)
#include "test_ground_walk.moc"
