// Shortest paths: against looking at every way there is, on hand-made, random and real meshes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QtTest>
#include <cmath>
#include <limits>
#include <random>

#include "core/exact/source_predicates.hpp"
#include "core/navigation/path_ground.hpp"
#include "core/navigation/plan_crossing.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/path.hpp"
#include "tests/reference/shortest_path.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Random = std::mt19937_64;

std::shared_ptr<const NavigationMesh> walkable(const Soup& soup, double clearance, double slope = 60) {
  return std::make_shared<NavigationMesh>(
      navigationMesh(runFilters(soup.environment(), minimalPipeline(clearance, slope) + "\nLayerSubdivisionFilter")));
}

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
std::size_t below(Random& random, std::size_t count) { return random() % count; }

/// A place in the middle, on a side or at a corner of a random triangle.
Vec3 anyPlace(const NavigationMesh& mesh, Random& random) {
  const Triangle& f = mesh.triangles[below(random, mesh.triangles.size())];
  const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
  const std::size_t kind = below(random, 4);
  if (kind == 0) return a;
  const double s = uniform(random, 0.1, 0.9), u = kind == 1 ? 0 : uniform(random, 0.05, 0.95) * (1 - s);
  const auto mix = [&](double x, double y, double z) {
    return kind == 1 ? (x + y) / 2 : x + s * (y - x) + u * (z - x);
  };
  return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
}

double sizeOf(const NavigationMesh& mesh) {
  double size = 1;
  for (const Vec3& p : mesh.vertices) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  return size;
}

/// Looks for all that can be wrong with the path between two places; `isCompared` counts those that were compared with
/// every other way.
QString pathError(const PathFinder& finder, const Vec3& from, const Vec3& to, int& isCompared) {
  const NavigationMesh& mesh = finder.mesh();
  const double tolerance = 1e-9 * sizeOf(mesh);
  const PathResult path = finder.find(from, to), back = finder.find(to, from);
  const auto isOff = [](PathStatus s) {
    return s == PathStatus::StartNotWalkable || s == PathStatus::TargetNotWalkable;
  };
  if (isOff(path.status) && isOff(back.status)) return {};  // rounded off the border
  if (path.status != back.status) return "another answer the other way round";
  if (!path.hasPath()) return "no path";
  if (const auto error = reference::findPathError(mesh, path, tolerance); !error.empty())
    return QString::fromStdString(error);
  if (path.reached() && std::fabs(path.planLength - back.planLength) > tolerance) return "not as long the other way";
  const double least =
      std::hypot(path.start->position.x - path.end->position.x, path.start->position.y - path.end->position.y);
  if (path.planLength < least - tolerance) return "shorter than the straight line";
  const double over = reference::lengthOverSidePoints(mesh, *path.start, *path.end, 3);
  if (path.planLength > over + tolerance)
    return QString("%1, but over points of sides it takes %2").arg(path.planLength, 0, 'g', 17).arg(over, 0, 'g', 17);
  if (mesh.triangles.size() > 60) return {};
  if (const auto best = reference::shortestOfAllSequences(mesh, *path.start, *path.end)) {
    ++isCompared;
    if (std::fabs(path.planLength - *best) > tolerance)
      return QString("%1 instead of %2").arg(path.planLength, 0, 'g', 17).arg(*best, 0, 'g', 17);
  }
  return {};
}

/// Rooms in a grid, with walls between most of them.
Soup maze(Random& random, int columns, int rows, double size) {
  Soup soup = Soup().floor(0, 0, columns * size, rows * size, 0);
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y) {
      const double x0 = x * size, y0 = y * size, x1 = x0 + size, y1 = y0 + size;
      if (x + 1 < columns && below(random, 3) != 0) soup.wall(x1, y0, x1, y1, 0, 2);
      if (y + 1 < rows && below(random, 3) != 0) soup.wall(x0, y1, x1, y1, 0, 2);
      if (below(random, 5) == 0) soup.box({x0 + size / 4, y0 + size / 4, 0}, {x1 - size / 4, y1 - size / 4, 1});
    }
  return soup;
}

