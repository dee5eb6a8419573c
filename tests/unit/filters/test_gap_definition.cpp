// StepFilter across gaps against the definition, on structured and random soups.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/assembly/walkable_state.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/gaps.hpp"
#include "tests/reference/walkable_area.hpp"
#include "tests/support/exact_borders.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/filters/gap_cases.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::BorderEdge3;
using reference::Point3;
using reference::Rational;

namespace {

struct Counts {
  std::size_t linked = 0, expected = 0;
};

struct GapLimits {
  double height = 0, step = 0, gap = 0;
};

double planDot(const Point3& p, double x, double y) { return p.x.get_d() * x + p.y.get_d() * y; }

/// Two borders along the bisector of their directions, in doubles.
struct Bisected {
  double x = 0, y = 0;  ///< direction
  std::array<double, 2> ends{};
  std::array<std::array<double, 2>, 2> across{}, heights{};  ///< of each border, at the ends

  Bisected(const BorderEdge3& a, const BorderEdge3& b) {
    const auto unit = [](const BorderEdge3& e) {
      const double dx = Rational(e.to.x - e.from.x).get_d(), dy = Rational(e.to.y - e.from.y).get_d();
      return std::array{dx / std::hypot(dx, dy), dy / std::hypot(dx, dy)};
    };
    const auto e = unit(a), f = unit(b);
    const double dx = e[0] - f[0], dy = e[1] - f[1];
    x = dx / std::hypot(dx, dy);
    y = dy / std::hypot(dx, dy);
    ends = {std::max(along(a.from), along(b.to)), std::min(along(a.to), along(b.from))};
    for (const int i : {0, 1}) {
      const BorderEdge3& border = i == 0 ? a : b;
      for (const int k : {0, 1}) {
        const double t = (ends[k] - along(border.from)) / (along(border.to) - along(border.from));
        const double from = acrossOf(border.from), to = acrossOf(border.to);
        across[i][k] = from + t * (to - from);
        heights[i][k] = border.from.z.get_d() + t * Rational(border.to.z - border.from.z).get_d();
      }
    }
  }
  [[nodiscard]] double along(const Point3& p) const { return planDot(p, x, y); }
  [[nodiscard]] double acrossOf(const Point3& p) const { return planDot(p, y, -x); }
  /// Cuts off where a number that changes from the one end to the other is negative. False when nothing is left.
  bool keep(double atBegin, double atEnd, const std::array<double, 2>& whole, std::array<double, 2>& part) const {
    if (atBegin < 0 && atEnd < 0) return false;
    const double zero = whole[0] + (whole[1] - whole[0]) * (atBegin / (atBegin - atEnd));
    if (atBegin < 0) part[0] = std::max(part[0], zero);
    if (atEnd < 0) part[1] = std::min(part[1], zero);
    return part[0] < part[1];
  }
};

/// How long the stretch between two whole borders is at least, along which there are ways beside a place. Whatever
/// stands there counts as in the way along all of its extent.
double lengthOfStretch(const Environment& environment, const BorderEdge3& a, const BorderEdge3& b, const Point3& place,
                       const GapLimits& limits, double margin) {
  const Bisected both(a, b);
  std::array<double, 2> part = both.ends;
  const auto between = [&](const std::array<std::array<double, 2>, 2>& values, int end) {
    return values[1][end] - values[0][end];
  };
  const auto keepAtMost = [&](double most, double sign, const std::array<std::array<double, 2>, 2>& values) {
    return both.keep(most - sign * between(values, 0), most - sign * between(values, 1), both.ends, part);
  };
  if (!(part[0] < part[1]) || !keepAtMost(limits.gap - margin, 1, both.across) || !keepAtMost(-margin, -1, both.across))
    return 0;
  for (const double sign : {1.0, -1.0})
    if (!keepAtMost(limits.step - margin, sign, both.heights)) return 0;
  const auto leastOf = [](const auto& v) { return std::min({v[0][0], v[0][1], v[1][0], v[1][1]}); };
  const auto mostOf = [](const auto& v) { return std::max({v[0][0], v[0][1], v[1][0], v[1][1]}); };
  const double at = both.along(place), low = leastOf(both.heights) + limits.step - margin,
               high = mostOf(both.heights) + limits.height + margin;
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    std::array<double, 2> z{1e300, -1e300}, along = z, across = z;
    for (const Point3& p : reference::cornersOf(environment, t))
      for (const auto& [range, value] :
           {std::pair(&z, p.z.get_d()), {&along, both.along(p)}, {&across, both.acrossOf(p)}})
        *range = {std::min((*range)[0], value), std::max((*range)[1], value)};
    if (z[1] <= low || z[0] >= high) continue;
    if (across[1] < leastOf(both.across) - margin || across[0] > mostOf(both.across) + margin) continue;
    if (along[1] + margin < at)
      part[0] = std::max(part[0], along[1] + margin);
    else if (along[0] - margin > at)
      part[1] = std::min(part[1], along[0] - margin);
    else
      return 0;
  }
  return part[0] < at && at < part[1] ? part[1] - part[0] : 0;
}

