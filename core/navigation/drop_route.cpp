// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/drop_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "core/base/infinity.hpp"
#include "core/base/vector.hpp"
#include "core/navigation/plan_distance.hpp"

namespace footfall::detail {
namespace {

constexpr double kGoodEnough = 0.01;           // share of the proven lower bound
constexpr std::size_t kMostWork = 200'000;     // nodes of the searches for paths between drops
constexpr std::size_t kWorkOfPath = 64;        // additional work of each path
constexpr std::size_t kMostTries = 4'000'000;  // limit for one piece after another one
constexpr std::size_t kTriesPerPoll = 4096;
constexpr int kMends = 4;     // mends of a way, each of which looks for its bends again
constexpr int kSweeps = 100;  // passes over the drops of a way, each of which is moved

using Segment = std::array<Vec3, 2>;

Vec3 between(const Segment& ends, double t) {
  const auto& [a, b] = ends;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

double segmentDistance(const Vec3& p, const Segment& s) {
  const double dx = s[1].x - s[0].x, dy = s[1].y - s[0].y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - s[0].x) * dx + (p.y - s[0].y) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(s[0].x + t * dx - p.x, s[0].y + t * dy - p.y);
}

double sideOf(const Segment& s, const Vec3& p) {
  return (s[1].x - s[0].x) * (p.y - s[0].y) - (s[1].y - s[0].y) * (p.x - s[0].x);
}

double segmentDistance(const Segment& a, const Segment& b) {
  const bool cross = sideOf(a, b[0]) * sideOf(a, b[1]) < 0 && sideOf(b, a[0]) * sideOf(b, a[1]) < 0;
  if (cross) return 0;
  return std::min(
      {segmentDistance(a[0], b), segmentDistance(a[1], b), segmentDistance(b[0], a), segmentDistance(b[1], a)});
}

/// The minimum of a convex function in [0, 1], to about 1e-7 (Kiefer 1953).
template <class Function>
double leastOf(Function f) {
  constexpr double kGolden = 0.6180339887498949;
  double low = 0, high = 1, a = 1 - kGolden, b = kGolden, fa = f(a), fb = f(b);
  for (int i = 0; i < 34; ++i) {
    if (fa <= fb) {
      high = b, b = a, fb = fa;
      a = high - kGolden * (high - low), fa = f(a);
    } else {
      low = a, a = b, fa = fb;
      b = low + kGolden * (high - low), fb = f(b);
    }
  }
  const double middle = (low + high) / 2;
  double best = f(0) <= f(middle) ? 0 : middle;
  if (f(1) < f(best)) best = 1;
  return best;
}

class DropSearch {
 public:
  DropSearch(const NavigationMesh& mesh, const SurfaceTopology& topology, const RouteEnd& from, const RouteEnd& to,
             const LegFinder& legBetween, Poll poll)
      : mesh_(mesh), topology_(topology), from_(from), to_(to), legBetween_(legBetween), poll_(poll) {}

  std::optional<DropRoute> run() {
    if (!makePieces()) return std::nullopt;
    DropRoute best;
    best.planLength = kInfinity;
    double least = 0;
    while (best.planLength > least * (1 + kGoodEnough)) {
      std::vector<std::uint32_t> chain;
      const double bound = shortestChain(best.planLength, chain);
      least = std::max(least, std::min(bound, best.planLength));
      if (chain.empty() || work_ >= kMostWork) break;
      const bool wasKnown = computeLegs(chain);
      DropRoute route = routeOf(chain);
      if (route.planLength < best.planLength) {
        mend(route);
        best = std::move(route);
      }
      if (wasKnown) halve(chain);
    }
    if (best.stops.empty()) return std::nullopt;
    best.leastPlanLength = std::min(least, best.planLength);
    return best;
  }

 private:
  /// A part of a drop's stretch.
  struct Piece {
    std::uint32_t drop = 0;
    double begin = 0, end = 1;
    Segment start, landing;
    double startHalf = 0, landingHalf = 0;  ///< half of their lengths in the plan
    double least = 0;                       ///< no drop of it is shorter in the plan
    double toGoal = 0;                      ///< no way from it to the goal is shorter
  };
  /// The places before the first piece and behind the last one in chains.
  static constexpr std::uint32_t kFrom = kNoElement - 1, kTo = kNoElement - 2;

