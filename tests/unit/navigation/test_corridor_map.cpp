// The corridor map: properties that hold everywhere, and known bottlenecks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonDocument>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "core/base/disjoint_sets.hpp"
#include "core/mesh/clearance_field.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/slanted_room.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

NavigationMesh meshOf(const Soup& soup) {
  return navigationMesh(
      runFilters(soup.environment(), minimalPipeline(0.5, 60) + "\nStepFilter 0.4 0.3\nLayerSubdivisionFilter"));
}

/// Two rooms of 4 by 4, and a passage between them that is 1 wide and 2 long.
Soup twoRooms() { return Soup().floor(0, 0, 4, 4, 0).floor(4, 1.5, 6, 2.5, 0).floor(6, 0, 10, 4, 0); }

double inPlan(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double sizeOf(const NavigationMesh& mesh) {
  double size = 0;
  for (const Vec3& p : mesh.vertices) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  return size;
}

double areaOf(const CorridorMap& map) {
  return std::accumulate(map.edges.begin(), map.edges.end(), 0.0,
                         [](double sum, const CorridorEdge& edge) { return sum + edge.area; });
}

/// The number of holes of each part of the walkable area.
std::vector<int> holesOf(const FieldSurface& surface) {
  std::vector<int> characteristics;  // corners less edges and faces: 1 less for each hole
  const auto at = [&](Index part) -> int& {
    characteristics.resize(std::max(characteristics.size(), static_cast<std::size_t>(part) + 1));
    return characteristics[static_cast<std::size_t>(part)];
  };
  const auto& parts = surface.topology.components;
  std::vector<char> isDone(surface.topology.fanVertices.size(), 0);
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    if (!surface.takesPart(f)) continue;
    ++at(parts[f]);
    for (const std::uint32_t fan : surface.topology.fans[f])
      if (std::exchange(isDone[fan], 1) == 0) ++at(parts[f]);
  }
  for (const FieldEdge& edge : surface.edges) --at(parts[edge.faces[0]]);
  std::vector<int> holes;
  for (const int characteristic : characteristics) holes.push_back(1 - characteristic);
  return holes;
}

/// The first part whose map hangs together in another way than the part does: a map has one cycle around each hole.
QString wrongPart(const NavigationMesh& mesh) {
  const CorridorMap map = makeCorridorMap(mesh, {.full = true});
  const ClearanceField field(mesh);
  const std::vector<int> holes = holesOf(field.surface());
  DisjointSets sets(map.vertices.size());
  std::vector<int> cycles(holes.size(), 0), pieces(holes.size(), 0);
  const auto partOf = [&](std::uint32_t v) {
    return static_cast<std::size_t>(field.surface().topology.components[map.vertices[v].triangle]);
  };
  for (const CorridorEdge& edge : map.edges) {
    sets.unite(static_cast<Index>(edge.from), static_cast<Index>(edge.to));
    ++cycles[partOf(edge.from)];
  }
  for (std::uint32_t v = 0; v < map.vertices.size(); ++v) {
    --cycles[partOf(v)];
    if (sets.find(static_cast<Index>(v)) == static_cast<Index>(v)) ++cycles[partOf(v)], ++pieces[partOf(v)];
  }
  for (std::size_t part = 0; part < holes.size(); ++part)
    if (pieces[part] != 1 || cycles[part] != holes[part])
      return QStringLiteral("part %1: %2 pieces with %3 cycles, for %4 holes")
          .arg(part)
          .arg(pieces[part])
          .arg(cycles[part])
          .arg(holes[part]);
  return {};
}

