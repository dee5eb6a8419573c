// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/bent_margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"

namespace footfall::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnit = MarginSurface::kUnit;
constexpr double kShort = MarginSurface::kShort;
constexpr double kTouch = MarginSurface::kTouch;
constexpr double kNoise = 4096 * kTouch;  // of sums of turns
constexpr std::size_t kSourcesPerTask = 8;

/// The half-plane on the side of a line that a unit vector points to.
struct HalfPlane {
  PlanVector origin, normal;
  [[nodiscard]] double inside(const PlanVector& p) const { return dot(p - origin, normal); }
};

void clip(std::vector<PlanVector>& corners, const HalfPlane& half) {
  std::size_t inside = 0;
  for (const PlanVector& p : corners) inside += half.inside(p) >= 0 ? 1 : 0;
  if (inside == corners.size()) return;
  if (inside == 0) {
    corners.clear();
    return;
  }
  std::vector<PlanVector> kept;
  kept.reserve(corners.size() + 2);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanVector &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double a = half.inside(p), b = half.inside(q);
    if (a >= 0) kept.push_back(p);
    if (a * b < 0) kept.push_back(p + (a / (a - b)) * (q - p));
  }
  corners = std::move(kept);
}

HalfPlane leftOfEdge(const PlanVector& a, const PlanVector& b) { return {a, unitOf(leftOf(b - a))}; }

// The side of a beam on which higher ones are.
HalfPlane above(const Beams& beams, double at) { return {beams.origin + at * beams.along, beams.along}; }
HalfPlane above(const Rays& rays, double at) {
  const PlanVector direction = (1 - std::fabs(at)) * rays.middle + at * leftOf(rays.middle);
  return {rays.apex, unitOf(leftOf(direction))};
}
HalfPlane opposite(const HalfPlane& half) { return {half.origin, -1.0 * half.normal}; }

// Places so near have no direction.
bool hasBeam(const Beams& /*beams*/, const PlanVector& /*p*/, double /*slack*/) { return true; }
bool hasBeam(const Rays& rays, const PlanVector& p, double slack) { return length(p - rays.apex) > slack + kShort; }

double distanceTo(const Beams& beams, const PlanVector& p) { return dot(p - beams.origin, leftOf(beams.along)); }
double distanceTo(const Rays& rays, const PlanVector& p) { return length(p - rays.apex); }
PlanVector directionTo(const Beams& beams, const PlanVector& /*p*/) { return leftOf(beams.along); }
PlanVector directionTo(const Rays& rays, const PlanVector& p) { return unitOf(p - rays.apex); }

bool isInCone(const PlanVector& d, const PlanVector& right, const PlanVector& left) {
  const double hair = -kTouch * length(d);
  return cross(right, d) >= hair * length(right) && cross(d, left) >= hair * length(left);
}

}  // namespace

/// A margin before it is cut off, and the beams that make it.
struct BentMargins::Polygon {
  std::vector<PlanVector> corners;  ///< counter-clockwise
  double low = 0, high = 0;         ///< beams
  double joint = 0;                 ///< what beams that are one may be apart
  double slack = 0, passed = 0;
  double doubt = 0;  ///< of the beams' directions
};

BentMargins::BentMargins(const MarginSurface& surface, const ClipBox& box, const std::vector<BorderChain>& chains,
                         const std::vector<double>& asked, const ArcSteps& arcs, RunContext& context)
    : surface_(surface),
      box_(box),
      chains_(chains),
      asked_(asked),
      arcs_(arcs),
      context_(context),
      isBent_(chains.size(), 0) {
  if (chains.empty()) return;
  const auto [least, most] = std::minmax_element(asked.begin(), asked.end());
  smaller_ = *least;
  larger_ = *most;
  if (smaller_ == larger_) return;
  PlanVector d{1, 0};
  for (bool hasTurned = false; !hasTurned || d.y > 0; ++arcCount_) {
    d = arcs_.next(d);
    hasTurned = hasTurned || d.y > 0;
  }
  findBent();
  findCorners();
}

// Chains of the larger distance that have one of the smaller distance as near as that.
void BentMargins::findBent() {
  std::vector<Index> others;
  for (Index i = 0; i < static_cast<Index>(chains_.size()); ++i)
    if (!isLarger(i)) others.push_back(i);
  const auto boundsOf = [&](Index i, double more) {
    const PlanVector &a = chains_[i].begin, &b = chains_[i].end;
    return BoxTree<2>::Bounds{{std::min(a.x, b.x) - more, std::min(a.y, b.y) - more},
                              {std::max(a.x, b.x) + more, std::max(a.y, b.y) + more}};
  };
  BoxTree<2> tree;
  tree.build(
      others, [&](Index i) { return boundsOf(i, 0); }, context_);
  for (Index i = 0; i < static_cast<Index>(chains_.size()); ++i) {
    if (!isLarger(i)) continue;
    const double most = 1.25 * (larger_ + chains_[i].slack + kShort);
    tree.visitOverlapping(boundsOf(i, most), [&](Index) { isBent_[i] = 1; });
  }
}

