// Rays, nearest and random places, many paths, single layers, polygons: against paths, and on meshes made by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "core/exact/source_predicates.hpp"
#include "footfall/errors.hpp"
#include "footfall/ground.hpp"
#include "footfall/plan_areas.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Random = std::mt19937_64;

std::shared_ptr<const NavigationMesh> walkable(const Soup& soup, double clearance = 2,
                                               const std::string& filters = "LayerSubdivisionFilter") {
  return std::make_shared<NavigationMesh>(
      navigationMesh(runFilters(soup.environment(), minimalPipeline(clearance, 60) + "\n" + filters)));
}

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool isInside(const NavigationMesh& mesh, const SurfacePlace& place) {
  const Triangle& f = mesh.triangles[place.triangle];
  for (const std::size_t i : {0, 1, 2})
    if (facing(mesh.vertices[f[i]], mesh.vertices[f[(i + 1) % 3]], place.position) < 0) return false;
  return true;
}

/// The error of a ray between two places; empty when there is none.
QString rayError(const PathFinder& finder, const Vec3& from, const Vec3& to, int& reached) {
  const auto ray = castRay(finder, from, to);
  if (!ray) return finder.locate(from) ? "no ray from a walkable place" : "";
  if (!isInside(finder.mesh(), ray->end)) return "the end is not in its triangle";
  if (ray->triangles.empty() || ray->triangles.front() != ray->start.triangle) return "begins on another triangle";
  if (ray->triangles.back() != ray->end.triangle) return "ends on another triangle";
  if (std::fabs(ray->planLength + ray->end.distance - planDistance(from, to)) > 1e-9) return "is not straight";
  if (ray->reached) {
    ++reached;
    // The place that is reached may be on another layer than `to`; a path there is as long. On a wall it may be on the
    // other side.
    if (finder.locate(ray->end.position)->triangle != ray->end.triangle) return {};
    const PathResult path = finder.find(ray->start.position, ray->end.position);
    if (!path.reached() || std::fabs(path.planLength - ray->planLength) > 1e-9) return "no path is as straight";
    return {};
  }
  const PathResult path = finder.find(from, to);
  if (path.reached() && path.bends.empty() && path.gaps.empty()) return "a straight path goes on behind its end";
  return {};
}