/// The error of a map; empty when there is none.
QString errorOf(const NavigationMesh& mesh, const CorridorMap& map) {
  const ClearanceField field(mesh);
  const double tolerance = 1e-9 * (1 + sizeOf(mesh));
  const auto text = [](const char* what, const Vec3& p) {
    return QStringLiteral("%1 at %2 %3 %4").arg(what).arg(p.x, 0, 'g', 12).arg(p.y, 0, 'g', 12).arg(p.z);
  };
  for (const CorridorVertex& vertex : map.vertices) {
    if (vertex.triangle >= mesh.triangles.size()) return text("a triangle out of range", vertex.place);
    const double distance = field.at(vertex.triangle, vertex.place.x, vertex.place.y).distance;
    if (std::fabs(2 * distance - vertex.width) > tolerance && mesh.links.empty())
      return text("another width", vertex.place);
  }
  for (const CorridorEdge& edge : map.edges) {
    const CorridorVertex* ends[] = {&map.vertices[edge.from], &map.vertices[edge.to]};
    for (int i = 0; i < 2; ++i)
      for (const Vec3& border : {edge.left[i], edge.right[i]})
        if (std::fabs(2 * inPlan(ends[i]->place, border) - ends[i]->width) > 2 * tolerance)
          return text("a border that is not as far", ends[i]->place);
    if (edge.width > std::min(ends[0]->width, ends[1]->width) + tolerance) return text("a wide edge", edge.narrowest);
    if (edge.length < inPlan(ends[0]->place, ends[1]->place) - tolerance) return text("a short edge", edge.narrowest);
  }
  for (const Bottleneck& b : map.bottlenecks) {
    if (std::fabs(inPlan(b.left, b.right) - b.width) > 1.1e-3 * b.width + tolerance)
      return text("borders that are not opposite", b.place);
    for (const BottleneckSide& side : b.sides)
      if (map.vertices[side.widest].width < b.width * (1 - 1e-5)) return text("a side without a wider place", b.place);
  }
  return {};
}

}  // namespace

class TestCorridorMap : public QObject {
  Q_OBJECT

 private slots:
  void findsAPassage() {
    const CorridorMap map = makeCorridorMap(meshOf(twoRooms()));
    QCOMPARE(map.bottlenecks.size(), std::size_t{1});
    const Bottleneck& b = map.bottlenecks[0];
    QCOMPARE(b.width, 1.0);
    QCOMPARE(b.place, (Vec3{b.place.x, 2, 0}));
    QVERIFY(b.place.x > 4 && b.place.x < 6);
    QCOMPARE(std::min(b.left.y, b.right.y), 1.5);
    QCOMPARE(std::max(b.left.y, b.right.y), 2.5);
    QVERIFY(b.isOnlyWay);
    QVERIFY(std::fabs(b.sides[0].area + b.sides[1].area - 34) < 1e-9);
    QVERIFY(std::fabs(b.sides[0].area - 17) < 1e-9);
    for (const BottleneckSide& side : b.sides) QVERIFY(map.vertices[side.widest].width > 3);
  }

  void ofARoughPassageOnePlaceIsProminent() {
    // The passage is as narrow at three places, and 2 % wider between them.
    Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(9, 0, 13, 4, 0);
    for (int i = 0; i < 5; ++i) soup.floor(4 + i, i % 2 == 0 ? 1.5 : 1.49, 5 + i, i % 2 == 0 ? 2.5 : 2.51, 0);
    const CorridorMap map = makeCorridorMap(meshOf(soup));
    QCOMPARE(map.bottlenecks.size(), std::size_t{3});
    std::vector<double> prominences;
    for (const Bottleneck& b : map.bottlenecks) {
      QCOMPARE(b.width, 1.0);
      prominences.push_back(prominence(map, b));
    }
    QVERIFY(prominences[0] > 2.5);
    for (const std::size_t i : {1, 2}) QVERIFY(prominences[i] > 0 && prominences[i] < 0.03);
  }

  void doorsOfOneRoomAreAllProminent() {
    // Three rooms in a row, with two passages of the same width.
    const Soup soup = twoRooms().floor(10, 1.5, 12, 2.5, 0).floor(12, 0, 16, 4, 0);
    const CorridorMap map = makeCorridorMap(meshOf(soup));
    QCOMPARE(map.bottlenecks.size(), std::size_t{2});
    for (const Bottleneck& b : map.bottlenecks) QVERIFY(prominence(map, b) > 2);
  }

  void findsADoorWithoutThickness() {
    // The wall is a rectangle, and the door an opening of 0.9 between two corners.
    const Soup soup = Soup().floor(0, 0, 10, 4, 0).wall(5, 0, 5, 1.5, -0.5, 2).wall(5, 2.4, 5, 4, -0.5, 2);
    const CorridorMap map = makeCorridorMap(meshOf(soup));
    QCOMPARE(map.bottlenecks.size(), std::size_t{1});
    const Bottleneck& b = map.bottlenecks[0];
    QVERIFY(std::fabs(b.width - 0.9) < 1e-9);
    QVERIFY(std::fabs(b.place.x - 5) < 1e-9 && std::fabs(b.place.y - 1.95) < 1e-9);
    QVERIFY(b.isOnlyWay);
    QVERIFY(std::fabs(b.sides[0].area - 20) < 1e-9 && std::fabs(b.sides[1].area - 20) < 1e-9);
  }