  [[nodiscard]] std::uint32_t partBefore(const Piece& p) const {
    return topology_.components[mesh_.drops[p.drop].fromTriangle];
  }
  [[nodiscard]] std::uint32_t partBehind(const Piece& p) const {
    return topology_.components[mesh_.drops[p.drop].toTriangle];
  }

  [[nodiscard]] Piece pieceOf(std::uint32_t number, double begin, double end) const {
    const DropLink& drop = mesh_.drops[number];
    Piece p{number,
            begin,
            end,
            {between(drop.start, begin), between(drop.start, end)},
            {between(drop.landing, begin), between(drop.landing, end)},
            0,
            0,
            0,
            0};
    p.startHalf = planDistance(p.start[0], p.start[1]) / 2;
    p.landingHalf = planDistance(p.landing[0], p.landing[1]) / 2;
    p.least = segmentDistance(Vec3{}, Segment{p.landing[0] - p.start[0], p.landing[1] - p.start[1]});
    p.toGoal = segmentDistance(to_.place, p.landing);
    return p;
  }

  /// Makes pieces of the drops between parts that lie on some way. False when there is no way.
  bool makePieces() {
    const auto partsBefore = partsOverDrops(mesh_, topology_, topology_.components[from_.triangle]);
    const std::uint32_t last = topology_.components[to_.triangle];
    if (partsBefore[last] == 0) return false;
    std::vector<std::vector<std::uint32_t>> ledBy(topology_.componentCount);
    const auto partsOf = [&](const DropLink& d) {
      return std::pair{topology_.components[d.fromTriangle], topology_.components[d.toTriangle]};
    };
    for (const DropLink& drop : mesh_.drops)
      if (const auto parts = partsOf(drop); parts.first != kNoElement && parts.second != kNoElement)
        ledBy[parts.second].push_back(parts.first);
    std::vector<char> leadsToGoal(topology_.componentCount, 0);
    std::vector<std::uint32_t> open{last};
    leadsToGoal[last] = 1;
    while (!open.empty()) {
      const std::uint32_t part = open.back();
      open.pop_back();
      for (const std::uint32_t before : ledBy[part])
        if (std::exchange(leadsToGoal[before], 1) == 0) open.push_back(before);
    }
    startingIn_.resize(topology_.componentCount);
    for (std::uint32_t i = 0; i < mesh_.drops.size(); ++i) {
      const auto parts = partsOf(mesh_.drops[i]);
      if (parts.first == kNoElement || parts.second == kNoElement || parts.first == parts.second) continue;
      if (partsBefore[parts.first] != 0 && leadsToGoal[parts.second] != 0) addPiece(pieceOf(i, 0, 1));
    }
    return true;
  }

  void addPiece(const Piece& p) {
    startingIn_[partBefore(p)].push_back(static_cast<std::uint32_t>(pieces_.size()));
    pieces_.push_back(p);
  }

  /// A lower bound of any way from a landing of `a` to a start of `b`.
  [[nodiscard]] double leastBetween(std::uint32_t a, std::uint32_t b) const {
    double straight = 0;
    if (a == kFrom)
      straight = segmentDistance(from_.place, pieces_[b].start);
    else if (b == kTo)
      straight = pieces_[a].toGoal;
    else
      straight = segmentDistance(pieces_[a].landing, pieces_[b].start);
    const auto known = known_.find({a, b});
    return known == known_.end() ? straight : std::max(straight, known->second);
  }

