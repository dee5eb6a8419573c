// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/margins.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/number_text.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/radius/bent_margins.hpp"
#include "core/filters/radius/border_chains.hpp"
#include "core/filters/radius/margin_spread.hpp"
#include "core/filters/radius/plan_polygon.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr double kShort = MarginSurface::kShort;
constexpr double kTouch = MarginSurface::kTouch;
constexpr Index kChainsPerTask = 16;

/// The end of one chain and the beginning of the next.
struct Corner {
  /// The places where neighbouring tangents of the arc meet, clockwise; for a mitre, the one place where the two edges'
  /// parallels meet. Empty where the two rectangles are independent.
  std::vector<PlanVector> tangents;
  std::vector<double> turns;  ///< of these, clockwise from the first chain's direction backwards
  std::size_t split = 0;      ///< the first chain has those up to this one, the second from here on
  bool hasSecond = false;     ///< has a part of it
  bool isMitre = false;
  std::vector<Index> fan;                     ///< MarginSurface::fanBehind()
  double end = 0;                             ///< turn of the second chain
  std::vector<std::array<double, 2>> wedges;  ///< for each side of the fan the turns between which its triangle lies
};

class MarginFinder {
 public:
  MarginFinder(const WalkableState& state, const MarginDistances& distances, RunContext& context,
               ExactFallbacks& fallbacks)
      : state_(state), context_(context), fallbacks_(fallbacks), surface_(state, context), box_(surface_) {
    // A straight walk comes to a border within the diagonal: a larger distance leaves nothing, as this one does.
    walls_ = std::min(distances.walls, 2 * box_.diagonal());
    ledges_ = std::min(distances.ledges, 2 * box_.diagonal());
    const double half = 1 / (1 + 0.9 * distances.tolerance);  // cosine of half the angle of an arc
    arcs_.cosine = 2 * half * half - 1;
    arcs_.sine = 2 * half * std::sqrt(1 - half * half);
    arcs_.perMargin = arcs_.cosine > 0.95 ? 5 : arcs_.cosine > 0.87 ? 3 : 2;  // about a quarter of a turn at most
    least_ = std::min(walls_ > 0 ? walls_ : ledges_, ledges_ > 0 ? ledges_ : walls_);
    mostSlack_ = least_ * distances.tolerance / 32;
  }

  std::vector<Margin> find() {
    chains_ = findBorderChains(
        surface_, walls_ == ledges_ ? wholeBorders(surface_)
                                    : dividedBorders(state_, surface_, ledges_ > walls_, context_, fallbacks_));
    for (const BorderChain& chain : chains_) {
      checkSlack(chain);
      asked_.push_back(askedOf(chain));
    }
    if (walls_ != ledges_) bent_.emplace(surface_, box_, chains_, asked_, arcs_, context_);
    reached_.resize(chains_.size());
    corners_.resize(chains_.size());
    std::vector<std::vector<Margin>> found(chains_.size());
    PerThread<Spread> spreads([&] { return Spread(surface_, context_); });
    forChains([&](Index i) {
      if (!isBent(i)) reached_[i] = reachedBy(chains_[i], spreads.local());
    });
    forChains([&](Index i) {
      if (chains_[i].behind >= 0) findCorner(i, chains_[i].behind);
    });
    forChains([&](Index i) { makeMargins(i, spreads.local(), found[i]); });
    context_.checkCancelled();
    std::vector<Margin> margins;
    for (std::vector<Margin>& some : found)
      for (Margin& margin : some) margins.push_back(std::move(margin));
    if (bent_)
      for (Margin& margin : bent_->find()) margins.push_back(std::move(margin));
    return margins;
  }

 private:
  template <class Work>
  void forChains(const Work& work) {
    parallelRanges(static_cast<Index>(chains_.size()), kChainsPerTask, [&](const auto& range) {
      for (Index i = range.begin(); i != range.end(); ++i) {
        context_.checkCancelled();
        work(i);
      }
    });
  }

  void checkSlack(const BorderChain& chain) const {
    if (chain.slack <= mostSlack_) return;
    std::string least;
    appendNumber(least, std::ldexp(least_ * chain.slack / mostSlack_, -state_.kernel->mesh().grid.scaleExponent()));
    throw InputError(FOOTFALL_TEXT("the radius is too small for the largest coordinates; give at least %1, or check "
                                   "the scale and the largest coordinates"),
                     least);
  }

