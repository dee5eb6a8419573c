// DropFilter: against the definition, on random soups and on levels of all kinds.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/assembly/walkable_state.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"
#include "tests/reference/drops.hpp"
#include "tests/support/drop_cases.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::BorderEdge3;
using reference::DropAgent;
using reference::Point3;
using reference::Rational;

namespace {

std::string text(double number) { return QString::number(number, 'g', 17).toStdString(); }

double lengthOf(const BorderEdge3& border) {
  return std::hypot(Rational(border.to.x - border.from.x).get_d(), Rational(border.to.y - border.from.y).get_d());
}

/// Checks at several places of every border and triangle of a state's mesh that agents drop exactly where the
/// definition says so, and that landings across a gap hold by the definition with a margin. Returns the number of
/// checked drops plus one; 0 for an error.
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

}  // namespace

class TestDropDefinition : public QObject {
  Q_OBJECT

 private slots:
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

QTEST_GUILESS_MAIN(TestDropDefinition)
#include "test_drop_definition.moc"
