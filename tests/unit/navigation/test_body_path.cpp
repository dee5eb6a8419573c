// Paths for a body on the corridor map: known ways around corners, and against runs behind RadiusFilter.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <future>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/mesh/clearance_field.hpp"
#include "core/navigation/corridor_network.hpp"
#include "footfall/body_path.hpp"
#include "footfall/errors.hpp"
#include "footfall/ground.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/slanted_room.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using SharedMesh = std::shared_ptr<const NavigationMesh>;

constexpr double kAnyWidth = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 0.01;  ///< of RadiusFilter

/// The share of the radius that a path keeps from the border everywhere: the cosine of half of 0.1.
const double kKept = std::cos(0.05);

const std::string kBefore = "\nStepFilter 0.4 0.3";

SharedMesh meshOf(const std::shared_ptr<const Environment>& environment, double radius = 0) {
  std::string text = minimalPipeline(0.5, 60) + kBefore;
  if (radius > 0) text += "\nRadiusFilter " + QString::number(radius, 'g', 17).toStdString();
  return std::make_shared<NavigationMesh>(navigationMesh(runFilters(environment, text)));
}
SharedMesh meshOf(const Soup& soup, double radius = 0) { return meshOf(soup.environment(), radius); }

/// A room with a wall without thickness that reaches into it.
Soup roomWithAWall() { return Soup().floor(0, 0, 10, 6, 0).wall(5, 0, 5, 2, 0, 2); }

/// Two doors of 0.8 and of 2, the narrow one on the straight way.
Soup roomWithTwoDoors() {
  return Soup().floor(0, 0, 10, 10, 0).wall(5, 0, 5, 1.6, 0, 2).wall(5, 2.4, 5, 7, 0, 2).wall(5, 9, 5, 10, 0, 2);
}

bool isNear(double a, double b, double share) { return std::fabs(a - b) <= share * std::max(1.0, std::fabs(b)); }

/// How many of the pairs had a way, and what is wrong with one.
struct Tally {
  int ways = 0, none = 0, between = 0;
  double longest = 1;  ///< the largest share by which a way behind the filter was longer
  QString error;
};

/// Ways between places that RadiusFilter left, behind the filter and on the map.
void compare(const SharedMesh& before, const SharedMesh& after, double radius, int pairs, std::uint64_t seed,
             Tally& tally) {
  if (after->triangles.empty()) return;
  const PathFinder behind(after);
  const BodyPathFinder finder(before);
  const auto places = randomPlaces(behind, 2 * static_cast<std::size_t>(pairs), seed);
  const double reach = 0.01;
  for (int i = 0; i < pairs; ++i) {
    const Vec3 from = places[2 * i].position, to = places[(2 * i) + 1].position;
    const PathResult filtered = behind.find(from, to, reach);
    const BodyPath path = finder.find(from, to, {.radius = radius}, reach);
    const BodyPath wider = finder.find(from, to, {.radius = radius * (1 + 2 * kTolerance)}, reach);
    const auto wrong = [&](const char* what) {
      tally.error = QStringLiteral(
                        "%1: from %2 %3 %4 to %5 %6 %7, %8 behind the filter, %9 on the map, %10 with more radius; %11")
                        .arg(what)
                        .arg(from.x, 0, 'g', 17)
                        .arg(from.y, 0, 'g', 17)
                        .arg(from.z)
                        .arg(to.x, 0, 'g', 17)
                        .arg(to.y, 0, 'g', 17)
                        .arg(to.z)
                        .arg(filtered.planLength, 0, 'g', 12)
                        .arg(path.path.planLength, 0, 'g', 12)
                        .arg(wider.path.planLength, 0, 'g', 12)
                        .arg(QString::fromStdString(formatFailure(path, UpAxis::Z)));
    };
    if (filtered.status == PathStatus::StartNotWalkable || filtered.status == PathStatus::TargetNotWalkable) continue;
    if (filtered.reached() && !path.reached()) return wrong("no way on the map");
    if (wider.reached() && !filtered.reached()) return wrong("no way behind the filter");
    if (!filtered.reached()) {
      ++(path.reached() ? tally.between : tally.none);
      continue;
    }
    ++tally.ways;
    const double length = filtered.planLength, slack = 1e-6 + (0.002 * length);
    if (path.path.planLength > length + slack) return wrong("longer than behind the filter");
    if (wider.reached() && length > wider.path.planLength + slack) return wrong("shorter than it may be");
    if (wider.reached() && wider.path.planLength < 1.01 * path.path.planLength) {
      tally.longest = std::max(tally.longest, length / std::max(path.path.planLength, radius));
      if (length > 1.01 * path.path.planLength + slack) return wrong("lengths differ");
    }
    if (path.narrowest && path.narrowest->width < 2 * radius - 1e-9) return wrong("a narrow passage");
  }
}

