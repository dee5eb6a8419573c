// Paths over drops: which are taken, and how long the way is.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "core/mesh/surface_topology.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "tests/support/drop_cases.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Vec3 between(const std::array<Vec3, 2>& ends, double t) {
  const auto& [a, b] = ends;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// The shortest way over drops at `count` places of each, from the paths between each two of them: no shorter than the
/// shortest way there is. Infinite when there is none.
double lengthOverPlaces(const PathFinder& finder, const Vec3& from, const Vec3& to, int count) {
  const NavigationMesh& mesh = finder.mesh();
  const SurfaceTopology topology = makeSurfaceTopology(mesh);
  struct Place {
    Vec3 start, landing;
    std::uint32_t before, behind;
    double reached = kInfinity;
    bool isDone = false;
  };
  std::vector<Place> places;
  for (const DropLink& drop : mesh.drops) {
    const std::uint32_t before = topology.components[drop.fromTriangle], behind = topology.components[drop.toTriangle];
    for (int i = 0; i < count && before != behind; ++i) {
      const double t = count == 1 ? 0.5 : static_cast<double>(i) / (count - 1);
      places.push_back({between(drop.start, t), between(drop.landing, t), before, behind});
    }
  }
  const auto walk = [&](const Vec3& a, const Vec3& b) {
    const PathResult path = finder.find(a, b, 1e-6);
    return path.reached() && path.drops.empty() ? path.planLength : kInfinity;
  };
  for (Place& p : places) p.reached = walk(from, p.start) + planDistance(p.start, p.landing);
  for (;;) {
    const auto next =
        std::ranges::min_element(places, {}, [](const Place& p) { return p.isDone ? kInfinity : p.reached; });
    if (next == places.end() || next->isDone || next->reached == kInfinity) break;
    next->isDone = true;
    for (Place& p : places)
      if (!p.isDone && p.before == next->behind)
        p.reached =
            std::min(p.reached, next->reached + walk(next->landing, p.start) + planDistance(p.start, p.landing));
  }
  double shortest = kInfinity;
  for (const Place& p : places)
    if (p.isDone) shortest = std::min(shortest, p.reached + walk(p.landing, to));
  return shortest;
}

/// Boxes of some heights beside and on each other.
Soup terraces(std::mt19937& random) {
  Soup soup = Soup().floor(0, 0, 8, 8, 0);
  for (int i = 0; i < 4; ++i) {
    const auto number = [&](int below) { return static_cast<double>(random() % static_cast<unsigned>(below)); };
    const double x = number(6), y = number(6);
    soup.box({x, y, 0}, {x + 1 + number(2), y + 1 + number(2), 0.375 + 0.375 * number(4)});
  }
  return soup;
}

Vec3 middleOf(const NavigationMesh& mesh, std::size_t triangle) {
  Vec3 p;
  for (const std::uint32_t v : mesh.triangles[triangle])
    p = {p.x + mesh.vertices[v].x / 3, p.y + mesh.vertices[v].y / 3, p.z + mesh.vertices[v].z / 3};
  return p;
}

/// True when each drop of a path begins on a stretch of the mesh's drops.
bool startsOnDrops(const NavigationMesh& mesh, const PathResult& path, double tolerance) {
  return std::ranges::all_of(path.drops, [&](std::size_t piece) {
    const Vec3& p = path.points[piece];
    return std::ranges::any_of(mesh.drops, [&](const DropLink& drop) {
      const Vec3 &a = drop.start[0], &b = drop.start[1];
      return planDistance(a, p) + planDistance(p, b) <= planDistance(a, b) + tolerance;
    });
  });
}

std::shared_ptr<const NavigationMesh> meshOf(const Soup& soup, const std::string& filters, double clearance = 2) {
  return std::make_shared<const NavigationMesh>(dropped(soup, filters, clearance));
}

}  // namespace

class TestDropPaths : public QObject {
  Q_OBJECT