// Finds the corners between chains of the smaller distance; corners at which a chain of the larger one ends are sources
// themselves.
void BentMargins::findCorners() {
  cornerOf_.assign(static_cast<std::size_t>(surface_.sideCount()), -1);
  std::vector<Index> fan;
  for (Index i = 0; i < static_cast<Index>(chains_.size()); ++i) {
    const BorderChain& chain = chains_[i];
    if (chain.behind < 0 || chain.endsInside || isLarger(i) || isLarger(chain.behind)) continue;
    fanBehind(surface_, chain, fan);
    const std::optional<double> turn = turnOf(fan);
    if (turn && *turn < 2 - kNoise) continue;
    for (const Index side : fan) cornerOf_[side] = i;
  }
}

// The extent of a fan, in numbers of turnFrom(); empty where doubles cannot decide it.
std::optional<double> BentMargins::turnOf(const std::vector<Index>& fan) const {
  const PlanVector back = surface_.begin(MarginSurface::previousSide(fan.front())) - surface_.begin(fan.front());
  double turn = 0;
  for (const Index side : fan) {
    const PlanVector ray = surface_.end(side) - surface_.begin(side);
    if (length(ray) < kShort || length(back) < kShort) return std::nullopt;
    const double more = std::fmod(-turnFrom(back, ray) - turn, 4);
    turn += more < 0 ? more + 4 : more;
  }
  return turn;
}

double BentMargins::slackAt(Index corner) const {
  const BorderChain& chain = chains_[corner];
  return chain.behind < 0 ? chain.slack : std::max(chain.slack, chains_[chain.behind].slack);
}

// The source at the end of a chain, where that chain or the next one has the larger distance.
BentMargins::Source BentMargins::sourceAtEnd(Index corner) const {
  const BorderChain& chain = chains_[corner];
  Source source{chain.end, {}, 0, 0, slackAt(corner), {}, {1, 0}};
  fanBehind(surface_, chain, source.fan);
  const std::optional<double> turn = chain.endsInside ? 2 : turnOf(source.fan);
  double more = 0;
  const auto look = [&](Index i, double sign) {  // what is before an edge is nearer to that
    if (!isLarger(i)) return;
    const BorderChain& own = chains_[i];
    if (own.isShort) {
      source.fan.insert(source.fan.end(), own.sides.begin(), own.sides.end());
      more = kShort;
    } else if (turn && *turn < 4 + kNoise) {
      source.needless.push_back({sign * own.along, leftOf(own.along), kTouch + 16 * kUnit / own.size()});
      source.first = sign < 0 ? leftOf(own.along) : own.along;
    }
  };
  look(chain.behind, 1);
  look(corner, -1);
  source.reach = larger_ * (1 + 0x1p-46) + source.slack + more;
  return source;
}

// A walk bends towards the border: to the left if the edges at the corner are to the left of the walk.
BentMargins::Source BentMargins::sourceAtBend(const Arrival& arrival) const {
  const BorderChain &chain = chains_[arrival.corner], &next = chains_[chain.behind];
  Source source{chain.end, {}, arrival.passed, 0, slackAt(arrival.corner), {}, {1, 0}};
  fanBehind(surface_, chain, source.fan);
  source.reach = larger_ * (1 + 0x1p-46) + source.slack - source.passed;
  const std::optional<double> turn = turnOf(source.fan);
  if (chain.isShort || next.isShort || !turn || *turn > 4 + kNoise) return source;
  const double doubt = arrival.doubt + kTouch + 16 * kUnit / std::min(chain.size(), next.size());
  const double back = -cross(arrival.along, chain.along), ahead = cross(arrival.along, next.along);
  const bool isLeft = std::max(back, ahead) > doubt, isRight = std::min(back, ahead) < -doubt;
  if (isLeft == isRight) return source;
  const PlanVector away = (isLeft ? -1.0 : 1.0) * leftOf(arrival.along);
  source.needless.push_back({away, away, doubt});
  source.first = (isLeft ? -1.0 : 1.0) * arrival.along;
  return source;
}