void compareRandom(const std::shared_ptr<const NavigationMesh>& mesh, Random& random, int pairs, int& compared) {
  if (mesh->triangles.empty()) return;
  const PathFinder finder(mesh);
  for (int i = 0; i < pairs; ++i) {
    const Vec3 from = anyPlace(*mesh, random), to = anyPlace(*mesh, random);
    const QString error = pathError(finder, from, to, compared);
    if (error.isEmpty()) continue;
    const QByteArray message = QString("from (%1, %2, %3) to (%4, %5, %6), %7 triangles: %8")
                                   .arg(from.x, 0, 'g', 17)
                                   .arg(from.y, 0, 'g', 17)
                                   .arg(from.z, 0, 'g', 17)
                                   .arg(to.x, 0, 'g', 17)
                                   .arg(to.y, 0, 'g', 17)
                                   .arg(to.z, 0, 'g', 17)
                                   .arg(mesh->triangles.size())
                                   .arg(error)
                                   .toUtf8();
    QFAIL(message.constData());
  }
}

}  // namespace

class TestPathFinder : public QObject {
  Q_OBJECT
 private slots:
  void nothingIsWalkable() {
    const PathFinder finder(std::make_shared<NavigationMesh>());
    const PathResult path = finder.find({0, 0, 0}, {1, 1, 1});
    QCOMPARE(path.status, PathStatus::NothingWalkable);
    QVERIFY(!path.start && !path.end && !path.hasPath());
    QCOMPARE(describeFailure(path), std::string("nothing is walkable here"));
  }

