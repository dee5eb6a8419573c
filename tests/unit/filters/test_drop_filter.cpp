// DropFilter: against the definition on random soups, and the cases that people have in mind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "core/assembly/walkable_state.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/compare.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "tests/reference/drops.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::BorderEdge3;
using reference::DropAgent;
using reference::Point3;
using reference::Rational;

namespace {

std::string text(double number) { return QString::number(number, 'g', 17).toStdString(); }

std::string drops(double depth, double reach = 0.3) { return "DropFilter " + text(depth) + " " + text(reach) + "\n"; }

NavigationMesh dropped(const Soup& soup, const std::string& filters, double clearance = 2) {
  return navigationMesh(runFilters(soup.environment(), minimalPipeline(clearance) + "\n" + filters));
}

double lengthOf(const NavigationMesh& mesh) {
  double sum = 0;
  for (const DropLink& drop : mesh.drops) sum += drop.width;
  return sum;
}

/// A platform of 2 by 2 in the middle of a floor of 8 by 8, with upright sides.
Soup platform(double height) { return Soup().floor(0, 0, 8, 8, 0).box({3, 3, 0}, {5, 5, height}); }

/// A ledge of 2 by 4 beside a lower floor that begins `gap` away.
Soup ledge(double height, double gap) { return Soup().floor(-2, 0, 0, 4, height).floor(gap, 0, 4, 4, 0); }

double lengthOf(const BorderEdge3& border) {
  return std::hypot(Rational(border.to.x - border.from.x).get_d(), Rational(border.to.y - border.from.y).get_d());
}

/// Every border and triangle of a state's mesh drops exactly where the definition says so, at several places of it,
/// and what lands across a gap as far as the definition holds with something to spare. Returns how many drops were
/// looked at, and one more; 0 when something is wrong.
std::size_t checkAgainstDefinition(const Environment& environment, const std::string& filters, double clearance,
                                   double step, double depth, double reach) {
  auto shared = std::make_shared<Environment>(environment);
  const StatePtr state = runFilters(shared, filters + drops(depth, reach));
  const WalkableMesh& mesh = *state->mesh;
  const auto topology = topologyOf(*state);
  const TriangleCorners corners(mesh.triangles);
  std::vector<Point3> places;
  for (const MeshVertex& v : mesh.vertices) {
    const auto p = state->kernel->exactPosition(v.point, v.face);
    places.push_back({p[0], p[1], p[2]});
  }
  std::set<std::array<Index, 2>> linked;
  for (const MeshLink& link : mesh.links) linked.insert({link.from, link.to});
  struct Border {
    std::array<Index, 2> edge;
    BorderEdge3 places;
    Index triangle;
  };
  std::vector<Border> borders;
  for (Index e = 0; e < topology->edgeCount(); ++e) {
    const auto sides = topology->sidesOf(e);
    if (sides.size() > 1 && !isObstacle(mesh.triangles, sides)) continue;
    for (const Index side : sides) {
      const Index from = corners.beginOf(side), to = corners.endOf(side);
      borders.push_back({{from, to}, {places[from], places[to]}, side / 3});
    }
  }
  constexpr std::size_t kMostBorders = 40;  // each is held against each
  if (borders.size() > kMostBorders) return 1;
  std::map<std::array<Index, 2>, std::vector<const MeshDrop*>> dropsOf;
  for (const MeshDrop& drop : mesh.drops) dropsOf[drop.edge].push_back(&drop);
  const DropAgent agent{Rational(step), Rational(clearance), Rational(depth), Rational(reach)};
  const auto wrong = [&](const char* what, const Border& border, double share) {
    const Point3 p = reference::pointOn(border.places, Rational(share));
    qWarning("%s: %s at %g %g %g", toText(environment).c_str(), what, p.x.get_d(), p.y.get_d(), p.z.get_d());
    return std::size_t{0};
  };
  std::size_t seen = 1;
  constexpr double kNear = 0x1p-24;
  double largest = 0;
  for (const Vec3& v : environment.vertices)
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  for (const Border& border : borders) {
    const bool isLinked = linked.contains(border.edge);
    // Its ends may be one place once they are rounded, or the rounded end of a wall may be longer than the edge.
    const bool isTiny = lengthOf(border.places) < largest * 0x1p-36;
    for (const int percent : {1, 37, 61, 96}) {  // odd places, as single points do not count
      const Rational share(percent * 1000 + 13, 101000);
      const double s = share.get_d();
      const bool isLedge = !isLinked && reference::isLedgeAt(environment, border.places, share, agent);
      std::set<Index> straight, across;
      bool isAtEnd = false;
      for (const MeshDrop* drop : dropsOf[border.edge]) {
        for (const double end : drop->stretch) isAtEnd = isAtEnd || std::fabs(end - s) < kNear;
        if (s <= drop->stretch[0] || s >= drop->stretch[1]) continue;
        const bool isStraight = drop->start[0][0] == drop->landing[0][0] && drop->start[0][1] == drop->landing[0][1];
        (isStraight ? straight : across).insert(drop->triangle);
      }
      if (isAtEnd) continue;
      seen += straight.size() + across.size();
      if (!isLedge && !(straight.empty() && across.empty())) return wrong("a drop from no ledge", border, s);
      for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()) && isLedge; ++t) {
        const auto& c = mesh.triangles[t].corners;
        const std::array<Point3, 3> landing{places[c[0]], places[c[1]], places[c[2]]};
        const bool expected = reference::canDropStraight(environment, border.places, share, landing, agent);
        if (expected && isTiny) continue;
        if (expected != straight.contains(t))
          return wrong(expected ? "no drop straight down" : "a drop straight down", border, s);
      }
      const auto canDropTo = [&](const Border& other, const Rational& at, const DropAgent& who) {
        return reference::canDropAcross(environment, border.places, at, other.places, who) &&
               reference::isLedgeAt(environment, border.places, at, who);
      };
      std::set<Index> possible;
      DropAgent careful = agent;  // has something to spare
      const Rational spare(kNear), absolute = Rational(largest * 0x1p-34) + spare * agent.clearance;
      careful.step -= absolute;
      careful.clearance += absolute;
      careful.depth -= absolute;
      careful.reach -= absolute;
      careful.least = absolute;
      const bool isLong = lengthOf(border.places) * kNear > largest * 0x1p-36;
      for (const Border& other : borders) {
        if (isLinked || &other == &border) continue;
        if (canDropTo(other, share, agent)) possible.insert(other.triangle);
        if (across.contains(other.triangle) || !isLong || careful.reach <= 0) continue;
        if (std::ranges::all_of(std::array{Rational(share - spare), share, Rational(share + spare)},
                                [&](const Rational& at) { return canDropTo(other, at, careful); }))
          return wrong("no drop across a gap", border, s);
      }
      for (const Index t : across)
        if (!possible.contains(t)) return wrong("a drop across a gap", border, s);
    }
  }
  return seen;
}