 private slots:
  void pathsDrop() {
    const Soup soup = Soup().floor(0, 0, 10, 4, 0).box({0, 0, 0}, {2, 4, 2}).box({2, 0, 0}, {4, 4, 1});
    const auto mesh = std::make_shared<const NavigationMesh>(dropped(soup, "SimplificationFilter\n" + drops(1), 3));
    const PathFinder finder(mesh);
    const PathResult path = finder.find({1, 1, 2}, {9, 1, 0});
    QVERIFY(path.reached());
    QCOMPARE(path.drops.size(), std::size_t{2});
    QCOMPARE(path.deepestDrop, 1.0);
    QCOMPARE(path.planLength, 8.0);
    QCOMPARE(path.length, 10.0);
    QCOMPARE(path.descent, 2.0);
    QCOMPARE(path.triangles.size() + 1, path.points.size());
    for (const std::size_t piece : path.drops) QCOMPARE(path.points[piece].z - path.points[piece + 1].z, 1.0);
    QVERIFY(formatPath(path, UpAxis::Z).find("drops    2, one way down; the deepest 1\n") != std::string::npos);
    const PathResult back = finder.find({9, 1, 0}, {1, 1, 2});
    QCOMPARE(back.status, PathStatus::NotConnected);
    QVERIFY(back.leadsBack);
    QVERIFY(describeFailure(back).find("no way leads back up") != std::string::npos);
    QVERIFY(!path.leadsBack);
    QCOMPARE(findComponents(*mesh).list.size(), std::size_t{3});  // two ways only
  }

  // The drop straight ahead ends in front of a wall that leads far round; the one behind the start does not.
  void theShortestWayCountsAndNotTheNearestDrop() {
    const Soup soup = platform(1).wall(5.5, 0.25, 5.5, 8, 0, 4).wall(0, 8, 8, 8, 0, 4);
    const PathFinder finder(meshOf(soup, "SimplificationFilter\n" + drops(1)));
    const Vec3 from{4.75, 4.75, 1}, to{6, 7.75, 0};
    const PathResult path = finder.find(from, to);
    QVERIFY(path.reached());
    QCOMPARE(path.drops.size(), std::size_t{1});
    // The way goes round the end of the wall, straight from the start.
    const double expected = planDistance(from, {5.5, 0.25, 0}) + planDistance({5.5, 0.25, 0}, to);
    QVERIFY2(std::fabs(path.planLength - expected) < 1e-6, qPrintable(QString::number(path.planLength, 'g', 17)));
    QVERIFY(path.leastPlanLength <= path.planLength && path.leastPlanLength * 1.01 >= path.planLength);
  }

  // Out to the edge of a slab and back under it: like light off a mirror.
  void aWayThatTurnsBackUnderTheLedge() {
    const Soup soup = Soup().floor(0, 0, 8, 8, 0).floor(0, 0, 4, 8, 3).ceiling(0, 0, 4, 8, 2.75);
    const PathFinder finder(meshOf(soup, drops(3)));
    const PathResult path = finder.find({2, 2, 3}, {3, 6, 0}, 0.5);
    QVERIFY(path.reached());
    const double expected = std::hypot(6 - 2, (4 - 2) + (4 - 3));
    QVERIFY2(std::fabs(path.planLength - expected) < 1e-6, qPrintable(QString::number(path.planLength, 'g', 17)));
    QVERIFY(path.leastPlanLength <= path.planLength + 1e-9);
  }

  void withoutDropsTheLengthIsTheLeast() {
    const PathFinder finder(meshOf(platform(1), drops(1)));
    const PathResult path = finder.find({1, 1, 0}, {7, 7, 0});
    QVERIFY(path.reached() && path.drops.empty());
    QCOMPARE(path.leastPlanLength, path.planLength);
  }