NavigationMesh meshOf(std::vector<Vec3> vertices, std::vector<Triangle> triangles) {
  NavigationMesh mesh;
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace

class TestGround : public QObject {
  Q_OBJECT

 private slots:
  void raysEndAtBorders() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 3, 0, 1)));
    const auto open = castRay(finder, {1, 3.5, 0}, {7, 3.5, 5});
    QVERIFY(open && open->reached && !open->border);
    QCOMPARE(open->end.position, (Vec3{7, 3.5, 0}));
    const auto stopped = castRay(finder, {1, 1, 0}, {7, 1, 0});
    QVERIFY(stopped && !stopped->reached && stopped->border);
    QCOMPARE(stopped->end.position, (Vec3{4, 1, 0}));
    for (const std::uint32_t v : *stopped->border) QCOMPARE(finder.mesh().vertices[v].x, 4.0);
    QCOMPARE(stopped->planLength, 3.0);
    QCOMPARE(stopped->end.distance, 3.0);
    QVERIFY(castRay(finder, {1, 1, 0}, {1, 9, 0})->end.position == (Vec3{1, 4, 0}));
    QVERIFY(!castRay(finder, {9, 9, 0}, {1, 1, 0}));
    QVERIFY(castRay(finder, {1, 1, 0}, {1, 1, 0})->reached);
    QVERIFY_THROWS_EXCEPTION(InputError, castRay(finder, {NAN, 1, 0}, {1, 1, 0}));
    QVERIFY_THROWS_EXCEPTION(InputError, castRay(finder, {1, 1, 0}, {INFINITY, 1, 0}));
  }

  void raysTouchEndsOfWallsAndRunAlongBorders() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 3, 0, 1)));
    QVERIFY(castRay(finder, {1, 3, 0}, {7, 3, 0})->reached);    // past the end of the wall, exactly
    QVERIFY(castRay(finder, {3, 2, 0}, {5, 4, 0})->reached);    // the same aslant
    QVERIFY(castRay(finder, {4, 3.5, 0}, {4, 3, 0})->reached);  // to the end of the wall
    QVERIFY(castRay(finder, {4, 4, 0}, {4, 0, 0})->reached);    // along it
    QVERIFY(castRay(finder, {0, 0, 0}, {0, 4, 0})->reached);    // along the outer border, from corner to corner
    QVERIFY(castRay(finder, {8, 4, 0}, {0, 4, 0})->reached);
    const auto outwards = castRay(finder, {0, 0, 0}, {-1, -1, 0});
    QVERIFY(!outwards->reached && outwards->planLength == 0 && !outwards->border);
    QCOMPARE(castRay(finder, {0, 2, 0}, {-1, 2, 0})->planLength, 0.0);
  }

  void raysFollowBothSidesOfAWall() {
    // The wall stands along the ray; a second one closes one of its sides.
    for (const double y : {0.0, 4.0}) {
      const PathFinder finder(walkable(
          Soup().floor(0, 0, 8, 4, 0).wall(3, 2, 5, 2, 0, 1).wall(4, std::min(y, 2.0), 4, std::max(y, 2.0), 0, 1)));
      const auto ray = castRay(finder, {1, 2, 0}, {7, 2, 0});
      QVERIFY(ray->reached);
      QCOMPARE(ray->end.position, (Vec3{7, 2, 0}));
    }
  }

  void raysInARowStayOnTheirSide() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 3, 0, 1)));
    for (const double x : {1.0, 7.0}) {
      // The place on the wall is on both sides of it; which one locate() gives has no meaning here.
      GroundRay ray = castRayFrom(finder, *finder.locate({x, 1, 0}), {8 - x, 1, 0});
      for (int i = 0; i < 3; ++i) {
        QVERIFY(!ray.reached && ray.border);
        QCOMPARE(ray.end.position, (Vec3{4, 1, 0}));
        ray = castRayFrom(finder, ray.end, {8 - x, 1, 0});
        QCOMPARE(ray.planLength, 0.0);
      }
      QVERIFY(castRayFrom(finder, ray.end, {x, 1, 0}).reached);
    }
    SurfacePlace wrong = *finder.locate({1, 1, 0});
    QVERIFY_THROWS_EXCEPTION(InputError, castRayFrom(finder, wrong, {NAN, 1, 0}));
    wrong.triangle = static_cast<std::uint32_t>(finder.mesh().triangles.size());
    QVERIFY_THROWS_EXCEPTION(InputError, castRayFrom(finder, wrong, {1, 1, 0}));
    SurfacePlace outside = *finder.locate({1, 1, 0});
    outside.position.x = 100;
    QVERIFY_THROWS_EXCEPTION(InputError, castRayFrom(finder, outside, {1, 1, 0}));
  }

  void raysDoNotPassThroughPoints() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 2, 2, 0).floor(2, 2, 4, 4, 0)));
    const auto ray = castRay(finder, {1, 1, 0}, {3, 3, 0});
    QVERIFY(!ray->reached && !ray->border);
    QCOMPARE(ray->end.position, (Vec3{2, 2, 0}));
  }

  void raysFollowSlopesStepsAndGaps() {
    const PathFinder ramp(walkable(Soup().floor(0, 0, 4, 4, 0).ramp(4, 0, 8, 4, 0, 3).floor(8, 0, 10, 4, 3)));
    QCOMPARE(castRay(ramp, {1, 1, 0}, {9, 1, 0})->end.position, (Vec3{9, 1, 3}));
    const Soup stairs = Soup().floor(0, 0, 2, 4, 0).floor(2, 0, 4, 4, 0.25);
    QVERIFY(!castRay(PathFinder(walkable(stairs)), {1, 1, 0}, {3, 1, 0})->reached);
    QCOMPARE(castRay(PathFinder(walkable(stairs, 2, "StepFilter 0.4 0.05")), {1, 1, 0}, {3, 1, 0})->end.position,
             (Vec3{3, 1, 0.25}));
    const Soup planks = Soup().floor(0, 0, 2, 4, 0).floor(2.25, 0, 4, 4, 0);
    const PathFinder over(walkable(planks, 2, "StepFilter 0.4 0.5"));
    QVERIFY(castRay(over, {1, 1, 0}, {3, 1, 0})->reached);
    const auto into = castRay(over, {1, 1, 0}, {2.125, 1, 0});
    QVERIFY(!into->reached && !into->border);
    QCOMPARE(into->end.position, (Vec3{2, 1, 0}));
    QCOMPARE(castRay(PathFinder(walkable(planks)), {1, 1, 0}, {3, 1, 0})->end.position, (Vec3{2, 1, 0}));
  }

  void raysAgreeWithPaths() {
    int reached = 0, seen = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(rounds(30)); ++seed) {
      Random random(seed);
      const auto whole = [&](int most) { return static_cast<double>(random() % static_cast<std::uint64_t>(most)); };
      Soup soup = Soup().floor(0, 0, 12, 12, 0);
      for (int i = 0; i < 6; ++i) {
        const double x = whole(11), y = whole(11);
        if (i % 2 == 0)
          soup.box({x, y, 0}, {x + 1 + whole(3), y + 1, 1});
        else
          soup.wall(x, y, x + whole(4), y + 1, 0, 1);
      }
      const PathFinder finder(walkable(soup));
      for (int i = 0; i < 120; ++i) {
        // Whole and half coordinates lie on corners, sides and lines through corners.
        const auto any = [&] {
          return i % 3 == 0 ? 12 * std::ldexp(static_cast<double>(random() >> 11), -53) : whole(25) / 2;
        };
        const double x0 = any(), y0 = any(), x1 = any(), y1 = any();
        const Vec3 from{x0, y0, 0}, to{x1, y1, 0};
        const QString error = rayError(finder, from, to, reached);
        QVERIFY2(error.isEmpty(),
                 qPrintable(QString("seed %1: %2 %3 to %4 %5: ").arg(seed).arg(from.x).arg(from.y).arg(to.x).arg(to.y) +
                            error));
        ++seen;
      }
    }
    QVERIFY(reached > seen / 10 && reached < seen * 9 / 10);
  }

  void randomPlacesAreEvenAndTheSame() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 4, 4, 0).floor(10, 0, 14, 12, 0)));
    const auto places = randomPlaces(finder, 20000, 5);
    int inFirst = 0, inLowerHalf = 0;
    for (const SurfacePlace& place : places) {
      QVERIFY(isInside(finder.mesh(), place));
      if (place.position.x <= 4) {
        ++inFirst;
        if (place.position.y < 2) ++inLowerHalf;
      }
    }
    QVERIFY(std::abs(inFirst - 5000) < 400);  // a quarter of the area; six deviations
    QVERIFY(std::abs(inLowerHalf - inFirst / 2) < 220);
    const auto fewer = randomPlaces(finder, 7, 5), others = randomPlaces(finder, 7, 6);
    for (std::size_t i = 0; i < fewer.size(); ++i) {
      QCOMPARE(fewer[i].position, places[i].position);
      QVERIFY(!(others[i].position == places[i].position));
    }
    QVERIFY(randomPlaces(finder, 0).empty());
    QCOMPARE(QString::number(randomPlaces(finder, 1, 0)[0].position.x, 'g', 17),
             QString::number(randomPlaces(finder, 1)[0].position.x, 'g', 17));
  }

  void nothingToChooseIsAnError() {
    const auto empty = std::make_shared<NavigationMesh>();
    const auto point = std::make_shared<NavigationMesh>(meshOf({{1, 1, 1}}, {{0, 0, 0}}));
    const auto line = std::make_shared<NavigationMesh>(meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
    for (const auto& mesh : {empty, point, line}) {
      const PathFinder finder(mesh);
      QVERIFY_THROWS_EXCEPTION(InputError, randomPlaces(finder, 1));
      QVERIFY_THROWS_EXCEPTION(InputError, randomPlaces(finder, 0));
      QVERIFY(!nearestPlace(finder, {0, 0, 0}));
      QVERIFY(!castRay(finder, {0, 0, 0}, {1, 0, 0}));
      QCOMPARE(findPaths(finder, std::vector<std::array<Vec3, 2>>(1)).at(0).status, PathStatus::NothingWalkable);
    }
  }

  void nearestPlacesAreNearest() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 5)));
    QCOMPARE(nearestPlace(finder, {1, 1, 2})->position, (Vec3{1, 1, 0}));
    QCOMPARE(nearestPlace(finder, {1, 1, 3})->position, (Vec3{1, 1, 5}));
    const auto beside = nearestPlace(finder, {7, 8, 0});
    QCOMPARE(beside->position, (Vec3{4, 4, 0}));
    QCOMPARE(beside->distance, 5.0);
    QVERIFY_THROWS_EXCEPTION(InputError, nearestPlace(finder, {NAN, 0, 0}));
  }

  void manyPathsAreSinglePaths() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 3, 0, 1)));
    std::vector<std::array<Vec3, 2>> pairs;
    const auto places = randomPlaces(finder, 80);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) pairs.push_back({places[i].position, places[i + 1].position});
    pairs.push_back({Vec3{20, 0, 0}, Vec3{1, 1, 0}});
    const auto paths = findPaths(finder, pairs);
    QCOMPARE(paths.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const PathResult path = finder.find(pairs[i][0], pairs[i][1]);
      QVERIFY(paths[i].points == path.points && paths[i].status == path.status);
    }
    QVERIFY(findPaths(finder, {}).empty());
    pairs[3][1].x = NAN;
    QVERIFY_THROWS_EXCEPTION(InputError, findPaths(finder, pairs));
  }

  void layersAreMeshesOfTheirOwn() {
    const auto mesh = walkable(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 3, 0, 1).floor(0, 0, 4, 4, 5));
    QCOMPARE(mesh->layerCount, 2U);
    std::size_t triangles = 0;
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
      const NavigationMesh only = layerOf(*mesh, layer);
      std::size_t i = 0;
      for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
        if (mesh->layers[t] != layer) continue;
        for (const std::size_t k : {0, 1, 2})
          QCOMPARE(only.vertices[only.triangles[i][k]], mesh->vertices[mesh->triangles[t][k]]);
        QCOMPARE(only.sourceTriangles[i++], mesh->sourceTriangles[t]);
      }
      QCOMPARE(only.triangles.size(), i);
      QCOMPARE(only.layerCount, 1U);
      triangles += i;
    }
    QCOMPARE(triangles, mesh->triangles.size());
    QVERIFY_THROWS_EXCEPTION(InputError, layerOf(*mesh, 2));
    QVERIFY_THROWS_EXCEPTION(InputError, layerOf(NavigationMesh(), 0));
  }

  void polygonsHaveHoles() {
    const auto mesh = walkable(Soup().floor(0, 0, 8, 4, 0).box({2, 1, 0}, {3, 2, 1}).floor(20, 0, 21, 1, 0));
    const auto areas = planAreas(*mesh);
    QCOMPARE(areas.size(), std::size_t{3});  // the floor, the top of the box, the other floor
    QCOMPARE(planAreas(*mesh, 0).size(), std::size_t{1});
    const PlanArea floor = planAreas(*mesh, 0).front();
    QCOMPARE(floor.holes.size(), std::size_t{1});
    QVERIFY(floor.holes[0].size() >= 4);  // and places where triangles of other planes end
    for (const Vec3& p : floor.holes[0]) QVERIFY(p.x >= 2 && p.x <= 3 && p.y >= 1 && p.y <= 2);
    QCOMPARE(floor.area, 31.0);
    QVERIFY_THROWS_EXCEPTION(InputError, planAreas(*mesh, 3));
    QVERIFY(planAreas(NavigationMesh()).empty());
  }
};

QTEST_APPLESS_MAIN(TestGround)
#include "test_ground.moc"