  void straightOverManyTriangles() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 4, 4, 0).floor(4, 0, 8, 4, 0).floor(8, 0, 12, 4, 0), 2));
    const PathResult path = finder.find({1, 1, 0.5}, {11, 3, 0.5});
    QVERIFY(path.reached());
    QCOMPARE(path.planLength, std::hypot(10, 2));
    QCOMPARE(path.bends.size(), 0U);
    QCOMPARE(path.layers.size(), 1U);
    QCOMPARE(path.points.front(), (Vec3{1, 1, 0}));
    QCOMPARE(path.points.back(), (Vec3{11, 3, 0}));
    QCOMPARE(reference::findPathError(finder.mesh(), path, 1e-12), std::string());
  }

  void aroundTheEndOfAThinWall() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 4, 4, 0).wall(2, 0, 2, 3, 0, 1), 2));
    const PathResult path = finder.find({1, 0, 0}, {3, 0, 0});
    QVERIFY(path.reached());
    QCOMPARE(path.planLength, 2 * std::hypot(1, 3));
    QCOMPARE(path.bends.size(), 1U);
    QCOMPARE(path.points[path.bends[0]], (Vec3{2, 3, 0}));
    // A place on the wall itself belongs to one of its sides, the same one in every call.
    const PathResult onWall = finder.find({2, 1, 0}, {1, 1, 0});
    const PathResult back = finder.find({1, 1, 0}, {2, 1, 0});
    QCOMPARE(onWall.planLength, back.planLength);
  }

  void aClosedRoomIsNotConnected() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 8, 4, 0).wall(4, 0, 4, 4, 0, 1), 2));
    const PathResult path = finder.find({1, 2, 0}, {7, 2, 0});
    QCOMPARE(path.status, PathStatus::NotConnected);
    QVERIFY(path.hasPath());
    QCOMPARE(path.points.back(), (Vec3{4, 2, 0}));
    QCOMPARE(path.end->distance, 3.0);
    QCOMPARE(path.planLength, 3.0);
    QVERIFY(describeFailure(path).find("lies 3 from it") != std::string::npos);
    QCOMPARE(finder.inside()->topology.componentCount, 2U);
  }

  void placesOffTheWalkableArea() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 4, 4, 0), 2));
    const PathResult start = finder.find({6, 2, 0}, {1, 1, 0});
    QCOMPARE(start.status, PathStatus::StartNotWalkable);
    QCOMPARE(start.start->position, (Vec3{4, 2, 0}));
    QCOMPARE(start.start->distance, 2.0);
    QVERIFY(!start.hasPath());
    const PathResult target = finder.find({1, 1, 0}, {1, 7, 0});
    QCOMPARE(target.status, PathStatus::TargetNotWalkable);
    QCOMPARE(target.points.back(), (Vec3{1, 4, 0}));
    QCOMPARE(target.planLength, 3.0);
    // The place is above the floor by more than reach.
    QCOMPARE(finder.find({1, 1, 1.5}, {2, 2, 0}, 1.5).status, PathStatus::Found);
    QCOMPARE(finder.find({1, 1, 1.5}, {2, 2, 0}, 1.25).status, PathStatus::StartNotWalkable);
  }

  void storeysAreToldApart() {
    const PathFinder finder(
        walkable(Soup().floor(0, 0, 4, 4, 0).ramp(4, 0, 8, 2, 0, 3).floor(8, 0, 10, 4, 3).floor(0, 2, 8, 4, 3), 2));
    const PathResult up = finder.find({1, 3, 0.1}, {1, 3, 2.9});
    QVERIFY(up.reached());
    QVERIFY(up.planLength > 14);
    QVERIFY(up.length > up.planLength);
    QVERIFY(up.layers.size() >= 2);
    QCOMPARE(up.connections, up.layers.size() - 1);
    QVERIFY(std::fabs(up.maxSlopeDegrees - std::atan(0.75) * 180 / M_PI) < 1e-9);
    QVERIFY(up.maxInclineDegrees <= up.maxSlopeDegrees);
    QCOMPARE(reference::findPathError(finder.mesh(), up, 1e-9), std::string());
    QCOMPARE(finder.locate({1, 3, 1.4}, kInfinity)->position.z, 0.0);
    QCOMPARE(finder.locate({1, 3, 1.6}, kInfinity)->position.z, 3.0);
  }

  void touchingCornersAreNoWay() {
    const PathFinder finder(walkable(Soup().floor(0, 0, 2, 2, 0).floor(2, 2, 4, 4, 0), 2));
    QCOMPARE(finder.find({1, 1, 0}, {3, 3, 0}).status, PathStatus::NotConnected);
    QCOMPARE(finder.find({1, 1, 0}, {3, 3, 0}).points.back(), (Vec3{2, 2, 0}));
    // Three rooms in a ring, two of which touch at a corner: the way leads around, not through the corner.
    const PathFinder ring(walkable(Soup()
                                       .floor(0, 0, 2, 2, 0)
                                       .floor(2, 2, 4, 4, 0)
                                       .floor(2, -2, 6, 0, 0)
                                       .floor(4, 0, 6, 4, 0)
                                       .floor(0, -2, 2, 0, 0),
                                   2));
    const PathResult around = ring.find({1, 1, 0}, {3, 3, 0});
    QVERIFY(around.reached());
    QCOMPARE(around.planLength, std::hypot(1, 1) + 2 * std::hypot(0, 2) + std::hypot(1, 1));
  }

  void degeneratePlaces() {
    const auto mesh = walkable(Soup().floor(0, 0, 4, 4, 0).wall(2, 1, 2, 3, 0, 1).box({0, 3, 0}, {1, 4, 1}), 2);
    const PathFinder finder(mesh);
    int compared = 0;
    std::vector<Vec3> places = mesh->vertices;
    for (const Triangle& f : mesh->triangles)
      for (int i = 0; i < 3; ++i) {
        const Vec3 &a = mesh->vertices[f[i]], &b = mesh->vertices[f[(i + 1) % 3]];
        places.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
      }
    for (const Vec3& from : places)
      for (const Vec3& to : places) QCOMPARE(pathError(finder, from, to, compared), QString());
    QVERIFY(compared > 100);
    const PathResult same = finder.find({3, 3, 0}, {3, 3, 0});
    QVERIFY(same.reached());
    QCOMPARE(same.points.size(), 1U);
    QCOMPARE(same.length, 0.0);
  }

  void spiralsAroundOnePoint() {  // more than a full turn about a corner, storey above storey
    Soup soup;
    const auto corner = [](int i) {
      const double z = 0.5 * i;
      const std::array<Vec3, 8> ring{Vec3{2, 0, z}, {2, 2, z},   {0, 2, z},  {-2, 2, z},
                                     {-2, 0, z},    {-2, -2, z}, {0, -2, z}, {2, -2, z}};
      return ring[static_cast<std::size_t>(i % 8)];
    };
    for (int i = 0; i < 20; ++i) soup.triangle({0, 0, 0.5 * i}, corner(i), {corner(i + 1).x, corner(i + 1).y, 0.5 * i});
    // A mesh of its own, as steps half a unit high are no surface: one vertex in the middle.
    auto mesh = std::make_shared<NavigationMesh>();
    mesh->vertices = {{0, 0, 0}};
    for (int i = 0; i <= 20; ++i) mesh->vertices.push_back(corner(i));
    for (std::uint32_t i = 1; i <= 20; ++i) mesh->triangles.push_back({0, i, i + 1});
    const PathFinder finder(mesh);
    const PathResult path = finder.find({1.5, 0.5, 0}, {-0.5, 1.5, 9.5});
    QVERIFY(path.reached());
    QCOMPARE(path.bends.size(), 1U);
    QVERIFY(std::fabs(path.planLength - std::hypot(1.5, 0.5) * 2) < 1e-12);
    QVERIFY(path.triangles.size() <= 2);
  }

  void crossingsOfNearlyParallelLines() {
    const Vec3 a{0, 0, 0}, b{3, 1, 0}, c{1e9 * 3, 1e9 + 1e-7, 0}, d{2e9 * 3, 2e9 - 1e-6, 5};
    const double s = crossingParameter(a, b, c, d);
    QVERIFY(s > 0 && s < 1);
    const double up = 1e9 + 1e-7 - 1e9, down = 2e9 - (2e9 - 1e-6);  // the doubles that these decimals became
    QVERIFY(std::fabs(s - up / (up + down)) < 1e-15);
    QCOMPARE(crossingParameter(a, b, {6, 2, 0}, {0, 5, 0}), 0.0);
    QCOMPARE(crossingParameter(a, b, {0, 5, 0}, {6, 2, 0}), 1.0);
    QCOMPARE(crossingParameter({0, 0, 0}, {0x1p-600, 0, 0}, {0, -0x1p-600, 0}, {0, 0x1p-600, 0}), 0.5);
    QCOMPARE(pointBetween({0, 0, 1}, {1, 1, 3}, 0.5), (Vec3{0.5, 0.5, 2}));
  }

  void randomSoups() {
    Random random(seed());
    int compared = 0;
    for (int i = 0; i < rounds(250); ++i) {
      std::vector<PartNumbers> parts(3 + below(random, 5));
      for (auto& part : parts)
        for (int& n : part) n = static_cast<int>(below(random, 64));
      compareRandom(walkable(buildingOf(parts), 1), random, 4, compared);
      if (QTest::currentTestFailed()) return;
    }
    QVERIFY(compared > rounds(250));
  }

  void randomTriangles() {
    Random random(seed() + 1);
    int compared = 0;
    for (int i = 0; i < rounds(250); ++i) {
      Soup soup;
      for (std::size_t k = 0; k < 3 + below(random, 4); ++k) {
        const auto p = [&] { return Vec3{uniform(random, 0, 9), uniform(random, 0, 9), uniform(random, 0, 0.5)}; };
        soup.triangle(p(), p(), p());
      }
      soup.floor(0, 0, 10, 10, 0);
      compareRandom(walkable(soup, 1, 80), random, 4, compared);
      if (QTest::currentTestFailed()) return;
    }
    QVERIFY(compared > rounds(60));
  }

  void randomWalksOverThemselves() {
    Random random(seed() + 2);
    int compared = 0;
    for (int i = 0; i < rounds(150); ++i) {
      std::vector<int> steps(12);
      for (int& step : steps) step = static_cast<int>(below(random, 16));
      compareRandom(walkable(walkOf(steps), 0.5), random, 6, compared);
      if (QTest::currentTestFailed()) return;
    }
    QVERIFY(compared > rounds(300));
  }

  void randomMazes() {
    Random random(seed() + 3);
    int compared = 0;
    for (int i = 0; i < rounds(60); ++i) {
      const int side = 3 + static_cast<int>(below(random, 8));
      compareRandom(walkable(maze(random, side, side, i % 2 == 0 ? 2 : 2.1), 1), random, 4, compared);
      if (QTest::currentTestFailed()) return;
    }
  }

  // Tiles of random heights: steps of up to 0.5 are climbed, and lead round higher ones.
  void randomSteps() {
    Random random(seed() + 5);
    int compared = 0, steps = 0;
    for (int i = 0; i < rounds(60); ++i) {
      Soup soup;
      const int side = 2 + static_cast<int>(below(random, 3));
      for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y) soup.floor(x, y, x + 1, y + 1, 0.3 * static_cast<double>(below(random, 4)));
      const auto mesh = std::make_shared<NavigationMesh>(navigationMesh(
          runFilters(soup.environment(), minimalPipeline(2, 60) + "\nStepFilter 0.5\nLayerSubdivisionFilter")));
      compareRandom(mesh, random, 4, compared);
      if (QTest::currentTestFailed()) return;
      const PathResult path = PathFinder(mesh).find(anyPlace(*mesh, random), anyPlace(*mesh, random));
      steps += static_cast<int>(path.steps.size());
    }
    QVERIFY(compared > 0);
    QVERIFY(steps > 0);
  }

  void realEnvironments_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"nav_test", "complex", "steelribs"}) QTest::newRow(name) << name;
  }

  void realEnvironments() {
    QFETCH(QString, name);
    if (sharedEnvironments().isEmpty()) QSKIP("the shared environments are not here; set FOOTFALL_SHARED");
    RunContext context;
    const auto environment = importEnvironment((sharedEnvironments() + "/" + name + ".obj").toStdString());
    const auto mesh = runPipeline(environment, defaultPipeline(*environment), context).mesh;
    QElapsedTimer timer;
    timer.start();
    const PathFinder finder(mesh);
    const qint64 prepared = timer.elapsed();
    Random random(seed());
    double slowest = 0, sum = 0;
    std::size_t nodes = 0;
    int compared = 0;
    const int pairs = 40;
    for (int i = 0; i < pairs; ++i) {
      const Vec3 from = anyPlace(*mesh, random), to = anyPlace(*mesh, random);
      timer.start();
      const PathResult path = finder.find(from, to);
      const double ms = static_cast<double>(timer.nsecsElapsed()) / 1e6;
      slowest = std::max(slowest, ms), sum += ms, nodes = std::max(nodes, path.expanded);
      if (i < 8) QCOMPARE(pathError(finder, from, to, compared), QString());
    }
    qInfo("%zu triangles, %u parts: prepared in %lld ms, queries %.2f ms on average, %.2f at most (%zu nodes)",
          mesh->triangles.size(), finder.inside()->topology.componentCount, static_cast<long long>(prepared),
          sum / pairs, slowest, nodes);
  }

  void largeMazesTakeMilliseconds() {
    Random random(seed() + 4);
    const auto mesh = walkable(maze(random, 72, 72, 2.1), 1);
    QElapsedTimer timer;
    timer.start();
    const PathFinder finder(mesh);
    const qint64 prepared = timer.elapsed();
    double slowest = 0, sum = 0;
    std::size_t nodes = 0;
    const int pairs = 60;
    for (int i = 0; i < pairs; ++i) {
      const Vec3 from = anyPlace(*mesh, random), to = anyPlace(*mesh, random);
      timer.start();
      const PathResult path = finder.find(from, to);
      const double ms = static_cast<double>(timer.nsecsElapsed()) / 1e6;
      slowest = std::max(slowest, ms), sum += ms, nodes = std::max(nodes, path.expanded);
      if (path.hasPath()) QCOMPARE(reference::findPathError(*mesh, path, 1e-9), std::string());
    }
    qInfo("%zu triangles: prepared in %lld ms, queries %.2f ms on average, %.2f at most (%zu nodes)",
          mesh->triangles.size(), static_cast<long long>(prepared), sum / pairs, slowest, nodes);
    QVERIFY(sum / pairs < 250);  // far above what it takes: builds with sanitizers run it as well
  }

  void cornersThatLieCloseTogetherAreSearchedOnce() {
    // A way around one of these posts is longer by less than what rounding hides.
    Soup soup = Soup().floor(0, 0, 40, 40, 0).wall(20, 0, 20, 19.5, 0, 2).wall(20, 20.5, 20, 40, 0, 2);
    soup.wall(30, 1, 30, 40, 0, 2);
    constexpr double kSmall = 0x1p-40;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y) {
        const double left = 20 + 2 * x * kSmall, low = 20 + 2 * y * kSmall;
        soup.box({left, low, 0}, {left + kSmall, low + kSmall, 2});
      }
    const auto mesh = walkable(soup, 1);
    const PathResult path = PathFinder(mesh).find({1, 20, 0}, {39, 39, 0});
    QVERIFY(path.reached());
    QVERIFY2(path.expanded < 100 * mesh->triangles.size(), qPrintable(QString::number(path.expanded)));
  }

  void anotherThreadMayStopIt() {
    Random random(seed());
    const auto mesh = walkable(maze(random, 30, 30, 2), 1);
    RunContext cancelled;
    const PathFinder finder(mesh, &cancelled);
    cancelled.cancel();
    QVERIFY_EXCEPTION_THROWN(PathFinder(mesh, &cancelled), Cancelled);
    const Vec3 &first = mesh->vertices.front(), &last = mesh->vertices.back();
    QVERIFY_EXCEPTION_THROWN((void)finder.find(first, last, 1e9, &cancelled), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestPathFinder)
#include "test_path_finder.moc"