  /// The chain with the least length that no way is shorter than, and that length. Nothing, and `limit`, where no chain
  /// is shorter than `limit`; where there were too many tries, what is certain.
  double shortestChain(double limit, std::vector<std::uint32_t>& chain) {
    std::vector<double> lengths(pieces_.size(), kInfinity);
    std::vector<std::uint32_t> before(pieces_.size(), kNoElement);
    using Open = std::tuple<double, double, std::uint32_t>;  // length with the way to the goal, length without, piece
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    const std::uint32_t last = topology_.components[to_.triangle];
    double shortest = limit;
    std::uint32_t end = kNoElement;
    const auto follow = [&](std::uint32_t piece, double length, std::uint32_t part) {
      if (part == last && piece != kFrom) {
        const double whole = length + leastBetween(piece, kTo);
        if (whole < shortest) shortest = whole, end = piece;
      }
      for (const std::uint32_t next : startingIn_[part]) {
        if (++tries_ % kTriesPerPoll == 0) poll_();
        const Piece& p = pieces_[next];
        const double reached = length + leastBetween(piece, next) + p.least;
        if (!(reached < lengths[next]) || !(reached + p.toGoal < shortest)) continue;
        lengths[next] = reached;
        before[next] = piece;
        open.emplace(reached + p.toGoal, reached, next);
      }
    };
    follow(kFrom, 0, topology_.components[from_.triangle]);
    while (!open.empty()) {
      const auto [whole, length, piece] = open.top();
      if (whole >= shortest) break;
      if (tries_ > kMostTries && shortest < kInfinity) {
        work_ = kMostWork;  // no more after this one
        if (limit < kInfinity) return whole;
        break;
      }
      open.pop();
      if (length > lengths[piece]) continue;
      follow(piece, length, partBehind(pieces_[piece]));
    }
    const double certain = open.empty() ? shortest : std::min(shortest, std::get<0>(open.top()));
    for (std::uint32_t piece = end; piece != kNoElement && piece != kFrom; piece = before[piece])
      chain.push_back(piece);
    std::reverse(chain.begin(), chain.end());
    return certain;
  }

  [[nodiscard]] RouteEnd startOf(const DropStop& stop) const {
    return {stop.start, mesh_.drops[stop.drop].fromTriangle};
  }
  [[nodiscard]] RouteEnd landingOf(const DropStop& stop) const {
    return {stop.landing, mesh_.drops[stop.drop].toTriangle};
  }
  [[nodiscard]] DropStop stopAt(std::uint32_t drop, double t) const {
    return {drop, between(mesh_.drops[drop].start, t), between(mesh_.drops[drop].landing, t)};
  }
  [[nodiscard]] DropStop middleOf(std::uint32_t piece) const {
    const Piece& p = pieces_[piece];
    return stopAt(p.drop, (p.begin + p.end) / 2);
  }

  RouteLeg leg(const RouteEnd& a, const RouteEnd& b) {
    const RouteLeg found = legBetween_(a, b);
    work_ += kWorkOfPath + found.work;
    return found;
  }

  /// Computes the paths between the middles of the pieces; returns true when all of them were known.
  bool computeLegs(const std::vector<std::uint32_t>& chain) {
    bool allKnown = true;
    for (std::size_t i = 0; i <= chain.size(); ++i) {
      const std::uint32_t a = i == 0 ? kFrom : chain[i - 1], b = i == chain.size() ? kTo : chain[i];
      if (!middles_.contains({a, b})) {
        allKnown = false;
        const RouteEnd begin = a == kFrom ? from_ : landingOf(middleOf(a));
        const double length = leg(begin, b == kTo ? to_ : startOf(middleOf(b))).planLength;
        middles_[{a, b}] = length;
        double& bound = known_[{a, b}];
        bound =
            std::max(bound, length - (a == kFrom ? 0 : pieces_[a].landingHalf) - (b == kTo ? 0 : pieces_[b].startHalf));
      }
    }
    return allKnown;
  }

  /// The route through the middles of the pieces.
  [[nodiscard]] DropRoute routeOf(const std::vector<std::uint32_t>& chain) const {
    DropRoute route;
    for (std::size_t i = 0; i <= chain.size(); ++i)
      route.planLength += middles_.at({i == 0 ? kFrom : chain[i - 1], i == chain.size() ? kTo : chain[i]});
    for (const std::uint32_t piece : chain) {
      route.stops.push_back(middleOf(piece));
      route.planLength += planDistance(route.stops.back().start, route.stops.back().landing);
    }
    return route;
  }

  [[nodiscard]] std::vector<RouteLeg> legsOf(const std::vector<DropStop>& stops) {
    std::vector<RouteLeg> legs;
    for (std::size_t i = 0; i <= stops.size(); ++i)
      legs.push_back(leg(i == 0 ? from_ : landingOf(stops[i - 1]), i == stops.size() ? to_ : startOf(stops[i])));
    return legs;
  }