  /// The distance that an agent keeps from a border; a single place has the larger distance of its neighbours.
  [[nodiscard]] double askedOf(const BorderChain& chain) const {
    double distance = chain.isLedge ? ledges_ : walls_;
    if (!chain.isShort) return distance;
    if (chain.before < 0 && chain.behind < 0) return std::max(walls_, ledges_);
    for (const Index other : {chain.before, chain.behind})
      if (other >= 0) distance = std::max(distance, chains_[other].isLedge ? ledges_ : walls_);
    return distance;
  }
  [[nodiscard]] double asked(const BorderChain& chain) const { return asked_[&chain - chains_.data()]; }
  [[nodiscard]] double distanceOf(const BorderChain& chain) const { return asked(chain) * (1 + 0x1p-46) + chain.slack; }
  [[nodiscard]] bool isBent(Index chain) const { return bent_ && bent_->has(chain); }

  /// Triangles that beams from the edge reach; ascending.
  [[nodiscard]] std::vector<Index> reachedBy(const BorderChain& chain, Spread& spread) const {
    if (chain.isShort || asked(chain) == 0) return {};
    spread.start();
    const Beams beams{chain.begin, chain.along, distanceOf(chain) + chain.slack};
    for (const Index side : chain.sides)
      spread.enter(side, beams.at(surface_.begin(side)), beams.at(surface_.end(side)));
    spread.run(beams);
    return spread.takeTriangles();
  }

  // --- Corners ---

  void findCorner(Index before, Index behind) {
    const BorderChain &first = chains_[before], &second = chains_[behind];
    Corner& corner = corners_[before];
    if (first.isShort || second.isShort || asked(first) != asked(second) || isBent(before) || isBent(behind)) return;
    fanBehind(surface_, first, corner.fan);
    const PlanVector back = -1.0 * first.along;
    double turn = 0;
    const auto ahead = [&](const PlanVector& d) {
      const double more = std::fmod(-turnFrom(back, d) - turn, 4);
      return more < 0 ? more + 4 : more;
    };
    // A triangle's angle is more than none and less than half a turn; the rest is noise. Where there are several, as
    // edges between them are too short to have a direction, none and a whole turn look alike: a whole turn is on the
    // safe side.
    std::size_t known = 0;
    for (std::size_t i = 0; i < corner.fan.size(); ++i) {
      const Index side = corner.fan[i];
      const bool isLast = i + 1 == corner.fan.size();
      const PlanVector ray = isLast ? second.along : surface_.end(side) - surface_.begin(side);
      if (!isLast && length(ray) < kShort) continue;
      double more = ahead(ray);
      if (known == i)
        more = more > 3 ? 0 : more;
      else if (more < kTouch)
        more += 4;
      for (; known <= i; ++known) corner.wedges.push_back({turn, turn + more});
      turn += more;
    }
    corner.end = turn;
    const bool isShared = second.before == before;
    corner.hasSecond = isShared;
    if (turn > 2 - kTouch)
      addArc(first, second, 1, turn - 1, corner);
    else if (isShared && asked(first) > 0)
      addMitre(before, behind, corner);
  }

  // Adds an arc between two turns.
  void addArc(const BorderChain& first, const BorderChain& second, double from, double to, Corner& corner) const {
    if (to < from - kTouch) return;
    const PlanVector back = -1.0 * first.along, apex = first.end;
    const double distance = std::max(distanceOf(first), distanceOf(second));
    double turn = from;
    const auto ahead = [&](const PlanVector& d) {
      const double more = std::fmod(-turnFrom(back, d) - turn, 4);
      return more < 0 ? more + 4 : more;
    };
    const PlanVector last = leftOf(second.along);
    PlanVector d = leftOf(first.along);
    for (bool isDone = false; !isDone;) {
      PlanVector e = arcs_.next(d);
      const double there = turn + ahead(e);
      isDone = there >= to - kTouch;
      if (isDone) e = last;
      const PlanVector middle = d + e;
      corner.tangents.push_back(roundToUnit(apex + (distance / (1 + dot(d, e))) * middle));
      corner.turns.push_back(turn + ahead(middle));
      turn = there;
      d = e;
    }
    corner.split = corner.hasSecond ? corner.tangents.size() / 2 : corner.tangents.size() - 1;
  }