  void knowsThatAWayLeadsRound() {
    // A pillar in the middle: a bottleneck on each side of it, none the only way.
    const CorridorMap map = makeCorridorMap(meshOf(Soup().floor(0, 0, 12, 6, 0).box({5, 2, -1}, {7, 3, 2})));
    QCOMPARE(map.bottlenecks.size(), std::size_t{2});
    QVERIFY(std::fabs(map.bottlenecks[0].width - 2) < 1e-9);
    QVERIFY(std::fabs(map.bottlenecks[1].width - 3) < 1e-9);
    for (const Bottleneck& b : map.bottlenecks) QVERIFY(!b.isOnlyWay);
  }

  void hasOneCycleAroundEachHole() {
    std::mt19937 random(20261128);
    for (int i = 0; i < 300; ++i)
      QVERIFY2(wrongPart(SlantedRoom(20, random).mesh()).isEmpty(), qPrintable(QStringLiteral("room %1").arg(i)));
    for (const char* name : {"house", "villa", "arena"}) {
      const auto environment =
          importEnvironment(QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name).toStdString());
      const QString error = wrongPart(
          navigationMesh(runFilters(environment, "SlopeFilter 45 0\nVerticalClearanceFilter 2\nStepFilter 0.4")));
      QVERIFY2(error.isEmpty(), qPrintable(name + QStringLiteral(", ") + error));
    }
  }

  void leavesConvexCornersOut() {
    const NavigationMesh mesh = meshOf(Soup().floor(0, 0, 6, 2, 0));
    const CorridorMap map = makeCorridorMap(mesh), full = makeCorridorMap(mesh, {.full = true});
    QCOMPARE(map.edges.size(), std::size_t{1});
    QCOMPARE(map.edges[0].length, 4.0);
    QCOMPARE(map.edges[0].width, 2.0);
    QCOMPARE(full.edges.size(), std::size_t{5});
    QVERIFY(std::fabs(areaOf(full) - 12) < 1e-12);
    QVERIFY(map.bottlenecks.empty());  // nothing is wider than the corridor
    // A square has no edge, and its middle all the same.
    const CorridorMap square = makeCorridorMap(meshOf(Soup().floor(0, 0, 2, 2, 0)));
    QVERIFY(square.edges.empty());
    QCOMPARE(square.vertices.size(), std::size_t{1});
    QCOMPARE(square.vertices[0].place, (Vec3{1, 1, 0}));
  }

  void goesOverSteps() {
    // The second room is 0.3 higher.
    const CorridorMap map = makeCorridorMap(meshOf(Soup().floor(0, 0, 4, 2, 0).floor(4, 0, 8, 2, 0.3)));
    QVERIFY(std::any_of(map.edges.begin(), map.edges.end(), [&](const CorridorEdge& edge) {
      return map.vertices[edge.from].place.z != map.vertices[edge.to].place.z;
    }));
    for (const CorridorEdge& edge : map.edges) QCOMPARE(edge.width, 2.0);
  }

  void isRightOnRandomBuildings() {
    QVERIFY(check("corridor maps of buildings", 60, [] {
      const NavigationMesh mesh = meshOf(buildingOf(*buildingParts(10)));
      for (const bool isFull : {false, true}) {
        const CorridorMap map = makeCorridorMap(mesh, {.full = isFull});
        const QString error = errorOf(mesh, map);
        if (!error.isEmpty()) qWarning("%s", qPrintable(error));
        RC_ASSERT(error.isEmpty());
      }
    }));
  }

  /// All of the area is nearer to some piece of the full map than to others, once.
  void coversTheArea_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<double>("share");
    const QString sample = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj");
    for (const char* name : {"rooms", "house", "arena", "tower", "docks"})
      QTest::newRow(name) << sample.arg(name) << 1e-9;
    QTest::newRow("villa") << sample.arg("villa") << 1e-5;  // formulas of two nearly parallel borders
    const QString folder = sharedEnvironments();
    if (folder.isEmpty()) return;
    for (const char* name : {"ot", "turbine", "dutility", "fortitude"})
      QTest::newRow(name) << QStringLiteral("%1/%2.obj").arg(folder, name) << 1e-9;
    for (const char* name : {"nav_test", "steelribs", "complex"})
      QTest::newRow(name) << QStringLiteral("%1/%2.obj").arg(folder, name) << 1e-3;
  }
  void coversTheArea() {
    QFETCH(QString, path);
    QFETCH(double, share);
    if (!QFile::exists(path)) QSKIP("this environment is not here");
    const auto environment = importEnvironment(path.toStdString());
    RunContext context;
    const auto mesh = runPipeline(environment, defaultPipeline(*environment), context).mesh;
    double expected = 0;
    const ClearanceField field(*mesh, {.bound = 0});
    for (std::uint32_t f = 0; f < field.surface().faces.size(); ++f)
      if (field.surface().takesPart(f))
        expected += cross(field.surface().corner(f, 1) - field.surface().corner(f, 0),
                          field.surface().corner(f, 2) - field.surface().corner(f, 0)) /
                    2;
    const double found = areaOf(makeCorridorMap(*mesh, {.full = true}));
    QVERIFY2(std::fabs(found - expected) <= share * expected,
             qPrintable(QStringLiteral("%1, must be %2").arg(found, 0, 'g', 15).arg(expected, 0, 'g', 15)));
  }

  void readsBackWhatItWrote() {
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::NegativeX}) {
      NavigationMesh mesh = meshOf(twoRooms());
      mesh.frame = {.source = "two \"rooms\".obj", .up = up, .metresPerUnit = 0.0254};
      const CorridorMap map = makeCorridorMap(mesh);
      const std::string text = formatCorridorsJson(map);
      const CorridorMap back = parseCorridorsJson(text, "map.json");
      QCOMPARE(formatCorridorsJson(back), text);
      QCOMPARE(back.vertices.size(), map.vertices.size());
      QCOMPARE(back.vertices[0].place, map.vertices[0].place);
      QCOMPARE(back.bottlenecks[0].left, map.bottlenecks[0].left);
      QCOMPARE(back.frame.source, map.frame.source);
      QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(formatCorridorsGeoJson(map))).isObject());
    }
  }

  void refusesWhatIsNoMap() {
    const auto refused = [](const std::string& text) {
      return messageOf<InputError>([&] { (void)parseCorridorsJson(text, "map.json"); });
    };
    QVERIFY(refused("").startsWith("map.json: "));
    QVERIFY(refused("{}").contains("is no corridor map"));
    QVERIFY(refused("[1]").contains("is no corridor map"));
    std::string text = formatCorridorsJson(makeCorridorMap(meshOf(twoRooms())));
    text.replace(text.find("\"version\":1"), 11, "\"version\":2");
    QVERIFY(refused(text).contains("another version"));
    text = formatCorridorsJson(makeCorridorMap(meshOf(twoRooms())));
    text.replace(text.find("\"from\":0"), 8, "\"from\":99999");
    QVERIFY(refused(text).contains("out of range"));
  }

  void findsWaysForABody() {
    const CorridorMap map = makeCorridorMap(meshOf(twoRooms()));
    const std::uint32_t from = nearestVertex(map, {2, 2, 0}), to = nearestVertex(map, {8, 2, 0});
    const CorridorPath path = shortestCorridor(map, from, to, 0.9);
    QVERIFY(!path.edges.empty());
    QCOMPARE(path.width, 1.0);
    QVERIFY(std::fabs(path.length - 6) < 1e-9);
    QVERIFY(shortestCorridor(map, from, to, 1.1).edges.empty());
    QCOMPARE(widestCorridor(map, from, to).width, 1.0);
  }

  void isTheSameForAllThreads() {
    const NavigationMesh mesh = meshOf(twoRooms());
    std::string one, many;
    runWithThreads(1, [&] { one = formatCorridorsJson(makeCorridorMap(mesh)); });
    runWithThreads(4, [&] { many = formatCorridorsJson(makeCorridorMap(mesh)); });
    QCOMPARE(many, one);
  }

  void takesAnEmptyMeshAndCanBeCancelled() {
    QVERIFY(makeCorridorMap({}).vertices.empty());
    const NavigationMesh mesh = meshOf(twoRooms());
    RunContext context;
    context.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)makeCorridorMap(mesh, {}, &context));
  }
};

QTEST_GUILESS_MAIN(TestCorridorMap)
#include "test_corridor_map.moc"