std::vector<Margin> BentMargins::find() const {
  const auto count = static_cast<Index>(chains_.size());
  std::vector<Found> found(chains_.size());
  PerThread<BeamTracer> tracers([&] { return BeamTracer(surface_, context_); });
  parallelRanges(count, kSourcesPerTask, [&](const auto& range) {
    BeamTracer& tracer = tracers.local();
    for (Index i = range.begin(); i != range.end(); ++i) {
      context_.checkCancelled();
      const BorderChain& chain = chains_[i];
      if (has(i) && !chain.isShort) addBeams(chain, tracer, found[i]);
      const bool isPlace = chain.isShort && chain.before < 0;
      if ((has(i) && (chain.behind >= 0 || isPlace)) || (chain.behind >= 0 && has(chain.behind)))
        addSectors(sourceAtEnd(i), tracer, found[i]);
    }
  });
  std::vector<Margin> margins;
  std::vector<Arrival> arrivals;
  const auto take = [&](Found& some) {
    for (Margin& margin : some.margins) margins.push_back(std::move(margin));
    arrivals.insert(arrivals.end(), some.arrivals.begin(), some.arrivals.end());
  };
  for (Found& some : found) take(some);

  // Sources are sorted by the length that they have passed; the first found comes first among equals.
  using Next = std::pair<double, std::size_t>;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
  std::vector<char> isDone(chains_.size(), 0);
  std::size_t queued = 0;
  const auto enqueue = [&] {
    for (; queued < arrivals.size(); ++queued) queue.push({arrivals[queued].passed, queued});
  };
  for (enqueue(); !queue.empty(); enqueue()) {
    const Arrival arrival = arrivals[queue.top().second];
    queue.pop();
    if (isDone[arrival.corner] != 0) continue;
    isDone[arrival.corner] = 1;
    context_.checkCancelled();
    Found more;
    addSectors(sourceAtBend(arrival), tracers.local(), more);
    take(more);
  }
  return margins;
}

void BentMargins::addBeams(const BorderChain& chain, BeamTracer& tracer, Found& found) const {
  const double slack = chain.slack, distance = larger_ * (1 + 0x1p-46) + slack;
  const PlanVector out = leftOf(chain.along);
  const PlanVector from = chain.begin - slack * chain.along, to = chain.end + slack * chain.along;
  const Polygon polygon{{from - slack * out, to - slack * out, to + distance * out, from + distance * out},
                        0,
                        chain.size(),
                        2 * MarginSurface::kSlack,
                        slack,
                        0,
                        16 * kUnit / chain.size()};
  const Beams beams{chain.begin, chain.along, distance + slack};
  tracer.start();
  for (const Index side : chain.sides)  // it may begin or end inside of one
    tracer.enter(side, std::max(beams.at(surface_.begin(side)), polygon.low),
                 std::min(beams.at(surface_.end(side)), polygon.high));
  tracer.run(beams);
  addPieces(polygon, beams, tracer, found);
}

void BentMargins::addSectors(const Source& source, BeamTracer& tracer, Found& found) const {
  std::vector<PlanVector> directions{source.first};
  for (std::size_t i = 0; i < arcCount_; ++i) {
    const PlanVector d = directions.back();
    directions.push_back(arcs_.next(d));
  }
  const auto isNeeded = [&](std::size_t i) {
    return std::none_of(source.needless.begin(), source.needless.end(), [&](const Needless& needless) {
      const auto has = [&](const PlanVector& d) {
        return dot(d, needless.one) > needless.doubt && dot(d, needless.other) > needless.doubt;
      };
      return has(directions[i]) && has(directions[i + 1]);
    });
  };
  // Each polygon can get two corners where it is cut off, and four at the sides of the box.
  const PlanVector more{1.25 * source.reach, 1.25 * source.reach};
  const bool isInBox = box_.holds(source.apex - more) && box_.holds(source.apex + more);
  const std::size_t most = isInBox ? arcs_.perMargin : std::min<std::size_t>(arcs_.perMargin, 3);
  for (std::size_t i = 0; i < arcCount_;) {
    std::size_t j = i;
    while (j < arcCount_ && j - i < most && isNeeded(j)) ++j;
    if (j > i) addSector(source, {directions.data() + i, j - i + 1}, tracer, found);
    i = std::max(j, i + 1);
  }
}

void BentMargins::addSector(const Source& source, std::span<const PlanVector> directions, BeamTracer& tracer,
                            Found& found) const {
  const PlanVector &apex = source.apex, &first = directions.front(), &last = directions.back();
  const Rays rays{apex, unitOf(first + last), 1.25 * source.reach};
  Polygon polygon{{},
                  turnFrom(rays.middle, last) - kTouch,
                  turnFrom(rays.middle, first) + kTouch,
                  4 * kTouch,
                  source.slack,
                  source.passed,
                  0};
  const auto reaches = [&](Index side) {
    const PlanVector right = surface_.end(side) - apex, left = surface_.begin(MarginSurface::previousSide(side)) - apex;
    return length(surface_.begin(side) - apex) > 0 || length(right) < kShort || length(left) < kShort ||
           isInCone(right, last, first) || isInCone(left, last, first) || isInCone(last, right, left) ||
           isInCone(first, right, left);
  };
  tracer.start();
  bool isReached = false;
  for (const Index side : source.fan) {
    if (!reaches(side)) continue;
    isReached = true;
    tracer.enter(side, polygon.low, polygon.high);
  }
  if (!isReached) return;
  tracer.run(rays);
  std::vector<PlanVector>& corners = polygon.corners;
  corners = {apex - source.slack * rays.middle, apex + source.reach * last - 2 * source.slack * leftOf(last)};
  for (std::size_t i = directions.size(); --i > 0;) {
    const PlanVector middle = directions[i] + directions[i - 1];
    corners.push_back(apex + (source.reach / (1 + dot(directions[i], directions[i - 1]))) * middle);
  }
  corners.push_back(apex + source.reach * first + 2 * source.slack * leftOf(first));
  addPieces(polygon, rays, tracer, found);
}