/// The border of which an edge is a part.
const BorderEdge3& wholeOf(const BorderEdge3& edge, const std::vector<BorderEdge3>& borders) {
  for (const BorderEdge3& border : borders) {
    const Rational dx = border.to.x - border.from.x, dy = border.to.y - border.from.y, dz = border.to.z - border.from.z;
    const auto isOn = [&](const Point3& p) {
      const Rational x = p.x - border.from.x, y = p.y - border.from.y, z = p.z - border.from.z;
      const Rational along = x * dx + y * dy, square = dx * dx + dy * dy;
      return x * dy == y * dx && z * square == dz * along && along >= 0 && along <= square;
    };
    if ((edge.to.x - edge.from.x) * dx + (edge.to.y - edge.from.y) * dy > 0 && isOn(edge.from) && isOn(edge.to))
      return border;
  }
  return edge;
}

/// True when the last filter says that it could not verify all links: where cuts cause further cuts.
bool leavesSome(const std::shared_ptr<const Environment>& environment, const std::string& pipeline) {
  return run(environment, pipeline, nullptr).steps.back().note.str().find("could not be verified") != std::string::npos;
}

/// True when all links over gaps are ones by the definition, at several places of them, and, where there is a margin,
/// both sides of all places at which it holds with that to spare are one region, and linked there, save on short
/// stretches and ones that could not be verified. Failures go to the log.
bool agreesWithDefinition(const std::shared_ptr<const Environment>& environment, double height, double step, double gap,
                          double margin, Counts& counts) {
  const StatePtr state = runFilters(environment, gaps(height, step, gap));
  const WalkableMesh& mesh = *state->mesh;
  const auto topology = topologyOf(*state);
  const TriangleCorners corners(mesh.triangles);
  std::vector<Point3> places;
  for (const MeshVertex& v : mesh.vertices) {
    const auto p = state->kernel->exactPosition(v.point, v.face);
    places.push_back({p[0], p[1], p[2]});
  }
  const auto edgeOf = [&](const std::array<Index, 2>& edge) { return BorderEdge3{places[edge[0]], places[edge[1]]}; };
  std::map<std::array<std::array<Index, 2>, 2>, int> links;
  std::map<std::array<Index, 2>, Index> regionAt;  // of borders
  Index regionCount = 0;
  const std::vector<Index> regions = findRegions(mesh, *topology, regionCount);
  for (const MeshLink& link : mesh.links) {
    ++links[{link.from, link.to}];
    ++links[{link.to, link.from}];
    if (!link.isGap) continue;
    ++counts.linked;
    const BorderEdge3 a = edgeOf(link.from), b = edgeOf(link.to);
    for (const int percent : {1, 37, 61, 99}) {
      const Rational s(percent * 1000 + 13, 101000);
      const Point3 p = placeOn(a, s), q = placeOn(b, 1 - s);
      if (canStepOver(*environment, a, b, p, q, step, height, gap)) continue;
      qWarning("%s: linked at %g %g, %g %g", toText(*environment).c_str(), p.x.get_d(), p.y.get_d(), q.x.get_d(),
               q.y.get_d());
      return false;
    }
  }
  if (margin == 0) return true;
  std::vector<std::array<Index, 2>> borders;
  for (Index e = 0; e < topology->edgeCount(); ++e) {
    const auto sides = topology->sidesOf(e);
    if (sides.size() > 1 && !isObstacle(mesh.triangles, sides)) continue;
    for (const Index side : sides) {
      borders.push_back({corners.beginOf(side), corners.endOf(side)});
      regionAt[borders.back()] = regions[side / 3];
    }
  }
  const std::vector<BorderEdge3> whole = bordersOf(environment, minimalPipeline(height));
  for (const auto& first : borders)
    for (const auto& second : borders) {
      if (first == second) continue;
      const BorderEdge3 a = edgeOf(first), b = edgeOf(second);
      // The bisector in doubles: where on b is the place across from one on a?
      const double ax = Rational(a.to.x - a.from.x).get_d(), ay = Rational(a.to.y - a.from.y).get_d();
      const double bx = Rational(b.from.x - b.to.x).get_d(), by = Rational(b.from.y - b.to.y).get_d();
      const double la = std::hypot(ax, ay), lb = std::hypot(bx, by);
      if (la < 8 * margin || lb < 8 * margin || ax * bx + ay * by < 0.51 * la * lb) continue;
      const double ex = ax / la + bx / lb, ey = ay / la + by / lb;
      const auto along = [&](const Point3& p) {
        return Rational(p.x - a.from.x).get_d() * ex + Rational(p.y - a.from.y).get_d() * ey;
      };
      const double low = along(b.to), high = along(b.from);
      for (const int percent : {3, 37, 61, 97}) {
        bool isClear = true;
        for (const double beside : {-margin, 0.0, margin}) {
          const double s = percent / 100.0 + beside / la, across = along(placeOn(a, s));
          const double t = (across - low) / (high - low);  // distance from b.to
          if (!(s > 0 && s < 1 && t > margin / lb && t < 1 - margin / lb)) {
            isClear = false;
            break;
          }
          const Point3 p = placeOn(a, s), q = placeOn(b, 1 - t);
          const double width = std::hypot(Rational(q.x - p.x).get_d(), Rational(q.y - p.y).get_d());
          isClear = isClear && width > margin &&  // else it hardly leaves the one side and enters the other
                    canStepOver(*environment, a, b, p, q, step - margin, height + margin, gap - margin);
        }
        if (!isClear) continue;
        ++counts.expected;
        if (links.contains({first, second})) continue;
        const Point3 p = placeOn(a, percent / 100.0);
        // A way of a link that leads to corners may lead beside the place across, by half of the gap.
        const double across = along(p);
        const bool leadsBeside = std::ranges::any_of(links, [&](const auto& link) {
          const auto& [from, to] = link.first;
          if (from != first) return false;
          const BorderEdge3 other = edgeOf(to);
          return std::fabs(along(placeOn(other, Rational(1 - percent / 100.0))) - across) <=
                     (gap / 2 + margin) * std::hypot(ex, ey) &&
                 &wholeOf(other, whole) == &wholeOf(b, whole);
        });
        if (leadsBeside) continue;
        const bool isOneRegion = regionAt.at(first) == regionAt.at(second);
        const double length =
            lengthOfStretch(*environment, wholeOf(a, whole), wholeOf(b, whole), p, {height, step, gap}, margin);
        if (isOneRegion && (length <= 2 * gap + margin || leavesSome(environment, gaps(height, step, gap)))) continue;
        qWarning("%s: %s at %g %g %g", toText(*environment).c_str(), isOneRegion ? "not linked" : "apart", p.x.get_d(),
                 p.y.get_d(), p.z.get_d());
        return false;
      }
    }
  return true;
}