/// What drops reach, as the sum of both components of each.
bool reaches(const NavigationMesh& mesh, const Vec3& from, const Vec3& to) {
  return PathFinder(std::make_shared<const NavigationMesh>(mesh)).find(from, to).reached();
}

std::string errorOf(const Soup& soup, const std::string& filters) {
  try {
    runFilters(soup.environment(), filters);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestDropFilter : public QObject {
  Q_OBJECT

 private slots:
  void oneDropsFromAPlatformAllAround() {
    const NavigationMesh mesh = dropped(platform(1), drops(1));
    QCOMPARE(mesh.drops.size(), std::size_t{4});
    QCOMPARE(lengthOf(mesh), 8.0);
    for (const DropLink& drop : mesh.drops) {
      QCOMPARE(drop.depth, 1.0);
      for (const int end : {0, 1}) {
        QCOMPARE(drop.start[end], mesh.vertices[drop.from[end]]);
        QCOMPARE(drop.landing[end], (Vec3{drop.start[end].x, drop.start[end].y, 0}));
      }
      const Triangle& t = mesh.triangles[drop.fromTriangle];
      QVERIFY(std::ranges::count(t, drop.from[0]) == 1 && std::ranges::count(t, drop.from[1]) == 1);
      for (const std::uint32_t v : mesh.triangles[drop.toTriangle]) QCOMPARE(mesh.vertices[v].z, 0.0);
    }
    QCOMPARE(findMeshError(mesh), std::string());
  }

  void theDepthIsAllowedAndNotMore() {
    QVERIFY(dropped(platform(1), drops(std::nextafter(1.0, 0))).drops.empty());
    QCOMPARE(dropped(platform(1), drops(1000)).drops.size(), std::size_t{4});  // deeper than the level
    QVERIFY(!dropped(platform(0.1), drops(0.1)).drops.empty());
  }

  void nobodyDropsOntoTheSameHeightOrUp() {
    QVERIFY(dropped(ledge(0, 0.2), drops(2)).drops.empty());
    QVERIFY(dropped(Soup().floor(0, 0, 4, 4, 0), drops(2)).drops.empty());
    const NavigationMesh mesh = dropped(platform(1), drops(2));
    QVERIFY(reaches(mesh, {4, 4, 1}, {1, 1, 0}));
    QVERIFY(!reaches(mesh, {1, 1, 0}, {4, 4, 1}));
  }

  void fencesOnTheLedge() {
    const auto fence = [](double height) { return platform(1).wall(5, 2, 5, 6, 1, 1 + height); };
    const std::string step = "StepFilter 0.4\n";
    QCOMPARE(lengthOf(dropped(fence(0.4), step + drops(1))), 8.0);  // stepped over
    QCOMPARE(lengthOf(dropped(fence(0.41), step + drops(1))), 6.0);
    QCOMPARE(lengthOf(dropped(fence(0.4), drops(1))), 6.0);  // without a StepFilter it is 0
    // A fence over one half, and one that grows from nothing to the clearance: passable up to the step.
    for (const Soup& half :
         {platform(1).wall(5, 4, 5, 6, 1, 2), platform(1).triangle({5, 3, 1}, {5, 5, 1}, {5, 5, 1.8})}) {
      const double length = lengthOf(dropped(half, step + drops(1)));
      QVERIFY2(length <= 7 && length > 7 - 1e-9, qPrintable(QString::number(length, 'g', 17)));
    }
  }

  void ceilingsOverTheFall() {
    const auto roof = [](double z) { return platform(1).ceiling(5, 2, 6, 6, z); };
    QCOMPARE(lengthOf(dropped(roof(3), drops(1))), 8.0);  // exactly the clearance over the ledge
    QCOMPARE(lengthOf(dropped(roof(2.99), drops(1))), 6.0);
    QCOMPARE(lengthOf(dropped(roof(0.5), drops(1))), 6.0);  // an awning below the ledge
  }

  void theFallEndsOnTheFirstThing() {
    // A shelf under the ledge, too narrow for nothing: it catches who falls.
    const Soup soup = platform(1).box({5, 2, 0.5}, {5.5, 6, 0.6});
    const NavigationMesh mesh = dropped(soup, drops(1, 0), 0.3);
    QVERIFY(!mesh.drops.empty());
    for (const DropLink& drop : mesh.drops)
      if (drop.start[0].x == 5 && drop.start[1].x == 5 && drop.start[0].z == 1)
        for (const Vec3& p : drop.landing) QCOMPARE(p.z, 0.6);
    // What is too steep to stand on catches nobody, but nobody lands on or behind it either.
    QCOMPARE(lengthOf(dropped(platform(1).quad({5, 2, 0.8}, {5, 6, 0.8}, {5.4, 6, 0}, {5.4, 2, 0}), drops(1, 0))), 6.0);
    QCOMPARE(lengthOf(dropped(platform(1).quad({5, 2, 0.8}, {5.4, 2, 0}, {5.4, 6, 0}, {5, 6, 0.8}), drops(1, 0))), 6.0);
  }

  void gapsWithinTheReach() {
    QVERIFY(dropped(ledge(1, 0.25), drops(2, 0.2)).drops.empty());
    const NavigationMesh mesh = dropped(ledge(1, 0.25), drops(2, 0.3));
    QCOMPARE(mesh.drops.size(), std::size_t{1});
    QVERIFY(std::fabs(mesh.drops[0].width - 4) < 1e-9);
    for (const int end : {0, 1}) QCOMPARE(mesh.drops[0].landing[end].x, 0.25);
    // Over a low wall in the gap, as far as the step goes; with what is behind it, too.
    const auto walled = [](double z) { return ledge(1, 0.25).wall(0.125, -1, 0.125, 5, 0, z); };
    QCOMPARE(dropped(walled(1.4), "StepFilter 0.4\n" + drops(2)).drops.size(), std::size_t{1});
    QVERIFY(dropped(walled(1.41), "StepFilter 0.4\n" + drops(2)).drops.empty());
    // A beam over the landing, lower than the head of who starts.
    QVERIFY(dropped(ledge(1, 0.25).ceiling(0.2, -1, 1, 5, 2.5), drops(2)).drops.empty());
    QCOMPARE(dropped(ledge(1, 0.25).ceiling(0.2, -1, 1, 5, 3), drops(2)).drops.size(), std::size_t{1});
    // A parapet, over which one steps and on which nobody stands, higher above the landing than one is.
    const auto parapet = [](double top) {
      return Soup()
          .floor(-2, 0, 0, 4, 3)
          .quad({0, -1, 3}, {0.125, -1, top}, {0.125, 5, top}, {0, 5, 3})
          .wall(0.125, -1, 0.125, 5, 0, top)
          .floor(0.125, 0, 4, 4, 0);
    };
    QVERIFY(lengthOf(dropped(parapet(3.4), "StepFilter 0.4\n" + drops(3))) > 4 - 1e-9);
    QVERIFY(dropped(parapet(3.45), "StepFilter 0.4\n" + drops(3)).drops.empty());
  }

  void largerDepthAddsDropsAndTakesNoneAway() {
    // A shelf a little outwards, and the floor straight below.
    const Soup soup = Soup().floor(-2, 0, 0, 4, 3).floor(0.2, 0, 1, 4, 2).floor(-2, 0, 6, 4, 0);
    const NavigationMesh little = dropped(soup, drops(1), 1), much = dropped(soup, drops(3), 1);
    QVERIFY(reaches(little, {-1, 1, 3}, {0.5, 1, 2}));
    QVERIFY(!reaches(little, {-1, 1, 3}, {3, 1, 0}));
    QVERIFY(reaches(much, {-1, 1, 3}, {0.5, 1, 2}));
    QVERIFY(reaches(much, {-1, 1, 3}, {3, 1, 0}));
  }

  void stepsAreNoLedges() {
    Soup stairs;
    for (int i = 0; i < 4; ++i) {
      stairs.floor(i, 0, i + 1, 2, 0.25 * i);
      if (i > 0) stairs.wall(i, 0, i, 2, 0.25 * (i - 1), 0.25 * i);
    }
    QVERIFY(dropped(stairs, "StepFilter 0.25\n" + drops(2)).drops.empty());
    QCOMPARE(dropped(stairs, "StepFilter 0.2\n" + drops(2)).drops.size(), std::size_t{3});
    // Beside the stairs, from each tread.
    const Soup beside = Soup(stairs).floor(0, 2, 8, 6, -1);
    QCOMPARE(lengthOf(dropped(beside, "StepFilter 0.25\n" + drops(2))), 4.0);
    QCOMPARE(lengthOf(dropped(beside, "StepFilter 0.25\n" + drops(1.25))), 2.0);
  }

  void behindARadiusTheReachCrossesBothMargins() {
    const std::string filters = "RadiusFilter 0.25\n";
    QVERIFY(dropped(platform(1), filters + drops(2, 0.4)).drops.empty());
    const NavigationMesh mesh = dropped(platform(1), filters + drops(2, 0.6));
    QVERIFY(!mesh.drops.empty());
    QVERIFY(reaches(mesh, {4, 4, 1}, {1, 1, 0}));
    QVERIFY(!reaches(mesh, {1, 1, 0}, {4, 4, 1}));
  }

  void filtersBehindTakeDropsAlong() {
    const Soup soup = platform(1).add(platform(1.5).mapped([](const Vec3& p) { return Vec3{p.x + 8, p.y, p.z}; }));
    const std::string all = "SimplificationFilter\nLayerSubdivisionFilter\n" + drops(2);
    QCOMPARE(lengthOf(dropped(soup, all)), 16.0);
    QVERIFY(dropped(soup, all + "AreaFilter 4\n").drops.empty());  // platforms have 4 each
    QCOMPARE(lengthOf(dropped(soup, all + "AreaFilter 3.9\n")), 16.0);
    // Seeds: down is reached, up is not.
    const NavigationMesh down = dropped(soup, all + "ReachableFilter 4 4 1.5\n");
    QCOMPARE(area(down), 124.0);
    QCOMPARE(lengthOf(down), 8.0);
    const NavigationMesh ground = dropped(soup, all + "ReachableFilter 1 1 0.5\n");
    QCOMPARE(area(ground), 120.0);
    QVERIFY(ground.drops.empty());
  }

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

  void exportsAreReadBack() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.obj").toStdString();
    const NavigationMesh mesh = dropped(platform(1), "StepFilter 0.3\nLayerSubdivisionFilter\n" + drops(2));
    const std::vector<ExportExtra> extras{{"crate", soupFor(Soup().box({1, 1, 0}, {2, 2, 1}))}};
    save(mesh, path, {}, {}, extras);
    const NavigationMesh read = readNavigationMesh(path).mesh;
    QCOMPARE(read.vertices, mesh.vertices);
    QCOMPARE(read.triangles, mesh.triangles);
    QCOMPARE(read.drops.size(), mesh.drops.size());
    for (std::size_t i = 0; i < read.drops.size(); ++i) {
      QCOMPARE(read.drops[i].start, mesh.drops[i].start);
      QCOMPARE(read.drops[i].landing, mesh.drops[i].landing);
      QCOMPARE(read.drops[i].from, mesh.drops[i].from);
      QCOMPARE(read.drops[i].fromTriangle, mesh.drops[i].fromTriangle);
      QCOMPARE(read.drops[i].toTriangle, mesh.drops[i].toTriangle);
      QCOMPARE(read.drops[i].depth, 1.0);
      QCOMPARE(read.drops[i].width, 2.0);
    }
    QVERIFY(compareMeshes(mesh, read).equalDrops);
    ExportOptions without;
    without.drops = false;
    save(mesh, path, without, {}, extras);
    const NavigationMesh other = readNavigationMesh(path).mesh;
    QVERIFY(other.drops.empty());
    const MeshComparison comparison = compareMeshes(mesh, other);
    QVERIFY(comparison.equal() && !comparison.equalDrops);
    QCOMPARE(comparison.meshes[0].drops, std::size_t{4});
    QCOMPARE(comparison.meshes[0].dropLength, 8.0);
    QCOMPARE(comparison.meshes[0].deepestDrop, 1.0);
    QCOMPARE(comparison.meshes[1].drops, std::size_t{0});
  }

  void pipelinesThatCannotBe_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    QTest::newRow("no clearance") << "SlopeFilter 45\nDropFilter 1\n"
                                  << "p:2:1: DropFilter asks how high";
    QTest::newRow("zero") << "VerticalClearanceFilter 2\nDropFilter 0\n"
                          << "p:2:12: ";
    QTest::newRow("negative") << "VerticalClearanceFilter 2\nDropFilter -1\n"
                              << "p:2:12: ";
    QTest::newRow("nan") << "VerticalClearanceFilter 2\nDropFilter nan\n"
                         << "p:2:12: ";
    QTest::newRow("negative reach") << "VerticalClearanceFilter 2\nDropFilter 1 -0.1\n"
                                    << "p:2:14: ";
    QTest::newRow("infinite reach") << "VerticalClearanceFilter 2\nDropFilter 1 inf\n"
                                    << "p:2:14: ";
    QTest::newRow("in a block") << "GridStrategy 2 2\nVerticalClearanceFilter 2\nDropFilter 1\nCollapse\n"
                                << "p:3:1: DropFilter sees across cells";
    for (const char* last : {"VerticalClearanceFilter 2", "RoundingFilter", "SimplificationFilter", "StepFilter 1",
                             "RadiusFilter 1", "LayerSubdivisionFilter", "SlopeFilter 45", "DuplicationFilter 0"})
      QTest::newRow(last) << QString("VerticalClearanceFilter 2\nDropFilter 1\n%1\n").arg(last)
                          << "p:3:1: " + QString(last).section(' ', 0, 0) + " would lose the drops";
  }
  void pipelinesThatCannotBe() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    try {
      parsePipeline(text.toStdString(), "p");
      QFAIL("it was accepted");
    } catch (const InputError& error) {
      QVERIFY2(QString(error.what()).startsWith(expected), error.what());
    }
  }

  void depthsThatAreTooSmall() {
    const Soup far = platform(1).mapped([](const Vec3& p) { return Vec3{p.x + 1e9, p.y, p.z}; });
    QVERIFY(errorOf(far, minimalPipeline(2) + "\n" + drops(1e-200)).starts_with("a drop of 1e-200 is too small"));
  }

  void agreesWithTheDefinition() {
    std::size_t seen = 0;
    for (int i = 0; i < rounds(320); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 9000 + static_cast<std::uint64_t>(i));
      if (one.soup.size() > 14) continue;
      const double step = one.clearance * (i % 3 == 0 ? 0 : i % 3 == 1 ? 0.25 : 0.5);
      std::string filters = minimalPipeline(one.clearance) + "\n";
      if (step > 0) filters += "StepFilter " + text(step) + "\n";
      const double depth = one.clearance * (i % 2 == 0 ? 1 : 3), reach = one.clearance * (i % 5 == 0 ? 0 : 0.5);
      try {
        const std::size_t looked =
            checkAgainstDefinition(*one.soup.environment(one.bothSides), filters, one.clearance, step, depth, reach);
        QVERIFY2(looked > 0, qPrintable(QString("case %1 (%2), clearance %3, step %4, depth %5, reach %6")
                                            .arg(i)
                                            .arg(QString::fromStdString(one.kind))
                                            .arg(one.clearance)
                                            .arg(step)
                                            .arg(depth)
                                            .arg(reach)));
        seen += looked - 1;
      } catch (const InputError&) {  // too small a height beside the coordinates
      }
    }
    qInfo("%zu places that drop", seen);
    QVERIFY(seen > 200);
  }

  void levelsOfAllKindsAgree() {
    const auto turned = [](const Vec3& p) { return Vec3{p.x - p.y, p.x + p.y, p.z + p.x / 8 - p.y / 16}; };
    const std::vector<Soup> soups = {
        platform(1),
        platform(1).mapped(turned),
        platform(1).add(platform(1).mapped([](const Vec3& p) {
          return Vec3{p.x / 2, p.y / 2, p.z + 2};
        })),
        Soup().floor(0, 0, 8, 8, 0).box({1, 1, 0}, {7, 7, 1}).box({2, 2, 1}, {6, 6, 2}).box({3, 3, 2}, {5, 5, 3}),
        platform(1).wall(5, 2, 5, 4, 1, 2).wall(2, 5, 6, 5, 1.2, 1.4).ceiling(2, 2, 3, 6, 0.5),
        ledge(1, 0.25).wall(0.125, 1, 0.125, 2, 0, 2).floor(0.0625, 2, 0.125, 3, 0.5),
        ledge(1, 0.25).mapped(turned),
        Soup().ramp(0, 0, 4, 2, 0, 2).floor(0, 0, 8, 8, 0).floor(0, 2, 2, 4, 0.5),  // a slanted ledge
        Soup().floor(0, 0, 2, 2, 1).floor(0.5, 0.5, 4, 4, 0.5).floor(0, 0, 8, 8, 0).floor(2, 0, 3, 3, -1),
        platform(0x1p-30),
    };
    std::size_t seen = 0;
    for (std::size_t i = 0; i < soups.size(); ++i)
      for (const double depth : {0.5, 1.0, 4.0})
        for (const double clearance : {0.25, 2.0}) {
          const std::size_t looked =
              checkAgainstDefinition(*soups[i].environment(), minimalPipeline(clearance) + "\nStepFilter 0.125\n",
                                     clearance, 0.125, depth, 0.375);
          QVERIFY2(looked > 0, qPrintable(QString("soup %1, depth %2, clearance %3").arg(i).arg(depth).arg(clearance)));
          seen += looked - 1;
        }
    QVERIFY(seen > 500);
  }

  void liveEditsGiveTheSame() {
    Soup level = platform(1).add(platform(1.5).mapped([](const Vec3& p) { return Vec3{p.x + 8, p.y, p.z}; }));
    const std::string pipeline = minimalPipeline(2) +
                                 "\nStepFilter 0.3\nAreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n" +
                                 drops(1.5) + "ReachableFilter 4 4 1.25\n";
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y, double z) {
      return soupFor(Soup().box({x, y, z}, {x + 0.75, y + 0.75, z + 0.5}));
    };
    const ObstacleId id = edited.add(crate(4.5, 4, 1));
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    for (int i = 0; i < 8; ++i) {
      edited.replace(id, crate(2.25 + 0.375 * i, 2.5 + 0.25 * (i % 5), 0.25 * (i / 2)));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(i)));
    }
  }

  void moreDepthOrReachNeverPartsAndOrderChangesNothing() {
    std::mt19937 random(5);
    std::size_t found = 0;
    for (int i = 0; i < rounds(60); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 7000 + static_cast<std::uint64_t>(i));
      if (one.clearance < 1e-6) continue;
      const auto environment = one.soup.environment(one.bothSides);
      std::set<std::array<std::uint32_t, 2>> before;
      for (const auto& [depth, reach] :
           {std::pair{0.3, 0.1}, std::pair{1.0, 0.1}, std::pair{1.0, 0.6}, std::pair{4.0, 0.6}}) {
        const std::string filters = minimalPipeline(one.clearance) + "\nSimplificationFilter\n" +
                                    drops(depth * one.clearance, reach * one.clearance);
        const NavigationMesh mesh = navigationMesh(runFilters(environment, filters));
        QCOMPARE(findMeshError(mesh), std::string());
        std::set<std::array<std::uint32_t, 2>> pairs;
        const SurfaceTopology topology = makeSurfaceTopology(mesh);
        for (const DropLink& drop : mesh.drops)
          pairs.insert({topology.components[drop.fromTriangle], topology.components[drop.toTriangle]});
        QVERIFY(std::ranges::includes(pairs, before));
        before = pairs;
        found += pairs.size();
        std::vector<std::uint32_t> order(environment->triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3,
                       [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), filters)); });
        QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices);
        QVERIFY(std::equal(other.drops.begin(), other.drops.end(), mesh.drops.begin(), mesh.drops.end(),
                           [](const DropLink& a, const DropLink& b) {
                             return a.from == b.from && a.fromTriangle == b.fromTriangle &&
                                    a.toTriangle == b.toTriangle && a.start == b.start && a.landing == b.landing;
                           }));
      }
    }
    QVERIFY(found > 50);
  }
};

QTEST_GUILESS_MAIN(TestDropFilter)
#include "test_drop_filter.moc"