  void theNearestPlaceIsReachedOverDrops() {
    // An island behind a wide moat: one drops from the platform and walks up to the shore.
    const Soup soup = platform(1).floor(12, 0, 16, 8, 0);
    const PathFinder finder(meshOf(soup, drops(1)));
    for (const double reach : {kInfinity, 0.5}) {
      const Vec3 to{13, 4, reach == kInfinity ? 0.0 : -3.0};
      const PathResult path = finder.find({4, 4, 1}, to, reach);
      QCOMPARE(path.status, reach == kInfinity ? PathStatus::NotConnected : PathStatus::TargetNotWalkable);
      QCOMPARE(path.drops.size(), std::size_t{1});
      QCOMPARE(path.points.back(), (Vec3{8, 4, 0}));
      QCOMPARE(path.end->position, (Vec3{8, 4, 0}));
      QCOMPARE(path.planLength, 4.0);
    }
    // There is no path from below.
    const PathResult below = finder.find({1, 1, 0}, {4, 4, 1});
    QCOMPARE(below.status, PathStatus::NotConnected);
    QVERIFY(below.leadsBack && below.drops.empty());
  }

  void notLongerThanOverManyPlacesAndNotShorterThanIsProven() {
    std::mt19937 random(3);
    std::size_t compared = 0, several = 0, needles = 0;
    for (int i = 0; i < rounds(160); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 12000 + static_cast<std::uint64_t>(i));
      const bool isTerraces = i % 2 == 0;
      const double clearance = isTerraces ? 0.25 : one.clearance;
      if (clearance < 1e-6) continue;
      const std::string filters = "SimplificationFilter\n" + drops(4 * clearance, 0.5 * clearance);
      std::shared_ptr<const NavigationMesh> mesh;
      try {
        mesh = meshOf(isTerraces ? terraces(random) : one.soup, filters, clearance);
      } catch (const InputError&) {  // too small a height beside the coordinates
        continue;
      }
      if (mesh->drops.empty() || mesh->drops.size() > (isTerraces ? 60 : 24)) continue;
      const PathFinder finder(mesh);
      double extent = 0;
      for (const Vec3& v : mesh->vertices) extent = std::max({extent, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
      const double tolerance = 1e-9 * extent;
      for (int k = 0; k < 4; ++k) {
        std::array<Vec3, 6> places;
        for (Vec3& p : places) p = middleOf(*mesh, random() % mesh->triangles.size());
        const auto [to, from] = std::ranges::minmax(places, {}, &Vec3::z);
        const PathResult path = finder.find(from, to, 1e-6 * extent);
        if (!path.reached() || path.drops.empty()) continue;
        const QString what = QString("case %1: %2, proven %3")
                                 .arg(i)
                                 .arg(path.planLength, 0, 'g', 17)
                                 .arg(path.leastPlanLength, 0, 'g', 17);
        QVERIFY2(path.leastPlanLength <= path.planLength, qPrintable(what));
        // A needle may hold no doubles but its corners.
        if (path.planLength > 1.01 * path.leastPlanLength + tolerance && !startsOnDrops(*mesh, path, tolerance)) {
          ++needles;
          continue;
        }
        QVERIFY2(path.planLength <= 1.01 * path.leastPlanLength + tolerance, qPrintable(what));
        const double over = lengthOverPlaces(finder, from, to, isTerraces ? 3 : 5);
        QVERIFY2(path.leastPlanLength <= over + tolerance,
                 qPrintable(what + QString(", over places %1").arg(over, 0, 'g', 17)));
        double length = 0;
        for (std::size_t n = 0; n < path.triangles.size(); ++n)
          length += planDistance(path.points[n], path.points[n + 1]);
        QVERIFY2(std::fabs(length - path.planLength) <= tolerance, qPrintable(what));
        ++compared;
        several += path.drops.size() > 1 ? 1 : 0;
      }
    }
    qInfo("%zu ways compared, %zu of them over several drops", compared, several);
    QVERIFY(compared > 40 && several > 10 && needles * 20 < compared);
  }
};

QTEST_GUILESS_MAIN(TestDropPaths)
#include "test_drop_paths.moc"