/// Floors, walls and ceilings about slits that run through a square.
Soup randomSlits(std::mt19937& random) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto pick = [&](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
  const bool isGrid = pick(2) == 0;
  const auto place = [&](double low, double high) {
    return isGrid ? std::round(number(low, high) * 32) / 32 : number(low, high);
  };
  Soup soup;
  double x = 0;
  for (int i = 0; i < 3; ++i) {
    const double width = place(0.5, 2), from = place(-1, 1), to = place(2, 4), z = pick(2) == 0 ? 0 : place(-0.4, 0.4);
    const double skewed = pick(3) == 0 ? place(-0.2, 0.2) : 0, z1 = pick(3) == 0 ? z + place(-0.3, 0.3) : z;
    soup.quad({x, from, z}, {x + width, from, z}, {x + width + skewed, to, z1}, {x + skewed * pick(2), to, z1});
    x += width + (pick(4) == 0 ? 0x1p-50 : place(0, 0.3));
  }
  for (int i = pick(3); i > 0; --i) {
    const double at = place(0, 5), from = place(-1, 2), base = place(-0.2, 2.2);
    soup.wall(at, from, at + (pick(2) == 0 ? 0 : place(-0.3, 0.3)), from + place(0.2, 2), base,
              base + place(0.05, 1.5));
  }
  if (pick(3) == 0) soup.ceiling(0, 0, place(1, 5), place(1, 4), place(1.8, 2.6));
  return soup;
}

}  // namespace

class TestGapDefinition : public QObject {
  Q_OBJECT