  // Where the border turns towards the walkable side, everything before one edge and beyond the two edges' bisector is
  // also before the other edge, and not farther from it. Each polygon can therefore end there, if both are long enough
  // and reach the same triangles there.
  void addMitre(Index before, Index behind, Corner& corner) const {
    const BorderChain &first = chains_[before], &second = chains_[behind];
    const PlanVector d = leftOf(first.along), e = leftOf(second.along);
    if (corner.end < 0.7 || 1 + dot(d, e) < 0.5) return;
    const double distance = std::max(distanceOf(first), distanceOf(second));
    const PlanVector apex = first.end, tip = apex + (distance / (1 + dot(d, e))) * (d + e);
    const double along = std::max(dot(apex - tip, first.along), dot(tip - apex, second.along));
    if (along < 0 || along > std::min(first.size(), second.size()) / 2) return;
    if (!reachesAll(reached_[before], reached_[behind], {apex, tip, apex + distance * d}) ||
        !reachesAll(reached_[behind], reached_[before], {apex, tip, apex + distance * e}))
      return;
    corner.isMitre = true;
    corner.tangents = {roundToUnit(tip)};
    corner.turns = {0};
  }

  // Returns whether everything that reaches a triangle near these places is also among the others.
  [[nodiscard]] bool reachesAll(const std::vector<Index>& some, const std::vector<Index>& others,
                                const std::array<PlanVector, 3>& places) const {
    const double more = 2 * mostSlack_;
    const double lowX = std::min({places[0].x, places[1].x, places[2].x}) - more;
    const double highX = std::max({places[0].x, places[1].x, places[2].x}) + more;
    const double lowY = std::min({places[0].y, places[1].y, places[2].y}) - more;
    const double highY = std::max({places[0].y, places[1].y, places[2].y}) + more;
    return std::all_of(some.begin(), some.end(), [&](Index triangle) {
      const PlanVector a = surface_.begin(3 * triangle), b = surface_.begin(3 * triangle + 1),
                       c = surface_.begin(3 * triangle + 2);
      if (std::max({a.x, b.x, c.x}) < lowX || std::min({a.x, b.x, c.x}) > highX || std::max({a.y, b.y, c.y}) < lowY ||
          std::min({a.y, b.y, c.y}) > highY)
        return true;
      return std::binary_search(others.begin(), others.end(), triangle);
    });
  }

  // --- Margins ---

  /// The part of a corner's arc that a chain has.
  struct Part {
    const Corner* corner = nullptr;  ///< null: none
    std::size_t first = 0, last = 0;
    bool isBehind = true;  ///< of the chain that comes before the corner
    [[nodiscard]] std::size_t size() const { return corner == nullptr ? 1 : last - first + 1; }
    /// The angle between the arc's end and the chain's own direction.
    [[nodiscard]] double turn() const {
      if (corner == nullptr || corner->isMitre) return 0;
      return isBehind ? corner->turns[last] - 1 : corner->end - 1 - corner->turns[first];
    }
    /// The part that is only the place next to the rectangle.
    [[nodiscard]] Part alone() const {
      return isBehind ? Part{corner, first, first, true} : Part{corner, last, last, false};
    }
  };