/// The least distance from a path to the border, at nine places of each of its pieces on the mesh.
double leastDistance(const ClearanceField& field, const PathResult& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.triangles.size(); ++i) {
    if (std::binary_search(path.gaps.begin(), path.gaps.end(), i)) continue;
    const Vec3 &a = path.points[i], &b = path.points[i + 1];
    for (const double share : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0})
      least =
          std::min(least, field.at(path.triangles[i], a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)).distance);
  }
  return least;
}

}  // namespace

class TestBodyPath : public QObject {
  Q_OBJECT

 private slots:
  void goesRoundAWall() {
    const BodyPathFinder finder(meshOf(roomWithAWall()));
    for (const double radius : {0.1, 0.25, 0.5}) {
      const BodyPath path = finder.find({4, 1, 0}, {6, 1, 0}, {.radius = radius});
      QVERIFY(path.reached());
      // Two tangents from a place that is the root of 2 away from the wall's end, and an arc.
      const double tangent = std::sqrt(2 - (radius * radius));
      const double arc = radius * (std::numbers::pi / 2 + 2 * std::asin(radius / std::numbers::sqrt2));
      QVERIFY2(isNear(path.path.planLength, 2 * tangent + arc, 1e-3),
               qPrintable(QString::number(path.path.planLength)));
      QVERIFY(path.path.planLength >= 2 * tangent + arc - 1e-9);
      for (const Vec3& p : path.path.points) QVERIFY(std::hypot(p.x - 5, p.y - 2) >= radius - 1e-9);
      QVERIFY(path.narrowest && path.narrowest->width > 2 * radius);
      QCOMPARE(path.path.points.size(), path.path.triangles.size() + 1);
      // The same the other way round.
      const BodyPath back = finder.find({6, 1, 0}, {4, 1, 0}, {.radius = radius});
      QVERIFY(isNear(back.path.planLength, path.path.planLength, 1e-9));
    }
  }

  // The far floor makes the extent, and with it all that is measured by it, a hundred thousand times the room's size.
  void theFootOfAPlaceIsOnAWay() {
    for (const double far : {0.0, 1e6}) {
      Soup soup = roomWithTwoDoors();
      soup.floor(2, 3, 2.5, 3.5, 3);
      if (far > 0) soup.floor(far, far, far + 1, far + 1, 0);
      const SharedMesh mesh = meshOf(soup);
      const CorridorNetwork network(*mesh, Poll());
      const ClearanceField& field = network.field();
      const FieldSurface& surface = field.surface();
      const double nearly = 8 * field.margin();
      std::mt19937_64 random(7);
      std::uniform_real_distribution<double> number(0, 1);
      int found = 0;
      for (int i = 0; i < 400; ++i) {
        const auto face = static_cast<std::uint32_t>(random() % mesh->triangles.size());
        const double u = number(random), v = number(random) * (1 - u);
        const FieldVector a = surface.corner(face, 0), b = surface.corner(face, 1), c = surface.corner(face, 2);
        const FieldVector p = a + (b - a) * u + (c - a) * v;
        const auto foot = network.footOf(face, p);
        if (!foot) continue;
        ++found;
        const CorridorWay& way = network.ways()[foot->way];
        const double at = way.along(foot->place), astray = 0x1p-36 * surface.scale;
        QVERIFY(at >= way.begin - astray && at <= way.end + astray);
        for (const std::uint32_t feature : way.features) {
          const double distance = lengthOf(field.features()[feature].nearestTo(foot->place) - foot->place);
          QVERIFY2(distance <= foot->distance + nearly, qPrintable(QString::number(distance - foot->distance)));
        }
      }
      QVERIFY2(found > 390, qPrintable(QString::number(found)));
    }
  }

  void goesStraightWhereItCan() {
    const BodyPathFinder finder(meshOf(roomWithAWall()));
    const BodyPath path = finder.find({1, 3, 0}, {9, 3, 0}, {.radius = 0.6});
    QVERIFY(path.reached());
    QVERIFY(isNear(path.path.planLength, 8, 1e-12));
    QVERIFY(path.path.bends.empty());
    const BodyPath nowhere = finder.find({1, 3, 0}, {1, 3, 0}, {.radius = 0.6});
    QVERIFY(nowhere.reached());
    QCOMPARE(nowhere.path.planLength, 0.0);
  }