  /// Moves the places of a way along their drops while that makes it shorter.
  void mend(DropRoute& route) {
    DropRoute tried = route;
    for (int i = 0; i < kMends && work_ < kMostWork; ++i) {
      const std::vector<RouteLeg> legs = legsOf(tried.stops);
      tried.planLength = 0;
      for (const RouteLeg& l : legs) tried.planLength += l.planLength;
      for (const DropStop& s : tried.stops) tried.planLength += planDistance(s.start, s.landing);
      const bool isLittle = i > 0 && tried.planLength > route.planLength * (1 - 1e-9);
      if (tried.planLength < route.planLength) route = tried;
      if (isLittle) return;
      straighten(tried.stops, legs);
    }
  }

  /// Puts places where the way between the bends of its legs is shortest.
  void straighten(std::vector<DropStop>& stops, const std::vector<RouteLeg>& legs) const {
    double before = kInfinity;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      double length = 0;
      for (std::size_t i = 0; i < stops.size(); ++i) {
        const std::uint32_t drop = stops[i].drop;
        const Vec3 from = i > 0 && legs[i].isStraight ? stops[i - 1].landing : legs[i].last;
        const Vec3 to = i + 1 < stops.size() && legs[i + 1].isStraight ? stops[i + 1].start : legs[i + 1].first;
        const auto lengthAt = [&](double t) {
          const DropStop s = stopAt(drop, t);
          return planDistance(from, s.start) + planDistance(s.start, s.landing) + planDistance(s.landing, to);
        };
        const double t = leastOf(lengthAt);
        stops[i] = stopAt(drop, t);
        length += lengthAt(t);
      }
      if (!(length < before * (1 - 1e-12))) return;
      before = length;
    }
  }

  /// Halves the pieces of a chain that are at least half as long as the longest. Results for a piece also hold for its
  /// halves.
  void halve(const std::vector<std::uint32_t>& chain) {
    double longest = 0;
    for (const std::uint32_t i : chain) longest = std::max(longest, pieces_[i].startHalf + pieces_[i].landingHalf);
    for (const std::uint32_t i : chain) {
      const Piece p = pieces_[i];
      const auto other = static_cast<std::uint32_t>(pieces_.size());
      const double middle = (p.begin + p.end) / 2;
      if (p.startHalf + p.landingHalf < longest / 2 || !(p.begin < middle && middle < p.end)) continue;
      pieces_[i] = pieceOf(p.drop, p.begin, middle);
      addPiece(pieceOf(p.drop, middle, p.end));
      std::vector<std::pair<Pair, double>> copies;
      for (const auto& [pair, length] : known_)
        if (pair.first == i || pair.second == i)
          copies.emplace_back(Pair{pair.first == i ? other : pair.first, pair.second == i ? other : pair.second},
                              length);
      known_.insert(copies.begin(), copies.end());
      std::erase_if(middles_, [&](const auto& m) { return m.first.first == i || m.first.second == i; });
    }
  }

  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  const NavigationMesh& mesh_;
  const SurfaceTopology& topology_;
  RouteEnd from_, to_;
  const LegFinder& legBetween_;
  Poll poll_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<std::uint32_t>> startingIn_;  ///< pieces, for each part
  std::map<Pair, double> known_;                        ///< lower bound of any way between two pieces
  std::map<Pair, double> middles_;                      ///< lengths of the paths between their middles
  std::size_t work_ = 0, tries_ = 0;
};

}  // namespace

std::vector<char> partsOverDrops(const NavigationMesh& mesh, const SurfaceTopology& topology, std::uint32_t part) {
  std::vector<std::vector<std::uint32_t>> next(topology.componentCount);
  for (const DropLink& drop : mesh.drops) {
    const std::uint32_t from = topology.components[drop.fromTriangle], to = topology.components[drop.toTriangle];
    if (from != kNoElement && to != kNoElement) next[from].push_back(to);
  }
  std::vector<char> reached(topology.componentCount, 0);
  reached[part] = 1;
  std::vector<std::uint32_t> open{part};
  while (!open.empty()) {
    const std::uint32_t from = open.back();
    open.pop_back();
    for (const std::uint32_t to : next[from])
      if (std::exchange(reached[to], 1) == 0) open.push_back(to);
  }
  return reached;
}

std::optional<DropRoute> findDropRoute(const NavigationMesh& mesh, const SurfaceTopology& topology,
                                       const RouteEnd& from, const RouteEnd& to, const LegFinder& legBetween,
                                       Poll poll) {
  if (topology.components[from.triangle] == topology.components[to.triangle]) return std::nullopt;
  return DropSearch(mesh, topology, from, to, legBetween, poll).run();
}

}  // namespace footfall::detail