  void makeMargins(Index number, Spread& spread, std::vector<Margin>& margins) const {
    const BorderChain& chain = chains_[number];
    if (asked(chain) == 0 || isBent(number)) return;
    if (chain.isShort) {
      addDisc(chain, spread, margins);
      return;
    }
    Part before, behind;
    before.isBehind = false;
    if (chain.before >= 0) {
      const Corner& corner = corners_[chain.before];
      if (corner.hasSecond && !corner.tangents.empty() && chains_[chain.before].behind == number)
        before = {&corner, corner.split, corner.tangents.size() - 1, false};
    }
    if (chain.behind >= 0 && !corners_[number].tangents.empty())
      behind = {&corners_[number], 0, corners_[number].split, true};
    // An arc that does not fit into a convex polygon with the rectangle has polygons of its own.
    std::vector<Part> apart;
    const auto takeApart = [&](Part& part) {
      if (part.size() < 2) return;
      apart.push_back(part);
      part = part.alone();
    };
    if (before.turn() > 1) takeApart(before);
    if (behind.turn() > 1) takeApart(behind);
    const auto fits = [&](std::size_t most) { return 2 + before.size() + behind.size() <= most; };
    if (!fits(Margin::kMostCorners)) takeApart(before.size() > behind.size() ? before : behind);
    if (!fits(Margin::kMostCorners) || (!fits(kMostClipped) && !isInBox(chain, before, behind))) {
      takeApart(before);
      takeApart(behind);
    }
    addRectangle(chain, reached_[number], before, behind, spread, margins);
    for (const Part& part : apart) addSectors(chain, part, spread, margins);
  }

  [[nodiscard]] bool isInBox(const BorderChain& chain, const Part& before, const Part& behind) const {
    const std::vector<PlanVector> corners = cornersOf(chain, before, behind);
    return std::all_of(corners.begin(), corners.end(), [&](const PlanVector& p) { return box_.holds(p); });
  }

  [[nodiscard]] std::vector<PlanVector> cornersOf(const BorderChain& chain, const Part& before,
                                                  const Part& behind) const {
    const double slack = chain.slack, distance = distanceOf(chain);
    const PlanVector out = leftOf(chain.along);
    const PlanVector from = chain.begin - slack * chain.along, to = chain.end + slack * chain.along;
    std::vector<PlanVector> corners{roundToUnit(from - slack * out), roundToUnit(to - slack * out)};
    corners.reserve(2 + before.size() + behind.size());
    const auto add = [&](const Part& part, const PlanVector& plain) {
      if (part.corner == nullptr) {
        corners.push_back(roundToUnit(plain + distance * out));
        return;
      }
      for (std::size_t i = part.last + 1; i-- > part.first;) corners.push_back(part.corner->tangents[i]);
    };
    add(behind, to);
    add(before, from);
    return corners;
  }

  void addRectangle(const BorderChain& chain, const std::vector<Index>& reached, const Part& before, const Part& behind,
                    Spread& spread, std::vector<Margin>& margins) const {
    const PlanVector out = leftOf(chain.along);
    spread.start(reached);
    if (const Corner* corner = behind.corner; corner != nullptr && !corner->isMitre)
      spreadFrom(chain.end, *corner, 1, corner->turns[behind.last], out, corner->tangents[behind.last] - chain.end,
                 chain, spread);
    if (const Corner* corner = before.corner; corner != nullptr && !corner->isMitre)
      spreadFrom(chain.begin, *corner, corner->turns[before.first], corner->end - 1,
                 corner->tangents[before.first] - chain.begin, out, chain, spread);
    addMargin({cornersOf(chain, before, behind), {}}, spread, margins);
  }

  void addSectors(const BorderChain& chain, const Part& part, Spread& spread, std::vector<Margin>& margins) const {
    const Corner& corner = *part.corner;
    const PlanVector apex = part.isBehind ? chain.end : chain.begin;
    for (std::size_t i = part.first; i < part.last; i += arcs_.perMargin) {
      const std::size_t j = std::min(i + arcs_.perMargin, part.last);
      Margin margin{{corner.tangents.begin() + static_cast<std::ptrdiff_t>(i),
                     corner.tangents.begin() + static_cast<std::ptrdiff_t>(j) + 1},
                    {}};
      spread.start();
      spreadFrom(apex, corner, corner.turns[i], corner.turns[j], margin.corners.front() - apex,
                 margin.corners.back() - apex, chain, spread);
      addSector(std::move(margin), apex, chain.slack, spread, margins);
    }
  }