  void saysWhatIsTooNarrow() {
    const SharedMesh mesh = meshOf(Soup().floor(0, 0, 4, 4, 0).floor(4, 1.5, 6, 2.5, 0).floor(6, 0, 10, 4, 0));
    const BodyPathFinder finder(mesh);
    QVERIFY(finder.find({1, 1, 0}, {9, 3, 0}, {.radius = 0.5}).reached());  // exactly as wide as the passage
    const BodyPath path = finder.find({1, 1, 0}, {9, 3, 0}, {.radius = 0.6});
    QVERIFY(path.status == BodyPathStatus::TooNarrow);
    QVERIFY(path.narrowest);
    QVERIFY(isNear(path.narrowest->width, 1, 1e-12));
    QVERIFY(isNear(path.lacking, 0.2, 1e-12));
    QVERIFY(path.narrowest->place.x >= 4 && path.narrowest->place.x <= 6);
    QVERIFY(formatFailure(path, UpAxis::Z).find("1 wide at ") != std::string::npos);
    const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(formatPathJson(*mesh, path))).object();
    QCOMPARE(json["status"].toString(), QStringLiteral("too_narrow"));
    QCOMPARE(json["narrowest"].toObject()["width"].toDouble(), path.narrowest->width);

    const BodyPath start = finder.find({0.2, 1, 0}, {9, 3, 0}, {.radius = 0.5});
    QVERIFY(start.status == BodyPathStatus::StartTooNear);
    QVERIFY(isNear(start.lacking, 0.3, 1e-12));
    QVERIFY(finder.find({1, 1, 0}, {9.8, 3, 0}, {.radius = 0.5}).status == BodyPathStatus::TargetTooNear);
    QVERIFY(finder.find({1, 1, 0}, {20, 3, 0}, {.radius = 0.5}).status == BodyPathStatus::NoPath);
  }

  void goesStraightThroughConvexRooms() {
    // The borders below and above are straight rows of edges, whose ends are rounded: the nearest one of them is not
    // known in doubles. No other order of gates than the one along the rows may come of that.
    std::mt19937 random(20261128);
    std::uniform_real_distribution<double> share(0, 1);
    int found = 0;
    for (int i = 0; i < 150; ++i) {
      const SlantedRoom room(i % 3 == 0 ? 10 : 20, random);
      const BodyPathFinder finder(std::make_shared<NavigationMesh>(room.mesh()));
      for (int k = 0; k < 5; ++k) {
        const double x[] = {share(random), share(random)}, y[] = {share(random), share(random)};
        const Vec3 from = room.at(x[0], y[0]), to = room.at(x[1], y[1]);
        const BodyPath path = finder.find(from, to, {.radius = 0.05 + 0.3 * share(random)});
        QVERIFY(path.status != BodyPathStatus::TooNarrow && path.status != BodyPathStatus::NoPath);
        if (!path.reached()) continue;
        ++found;
        const double straight = std::hypot(to.x - from.x, to.y - from.y);
        QVERIFY2(path.path.planLength <= straight * (1 + 1e-12) + 1e-9,
                 qPrintable(QStringLiteral("room %1, pair %2: %3 for %4")
                                .arg(i)
                                .arg(k)
                                .arg(path.path.planLength, 0, 'g', 17)
                                .arg(straight, 0, 'g', 17)));
      }
    }
    QVERIFY(found > 500);
  }

  void keepsTheRadiusWhereThereIsNoMoreRoom() {
    // A pillar's corner and a wall are the agent's width apart, exactly, and a little more.
    for (const double room : {0.0, 0.0001, 0.001, 0.01}) {
      const double radius = 0.5;
      const SharedMesh mesh =
          meshOf(Soup().floor(0, 0, 12, 6, 0).box({5, 1 + room, -1}, {5.5, 6.5, 2}).box({5.2, 1.3, -1}, {7, 6.5, 2}));
      const BodyPath path = BodyPathFinder(mesh).find({1, 5, 0}, {11, 5, 0}, {.radius = radius});
      QVERIFY(path.reached());
      const ClearanceField field(*mesh);
      QVERIFY(leastDistance(field, path.path) >= radius * kKept - 0x1p-36 * field.surface().scale);
    }
  }

  void prefersWidth() {
    const BodyPathFinder finder(meshOf(roomWithTwoDoors()));
    const Vec3 from{2, 2, 0}, to{8, 2, 0};
    const auto widthFor = [&](const BodyPathOptions& options) {
      const BodyPath path = finder.find(from, to, options);
      return path.reached() ? path.narrowest->width : -1;
    };
    QVERIFY(isNear(widthFor({.radius = 0.3}), 0.8, 1e-9));
    QVERIFY(isNear(widthFor({.radius = 0.3, .preferredWidth = 0.7}), 0.8, 1e-9));
    QVERIFY(isNear(widthFor({.radius = 0.3, .preferredWidth = 1.5}), 2, 1e-9));
    QVERIFY(isNear(widthFor({.radius = 0.3, .preferredWidth = kAnyWidth}), 2, 1e-9));
    QVERIFY(isNear(widthFor({.radius = 0.5}), 2, 1e-9));
    QVERIFY(widthFor({.radius = 1.1}) < 0);
  }

  void takesTheShorterSide() {
    // A pillar that is nearer to one side: the axis is shorter on the other one.
    const BodyPathFinder finder(meshOf(Soup().floor(0, 0, 20, 20, 0).box({9, 4, -1}, {11, 12, 2})));
    const BodyPath path = finder.find({5, 7, 0}, {15, 7, 0}, {.radius = 0.5});
    QVERIFY(path.reached());
    for (const Vec3& p : path.path.points) QVERIFY(p.y < 8);
  }

  void refusesWhatIsNoBody() {
    const BodyPathFinder finder(meshOf(roomWithAWall()));
    for (const double radius : {0.0, -1.0, kAnyWidth, std::nan("")})
      QVERIFY_THROWS_EXCEPTION(InputError, (void)finder.find({1, 3, 0}, {9, 3, 0}, {.radius = radius}));
    QVERIFY_THROWS_EXCEPTION(InputError, (void)finder.find({1, 3, 0}, {9, 3, 0}, {.radius = 1, .preferredWidth = -1}));
    QVERIFY_THROWS_EXCEPTION(InputError, (void)finder.find({std::nan(""), 3, 0}, {9, 3, 0}, {.radius = 1}));
    QVERIFY(BodyPathFinder(std::make_shared<NavigationMesh>()).find({}, {}, {.radius = 1}).status ==
            BodyPathStatus::NoPath);
  }

  void isAsBehindTheFilterOnRandomBuildings() {
    Tally tally;
    std::mt19937 random(20261127);
    std::uniform_int_distribution<int> number(0, 63), partCount(4, 14);
    for (int i = 0; i < 40; ++i) {
      std::vector<PartNumbers> parts(static_cast<std::size_t>(partCount(random)));
      for (PartNumbers& part : parts)
        for (int& n : part) n = number(random);
      const auto environment = buildingOf(parts).environment();
      const double radius = 0.05 + (0.02 * (i % 10));
      compare(meshOf(environment), meshOf(environment, radius), radius, 25, static_cast<std::uint64_t>(i), tally);
      QVERIFY2(tally.error.isEmpty(),
               qPrintable(QStringLiteral("building %1, radius %2: %3").arg(i).arg(radius).arg(tally.error)));
    }
    qInfo("%d ways, %d pairs without, %d between, longer by %.4f at most", tally.ways, tally.none, tally.between,
          tally.longest - 1);
    QVERIFY(tally.ways > 300 && tally.none > 50);
  }

  void isAsBehindTheFilterOnSamples_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("radius");
    QTest::newRow("villa") << "villa" << 0.3;
    QTest::newRow("house, 0.6") << "house" << 0.6;
    QTest::newRow("arena") << "arena" << 0.3;
    QTest::newRow("house, 0.25") << "house" << 0.25;
  }
  void isAsBehindTheFilterOnSamples() {
    QFETCH(QString, name);
    QFETCH(double, radius);
    const auto environment =
        importEnvironment(QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name).toStdString());
    const SharedMesh mesh = meshOf(environment);
    Tally tally;
    compare(mesh, meshOf(environment, radius), radius, 60, 7, tally);
    QVERIFY2(tally.error.isEmpty(), qPrintable(tally.error));
    QVERIFY(tally.ways > 10);

    const BodyPathFinder finder(mesh);
    const ClearanceField field(*mesh);
    const auto places = randomPlaces(finder.pointFinder(), 120, 3);
    int found = 0;
    for (std::size_t i = 0; i < places.size(); i += 2) {
      const BodyPath path = finder.find(places[i].position, places[i + 1].position, {.radius = radius}, 0.01);
      if (!path.reached()) {
        if (!path.admissible) continue;
        // The place that is named is far enough.
        const auto place = finder.pointFinder().locate(*path.admissible, 0.01);
        QVERIFY(place);
        QVERIFY(field.at(place->triangle, place->position.x, place->position.y).distance >= radius - 1e-9);
        continue;
      }
      ++found;
      // docs/how-to/corridors.md#what-is-promised
      QVERIFY(leastDistance(field, path.path) >= radius * kKept - 0x1p-36 * field.surface().scale);
    }
    QVERIFY(found > 5);
  }

  void searchesNothingWhereNotEvenAPointGets() {
    // Two rooms apart, each with so much in it that a search has something to do.
    Soup soup;
    for (const double x : {0.0, 40.0}) {
      soup.floor(x, 0, x + 20, 20, 0);
      for (int i = 0; i < 6; ++i)
        soup.box({x + 2 + 3 * i, i % 2 == 0 ? 0.0 : 2.0, -1}, {x + 3 + 3 * i, i % 2 == 0 ? 18.0 : 20.0, 2});
    }
    const BodyPathFinder finder(meshOf(soup));
    const BodyPath path = finder.find({1, 1, 0}, {58, 19, 0}, {.radius = 0.3});
    QVERIFY(path.status == BodyPathStatus::NoPath);
    QVERIFY(path.path.status == PathStatus::NotConnected);
    QCOMPARE(path.path.expanded, std::size_t{0});
    QVERIFY(path.path.points.empty());
    // The rest is what the search for a point finds.
    const PathResult point = finder.pointFinder().find({1, 1, 0}, {58, 19, 0});
    QVERIFY(point.expanded > 0);
    QCOMPARE(path.path.end->position, point.end->position);
    QCOMPARE(path.path.target->triangle, point.target->triangle);
    QCOMPARE(formatFailure(path, UpAxis::Z), describeFailure(point));
  }

  void isTheSameOnAnyThread() {
    const BodyPathFinder finder(meshOf(importEnvironment(FOOTFALL_SOURCE_DIR "/samples/house/house.obj")));
    const auto places = randomPlaces(finder.pointFinder(), 40, 5);
    const auto findAll = [&] {
      std::vector<std::vector<Vec3>> points;
      for (std::size_t i = 0; i < places.size(); i += 2)
        points.push_back(finder.find(places[i].position, places[i + 1].position, {.radius = 0.3}, 0.01).path.points);
      return points;
    };
    const auto alone = findAll();
    std::vector<std::future<std::vector<std::vector<Vec3>>>> others;
    for (int i = 0; i < 3; ++i) others.push_back(std::async(std::launch::async, findAll));
    for (auto& other : others) QVERIFY(other.get() == alone);
  }

  void standsOnBordersAndLinks() {
    // Two floors, the second one higher by a step, and one apart.
    const BodyPathFinder finder(meshOf(Soup().floor(0, 0, 4, 4, 0).floor(4, 0, 8, 4, 0.3).floor(20, 0, 24, 4, 0)));
    const BodyPath over = finder.find({1, 2, 0}, {7, 2, 0.3}, {.radius = 0.5});
    QVERIFY(over.reached());
    QVERIFY(isNear(over.path.planLength, 6, 1e-12));
    QCOMPARE(over.path.steps.size(), std::size_t{1});
    QVERIFY(isNear(over.path.climb, 0.3, 1e-12));
    // From the step's edge itself, and from there to there.
    QVERIFY(finder.find({4, 2, 0}, {7, 2, 0.3}, {.radius = 0.5}).reached());
    const BodyPath same = finder.find({4, 2, 0}, {4, 2, 0}, {.radius = 0.5});
    QVERIFY(same.reached());
    QCOMPARE(same.path.planLength, 0.0);
    // On a border, and at a corner of it.
    const BodyPath border = finder.find({0, 2, 0}, {7, 2, 0.3}, {.radius = 0.5});
    QVERIFY(border.status == BodyPathStatus::StartTooNear);
    QCOMPARE(border.startDistance, 0.0);
    QVERIFY(isNear(border.lacking, 0.5, 1e-12));
    QVERIFY(border.admissible);
    QVERIFY(finder.find(*border.admissible, {7, 2, 0.3}, {.radius = 0.5}).reached());
    QVERIFY(finder.find({7, 2, 0.3}, {8, 4, 0.3}, {.radius = 0.5}).status == BodyPathStatus::TargetTooNear);
    QVERIFY(finder.find({1, 2, 0}, {22, 2, 0}, {.radius = 0.5}).status == BodyPathStatus::NoPath);
    // Nowhere is such an agent's place.
    const BodyPath nowhere = finder.find({22, 2, 0}, {22, 3, 0}, {.radius = 2.5});
    QVERIFY(nowhere.status == BodyPathStatus::StartTooNear && !nowhere.admissible);
    QVERIFY(formatFailure(nowhere, UpAxis::Z).find("no place of its part") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(TestBodyPath)
#include "test_body_path.moc"