// The whole polygon on triangles of which no part within it is hidden, and for each other stretch of beams what is
// left of it.
template <class View>
void BentMargins::addPieces(const Polygon& polygon, const View& view, BeamTracer& tracer, Found& found) const {
  std::map<std::pair<double, double>, std::vector<Index>> pieces;  // triangles, by the first and the last beam
  const std::vector<BeamWindow>& windows = tracer.join(polygon.joint);
  std::vector<HalfPlane> halves;
  halves.reserve(polygon.corners.size());
  for (std::size_t k = 0; k < polygon.corners.size(); ++k)
    halves.push_back(leftOfEdge(polygon.corners[k], polygon.corners[(k + 1) % polygon.corners.size()]));
  std::vector<PlanVector> part;
  for (std::size_t i = 0, next = 0; i < windows.size(); i = next) {
    const Index triangle = windows[i].triangle;
    while (next < windows.size() && windows[next].triangle == triangle) ++next;
    part = {surface_.begin(3 * triangle), surface_.begin(3 * triangle + 1), surface_.begin(3 * triangle + 2)};
    for (std::size_t k = 0; k < halves.size() && !part.empty(); ++k) clip(part, halves[k]);
    double low = kInfinity, high = -kInfinity;
    for (const PlanVector& p : part) {
      if (!hasBeam(view, p, 4 * polygon.slack)) continue;
      low = std::min(low, view.at(p));
      high = std::max(high, view.at(p));
    }
    low = std::max(low, polygon.low) + polygon.joint;
    high = std::min(high, polygon.high) - polygon.joint;
    for (std::size_t w = i; w < next; ++w) {
      addArrivals(polygon, view, windows[w], found);
      if (windows[w].high < low - 2 * polygon.joint || windows[w].low > high + 2 * polygon.joint) continue;
      pieces[{windows[w].low <= low ? -kInfinity : windows[w].low,
              windows[w].high >= high ? kInfinity : windows[w].high}]
          .push_back(surface_.face(3 * triangle));
    }
  }
  for (auto& [beams, faces] : pieces) {
    std::vector<PlanVector> corners = polygon.corners;
    const auto cutOff = [&](HalfPlane half) {
      half.origin = half.origin - 2 * polygon.slack * half.normal;
      clip(corners, half);
    };
    if (beams.first > -kInfinity) cutOff(above(view, beams.first));
    if (beams.second < kInfinity) cutOff(opposite(above(view, beams.second)));
    addMargin(std::move(corners), std::move(faces), found);
  }
}

template <class View>
void BentMargins::addArrivals(const Polygon& polygon, const View& view, const BeamWindow& window, Found& found) const {
  for (Index k = 0; k < 3; ++k) {
    const Index corner = cornerOf_[3 * window.triangle + k];
    if (corner < 0) continue;
    const PlanVector p = surface_.begin(3 * window.triangle + k);
    const bool isClose = !hasBeam(view, p, 0);
    const double at = view.at(p), far = distanceTo(view, p);
    if (!isClose && (far < -polygon.slack || at < window.low - view.touch || at > window.high + view.touch)) continue;
    const double passed = polygon.passed + std::max(far - 4 * kUnit, 0.0);
    if (passed + smaller_ > larger_) continue;
    found.arrivals.push_back({corner, passed, isClose ? PlanVector{1, 0} : directionTo(view, p),
                              isClose ? 2 : polygon.doubt + 8 * kUnit / std::max(far, kUnit)});
  }
}

void BentMargins::addMargin(std::vector<PlanVector> corners, std::vector<Index> faces, Found& found) const {
  for (PlanVector& p : corners) p = roundToUnit(p);
  if (corners.size() < 3) return;
  corners = hullOf(std::move(corners));
  if (box_.clip(corners)) corners = hullOf(std::move(corners));
  if (corners.size() < 3) return;
  sortOnce(faces);
  found.margins.push_back({std::move(corners), std::move(faces)});
}

}  // namespace footfall::detail