  // The sector between two turns, clockwise; `first` and `last` are the directions there.
  void spreadFrom(const PlanVector& apex, const Corner& corner, double from, double to, const PlanVector& first,
                  const PlanVector& last, const BorderChain& chain, Spread& spread) const {
    const Rays rays{apex, unitOf(unitOf(first) + unitOf(last)), 1.25 * distanceOf(chain)};
    const double low = turnFrom(rays.middle, last) - kTouch, high = turnFrom(rays.middle, first) + kTouch;
    for (std::size_t i = 0; i < corner.fan.size(); ++i)
      if (corner.wedges[i][0] <= to + kTouch && corner.wedges[i][1] >= from - kTouch)
        spread.enter(corner.fan[i], low, high);
    spread.run(rays);
  }

  void addSector(Margin&& margin, const PlanVector& apex, double slack, Spread& spread,
                 std::vector<Margin>& margins) const {
    const PlanVector middle = unitOf(unitOf(margin.corners.front() - apex) + unitOf(margin.corners.back() - apex));
    margin.corners.push_back(roundToUnit(apex - slack * middle));
    std::reverse(margin.corners.begin(), margin.corners.end());
    addMargin(std::move(margin), spread, margins);
  }

  // A border that is hardly more than a point.
  void addDisc(const BorderChain& chain, Spread& spread, std::vector<Margin>& margins) const {
    const double distance = distanceOf(chain) + kShort;
    std::vector<PlanVector> tangents;
    PlanVector d{1, 0};
    bool hasTurned = false;
    for (bool isDone = false; !isDone;) {
      const PlanVector e = arcs_.next(d);
      hasTurned = hasTurned || e.x < 0;
      isDone = hasTurned && e.x > 0 && e.y <= 0;
      tangents.push_back(roundToUnit(chain.begin + (distance / (1 + dot(d, e))) * (d + e)));
      d = e;
    }
    tangents.push_back(tangents.front());
    spread.start();
    std::vector<Index> around = chain.sides, fan;
    for (const Index i : {chain.before, static_cast<Index>(&chain - chains_.data())}) {
      if (i < 0) continue;
      fanBehind(surface_, chains_[i], fan);
      around.insert(around.end(), fan.begin(), fan.end());
    }
    for (const PlanVector& middle : {PlanVector{1, 0}, PlanVector{0, 1}, PlanVector{-1, 0}, PlanVector{0, -1}}) {
      for (const Index side : around) spread.enter(side, -1, 1);
      spread.run(Rays{chain.begin, middle, 1.25 * distance});
    }
    for (std::size_t i = 0; i + 1 < tangents.size(); i += arcs_.perMargin) {
      const std::size_t j = std::min(i + arcs_.perMargin, tangents.size() - 1);
      Margin margin{
          {tangents.begin() + static_cast<std::ptrdiff_t>(i), tangents.begin() + static_cast<std::ptrdiff_t>(j) + 1},
          {}};
      addSector(std::move(margin), chain.begin, chain.slack, spread, margins);
    }
  }

  void addMargin(Margin&& margin, Spread& spread, std::vector<Margin>& margins) const {
    margin.corners = hullOf(std::move(margin.corners));
    if (box_.clip(margin.corners)) margin.corners = hullOf(std::move(margin.corners));
    if (margin.corners.size() < 3) return;
    for (const Index triangle : spread.takeTriangles()) margin.faces.push_back(surface_.face(3 * triangle));
    std::sort(margin.faces.begin(), margin.faces.end());
    margins.push_back(std::move(margin));
  }

  static constexpr std::size_t kMostClipped = Margin::kMostCorners - 4;  // each side of the box can add one

  const WalkableState& state_;
  RunContext& context_;
  ExactFallbacks& fallbacks_;
  double walls_ = 0, ledges_ = 0, least_ = 0;  ///< distances; the smaller one above 0
  MarginSurface surface_;
  ClipBox box_;
  ArcSteps arcs_;
  double mostSlack_ = 0;
  std::vector<BorderChain> chains_;
  std::vector<std::vector<Index>> reached_;  ///< of each chain the triangles that beams reach
  std::vector<Corner> corners_;              ///< behind each chain
  std::vector<double> asked_;                ///< of each chain
  std::optional<BentMargins> bent_;          ///< where the distances differ
};

}  // namespace

std::vector<Margin> findMargins(const WalkableState& state, const MarginDistances& distances, RunContext& context,
                                ExactFallbacks& fallbacks) {
  return MarginFinder(state, distances, context, fallbacks).find();
}

}  // namespace footfall::detail