 private slots:
  void structuredSoupsAgree() {
    Counts counts;
    const std::vector<Soup> soups = {
        slit(0.125),
        slit(0x1p-50),
        slit(0.125, 0.25),
        slit(0.125).mapped([](const Vec3& p) {
          return Vec3{p.x - p.y, p.x + p.y, p.z + p.x / 8};
        }),
        slit(0.1).mapped([](const Vec3& p) {
          return Vec3{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
        }),
        Soup().floor(0, 0, 2, 2, 0).floor(2.125, 1, 4, 3, 0.25).floor(1, 2.125, 2, 4, 0),  // across corners
        Soup().quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}).quad({4.3, 0, 0}, {8, 0, 0}, {8, 4, 0}, {3.9, 4, 0.1}),
        slit(0.125).wall(4.05, 1, 4.05, 2, 0, 0.3),
        slit(0.125).wall(4, 1, 4.125, 1, 0, 3),  // across it
        slit(0.125).wall(4, 1, 4.125, 2, 0, 3),  // slanting
        slit(0.125).ceiling(3, 1, 5, 2, 1.5),
        slit(0.125).box({4.03, 1, -1}, {4.06, 2, 0.2}),
        slit(0.125).ramp(4, 1, 4.125, 2, 0, 1),
        Soup().floor(0, 0, 4, 4, 0).floor(4.01, 0, 4.02, 4, 0).floor(4.03, 0, 8, 4, 0),  // a strip between
        Soup().floor(0, 0, 4, 2, 0).floor(0, 2, 4, 4, 0x1p-52).floor(4 + 0x1p-50, 0, 8, 4, 0),
    };
    for (std::size_t i = 0; i < soups.size(); ++i)
      for (const double step : {0.125, 0.25, 0.5})
        for (const double gap : {0.05, 0.15, 0.5})
          QVERIFY2(agreesWithDefinition(soups[i].environment(), 2, step, gap, 1e-6, counts),
                   qPrintable(QString("soup %1, step %2, gap %3").arg(i).arg(step).arg(gap)));
    qInfo("%zu links, %zu expected places", counts.linked, counts.expected);
    QVERIFY(counts.linked > 100 && counts.expected > 200);
  }

  void randomSlitsAgree() {
    Counts counts;
    std::mt19937 random(static_cast<std::uint32_t>(seed()));
    for (int i = 0; i < rounds(150); ++i) {
      const Soup soup = randomSlits(random);
      const double step = std::array{0.2, 0.4}[i % 2], gap = std::array{0.05, 0.2, 0.4}[i % 3];
      QVERIFY2(agreesWithDefinition(soup.environment(), 2, step, gap, 1e-6, counts), qPrintable(QString::number(i)));
    }
    qInfo("%zu links, %zu expected places", counts.linked, counts.expected);
    QVERIFY(counts.linked > 50 && counts.expected > 100);
  }

  void randomCasesAgree() {
    Counts counts;
    for (int i = 0; i < rounds(150); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 9000 + static_cast<std::uint64_t>(i));
      if (one.soup.size() > 30 || one.clearance < 1e-3) continue;
      const auto isOf = [&](const char* kind) { return one.kind.find(kind) != std::string::npos; };
      double largest = 1, low = 1e300, high = -1e300;
      for (const auto& triangle : one.soup.triangles())
        for (const Vec3& v : triangle) {
          largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
          low = std::min(low, v.x);
          high = std::max(high, v.x);
        }
      const double gap = 0.004 * std::min(one.clearance, high - low);
      try {
        QVERIFY2(
            agreesWithDefinition(one.soup.environment(one.bothSides), one.clearance, 0.3 * one.clearance, gap,
                                 // Some links are missing in clusters of vertices, and far from the origin.
                                 isOf("tiny") || isOf("nearly") || isOf("far") ? 0 : 1e-9 * largest, counts),
            qPrintable(
                QString("case %1 (%2), clearance %3").arg(i).arg(QString::fromStdString(one.kind)).arg(one.clearance)));
      } catch (const InputError&) {  // too small a height beside the coordinates
      }
    }
    qInfo("%zu links, %zu expected places", counts.linked, counts.expected);
    QVERIFY(counts.linked > 10);
  }

  void moreGapNeverPartsAndOrderChangesNothing() {
    std::mt19937 random(7);
    for (int i = 0; i < rounds(60); ++i) {
      const auto environment = randomSlits(random).environment();
      std::size_t before = 1U << 30U;
      double length = 0;
      for (const double gap : {0.0, 0.01, 0.1, 0.3}) {
        const std::string text = gaps(2, 0.3, gap) + "SimplificationFilter\n";
        const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
        QCOMPARE(findMeshError(mesh), std::string());
        QVERIFY2(parts(mesh) <= before, qPrintable(QString::number(i)));
        before = parts(mesh);
        QVERIFY2(gapLength(mesh) >= length - 1e-6, qPrintable(QString::number(i)));
        length = gapLength(mesh);
        for (const StepLink& link : mesh.links) QVERIFY(link.width <= gap * (1 + 1e-12));
        std::vector<std::uint32_t> order(environment->triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3, [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), text)); });
        QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices);
        QVERIFY(std::equal(other.links.begin(), other.links.end(), mesh.links.begin(), mesh.links.end(),
                           [](const StepLink& a, const StepLink& b) {
                             return a.from == b.from && a.to == b.to && a.kind == b.kind && a.width == b.width &&
                                    a.height == b.height;
                           }));
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestGapDefinition)
#include "test_gap_definition.moc"
