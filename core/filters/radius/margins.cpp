// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/margins.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>

#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr double kUnit = MarginSurface::kUnit;
constexpr double kStraight = 8 * kUnit;  // borders that turn less go on
constexpr double kShort = 256 * kUnit;   // shorter ones have no direction: each is a mere place
constexpr double kSlack = 32 * kUnit;
constexpr double kTouch = 0x1p-30;  // of turns: what touches is reached
constexpr std::size_t kLongestChain = 64;
constexpr std::size_t kArcsPerMargin = 5;
constexpr Index kChainsPerTask = 16;

double roundToUnit(double x) { return std::nearbyint(x / kUnit) * kUnit; }
PlanVector roundToUnit(const PlanVector& p) { return {roundToUnit(p.x), roundToUnit(p.y)}; }
PlanVector leftOf(const PlanVector& d) { return {-d.y, d.x}; }
PlanVector unitOf(const PlanVector& d) { return (1 / length(d)) * d; }

/// Border sides, one behind the other, that are one straight edge to within a few units.
struct Chain {
  std::vector<Index> sides;
  PlanVector begin, end;
  PlanVector along;      ///< a unit vector
  double slack = 0;      ///< "m"
  bool isShort = false;  ///< a mere place
  Index before = -1, behind = -1;
};

/// Where one chain ends and the next one begins.
struct Corner {
  bool isReflex = false;
  std::vector<PlanVector> tangents;           ///< where neighbouring tangents of the arc meet; clockwise
  std::vector<double> turns;                  ///< of these, clockwise from the first chain's direction backwards
  std::vector<Index> fan;                     ///< MarginSurface::fanBehind()
  double end = 0;                             ///< turn of the second chain
  std::vector<std::array<double, 2>> wedges;  ///< for each side of the fan the turns between which its triangle lies
};

/// Beams from an edge, at a right angle to it.
struct Beams {
  PlanVector origin, along;
  double reach = 0;
  double touch = kSlack;
  [[nodiscard]] double at(const PlanVector& p) const { return dot(p - origin, along); }
  [[nodiscard]] bool exits(const PlanVector& a, const PlanVector& b) const { return at(b) < at(a) + touch; }
  [[nodiscard]] std::array<double, 2> range(const PlanVector& a, const PlanVector& b, double /*lowest*/) const {
    return {std::min(at(a), at(b)), std::max(at(a), at(b))};
  }
  // Of the part of a side between two beams.
  [[nodiscard]] bool isNear(const PlanVector& a, const PlanVector& b, double low, double high) const {
    const PlanVector out = leftOf(along);
    const double atA = at(a), atB = at(b), outA = dot(a - origin, out), outB = dot(b - origin, out);
    double first = outA, last = outB;
    if (std::fabs(atB - atA) > touch) {
      const auto outAt = [&](double where) {
        return outA + std::clamp((where - atA) / (atB - atA), 0.0, 1.0) * (outB - outA);
      };
      first = outAt(low - touch);
      last = outAt(high + touch);
    }
    return std::min(first, last) < reach && std::max(first, last) > -touch;
  }
};

double distanceToSegment(const PlanVector& p, const PlanVector& a, const PlanVector& b) {
  const PlanVector d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return length(p - (a + t * d));
}

/// Beams from a place.
struct Rays {
  PlanVector apex, middle;
  double reach = 0;
  double touch = kTouch;
  [[nodiscard]] double at(const PlanVector& p) const { return turnFrom(middle, p - apex); }
  // A side through the apex itself is left to whoever starts. One so near that doubles do not tell on which side the
  // apex is, and whose range may be any, is not.
  [[nodiscard]] bool exits(const PlanVector& a, const PlanVector& b) const {
    const PlanVector p = a - apex, q = b - apex;
    if ((p.x == 0 && p.y == 0) || (q.x == 0 && q.y == 0)) return false;
    return cross(p, q) > -kShort * length(q - p);
  }
  // Where a side goes behind the apex, of the two ranges the one that ends behind `lowest`.
  [[nodiscard]] std::array<double, 2> range(const PlanVector& a, const PlanVector& b, double lowest) const {
    if (distanceToSegment(apex, a, b) < kShort) return {-2, 2};
    const double first = at(a), last = at(b);
    if (first <= last) return {first, last};
    return last >= lowest ? std::array{first - 4, last} : std::array{first, last + 4};
  }
  [[nodiscard]] bool isNear(const PlanVector& a, const PlanVector& b, double /*low*/, double /*high*/) const {
    return distanceToSegment(apex, a, b) < reach;
  }
};

/// Lists the faces of all triangles that beams reach. What may be reached is taken as reached.
class Spread {
 public:
  explicit Spread(const MarginSurface& surface) : surface_(surface) {}

  void start() { faces_.clear(); }
  void enter(Index side, double low, double high) { stack_.push_back({side, low, high}); }
  template <class View>
  void run(const View& view) {
    seen_.clear();
    while (!stack_.empty()) {
      const Entry entry = stack_.back();
      stack_.pop_back();
      visit(entry, view);
    }
  }
  std::vector<Index> takeFaces() {
    std::sort(faces_.begin(), faces_.end());
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    return faces_;
  }

 private:
  struct Entry {
    Index side = -1;
    double low = 0, high = 0;
  };

  template <class View>
  void visit(const Entry& entry, const View& view) {
    faces_.push_back(surface_.face(entry.side));
    for (Index side : {MarginSurface::nextSide(entry.side), MarginSurface::previousSide(entry.side), entry.side}) {
      if (surface_.isBorder(side)) continue;
      const PlanVector a = surface_.begin(side), b = surface_.end(side);
      if (!view.isNear(a, b, entry.low, entry.high)) continue;
      const auto [first, last] = view.range(a, b, entry.low - view.touch);
      const double low = std::max(first, entry.low), high = std::min(last, entry.high);
      if (low > high + view.touch) continue;
      if (side == entry.side || !view.exits(a, b)) {
        // Both borders of a link are divided at the same places.
        for (const Index other : surface_.beyond(side))
          if (surface_.beginVertex(other) != surface_.endVertex(side)) faces_.push_back(surface_.face(other));
        continue;
      }
      for (const Index other : surface_.beyond(side)) {
        const auto [known, isNew] = seen_.try_emplace(other, std::array{low, high});
        auto& [seenLow, seenHigh] = known->second;
        if (!isNew && seenLow <= low && high <= seenHigh) continue;
        seenLow = std::min(seenLow, low);
        seenHigh = std::max(seenHigh, high);
        stack_.push_back({other, low, high});
      }
    }
  }

  const MarginSurface& surface_;
  std::vector<Entry> stack_;
  std::unordered_map<Index, std::array<double, 2>> seen_;  ///< of entered sides
  std::vector<Index> faces_;
};

/// The part of a convex polygon in a rectangle. What is cut off has corners in units again.
class PlanBox {
 public:
  PlanBox(const MarginSurface& surface) {
    for (Index side = 0; side < surface.sideCount(); ++side) {
      const PlanVector p = surface.begin(side);
      lower_ = {std::min(lower_[0], p.x), std::min(lower_[1], p.y)};
      upper_ = {std::max(upper_[0], p.x), std::max(upper_[1], p.y)};
    }
    constexpr double kEnd = 0x1p36 - kUnit;  // Grid::scaleExponent(): all coordinates are below 2^36
    for (int k = 0; k < 2; ++k) {
      lower_[k] = std::max(roundToUnit(lower_[k]) - kSlack, -kEnd);
      upper_[k] = std::min(roundToUnit(upper_[k]) + kSlack, kEnd);
    }
  }

  [[nodiscard]] double diagonal() const { return length({upper_[0] - lower_[0], upper_[1] - lower_[1]}); }

  void clip(std::vector<PlanVector>& corners) const {
    for (int axis = 0; axis < 2; ++axis) {
      keep(corners, axis, 1, lower_[axis]);
      keep(corners, axis, -1, upper_[axis]);
    }
  }

 private:
  static void keep(std::vector<PlanVector>& corners, int axis, double sign, double border) {
    const auto inside = [&](const PlanVector& p) { return sign * ((axis == 0 ? p.x : p.y) - border); };
    if (std::none_of(corners.begin(), corners.end(), [&](const PlanVector& p) { return inside(p) < 0; })) return;
    std::vector<PlanVector> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const PlanVector &p = corners[i], &q = corners[(i + 1) % corners.size()];
      const double a = inside(p), b = inside(q);
      if (a >= 0) kept.push_back(p);
      if (a * b >= 0) continue;
      PlanVector cut = roundToUnit(p + (a / (a - b)) * (q - p));
      (axis == 0 ? cut.x : cut.y) = border;
      kept.push_back(cut);
    }
    corners = std::move(kept);
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> lower_{kInfinity, kInfinity}, upper_{-kInfinity, -kInfinity};
};

/// The convex hull of places in units, counter-clockwise, exactly: rounding can turn a corner the wrong way.
std::vector<PlanVector> hullOf(std::vector<PlanVector> places) {
  const auto key = [](const PlanVector& p) { return std::array{p.x, p.y}; };
  std::sort(places.begin(), places.end(), [&](const PlanVector& a, const PlanVector& b) { return key(a) < key(b); });
  places.erase(std::unique(places.begin(), places.end(),
                           [&](const PlanVector& a, const PlanVector& b) { return key(a) == key(b); }),
               places.end());
  // Fewer than 54 bits and a sign each.
  const auto inUnits = [](double x) { return static_cast<__int128>(static_cast<std::int64_t>(x / kUnit)); };
  const auto isLeft = [&](const PlanVector& a, const PlanVector& b, const PlanVector& c) {
    return (inUnits(b.x) - inUnits(a.x)) * (inUnits(c.y) - inUnits(a.y)) >
           (inUnits(b.y) - inUnits(a.y)) * (inUnits(c.x) - inUnits(a.x));
  };
  std::vector<PlanVector> hull;
  const auto add = [&](const PlanVector& p, std::size_t from) {
    while (hull.size() >= from + 2 && !isLeft(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
    hull.push_back(p);
  };
  for (const PlanVector& p : places) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = places.rbegin() + 1; p < places.rend(); ++p) add(*p, lower);
  hull.pop_back();
  return hull;
}

class MarginFinder {
 public:
  MarginFinder(const WalkableState& state, double radius, double tolerance, RunContext& context)
      : state_(state), context_(context), surface_(state, context), box_(surface_) {
    // A straight walk comes to a border within the diagonal: a larger radius leaves nothing, as this one does.
    radius_ = std::min(radius, 2 * box_.diagonal());
    const double half = 1 / (1 + 0.9 * tolerance);  // cosine of half the angle of an arc
    cosine_ = 2 * half * half - 1;
    sine_ = 2 * half * std::sqrt(1 - half * half);
    mostSlack_ = radius_ * tolerance / 32;
  }

  std::vector<Margin> find() {
    makeChains();
    std::vector<std::vector<Margin>> found(chains_.size());
    tbb::enumerable_thread_specific<Spread> spreads(surface_);
    tbb::parallel_for(tbb::blocked_range<Index>(0, static_cast<Index>(chains_.size()), kChainsPerTask),
                      [&](const auto& range) {
                        Spread& spread = spreads.local();
                        for (Index i = range.begin(); i != range.end(); ++i) {
                          context_.checkCancelled();
                          makeMargins(chains_[i], spread, found[i]);
                        }
                      });
    std::vector<Margin> margins;
    for (std::vector<Margin>& some : found)
      for (Margin& margin : some) margins.push_back(std::move(margin));
    return margins;
  }

 private:
  // --- Chains ---

  void makeChains() {
    std::vector<Index> borders, numberOf(static_cast<std::size_t>(surface_.sideCount()), -1);
    for (Index side = 0; side < surface_.sideCount(); ++side) {
      if (!surface_.isBorder(side)) continue;
      numberOf[side] = static_cast<Index>(borders.size());
      borders.push_back(side);
    }
    std::vector<Index> behind(borders.size()), before(borders.size(), -1);
    std::vector<char> isStraight(borders.size(), 0);
    std::vector<Index> fan;
    for (std::size_t b = 0; b < borders.size(); ++b) {
      surface_.fanBehind(borders[b], fan);
      behind[b] = numberOf[fan.back()];
      if (behind[b] < 0) continue;
      before[behind[b]] = static_cast<Index>(b);
      const Index vertex = surface_.endVertex(borders[b]);
      const bool isOnePlace =
          std::all_of(fan.begin(), fan.end(), [&](Index side) { return surface_.beginVertex(side) == vertex; });
      isStraight[b] =
          static_cast<char>(isOnePlace && isStraightOver({surface_.begin(borders[b]), surface_.begin(fan.back()),
                                                          surface_.end(fan.back())}));
    }
    std::vector<Index> chainOf(borders.size(), -1);
    const auto addChain = [&](Index first) {
      while (first >= 0 && chainOf[first] < 0) {
        Chain chain;
        std::vector<PlanVector> places{surface_.begin(borders[first])};
        Index last = -1;
        for (Index b = first; b >= 0 && chainOf[b] < 0; b = behind[b]) {
          places.push_back(surface_.end(borders[b]));
          if (last >= 0 && (isStraight[last] == 0 || places.size() > kLongestChain || !isStraightOver(places))) break;
          chainOf[b] = static_cast<Index>(chains_.size());
          chain.sides.push_back(borders[b]);
          last = b;
        }
        finishChain(chain);
        chains_.push_back(std::move(chain));
        first = isStraight[last] != 0 ? behind[last] : -1;
      }
    };
    for (std::size_t b = 0; b < borders.size(); ++b)
      if (before[b] < 0 || isStraight[before[b]] == 0) addChain(static_cast<Index>(b));
    for (std::size_t b = 0; b < borders.size(); ++b) addChain(static_cast<Index>(b));  // loops as small as doubles
    for (Chain& chain : chains_) {
      const Index after = behind[numberOf[chain.sides.back()]], ahead = before[numberOf[chain.sides.front()]];
      chain.behind = after < 0 ? -1 : chainOf[after];
      chain.before = ahead < 0 ? -1 : chainOf[ahead];
    }
  }

  static bool isStraightOver(const std::vector<PlanVector>& places) {
    const PlanVector chord = places.back() - places.front();
    const double size = length(chord);
    if (size < kShort) return false;
    double furthest = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const PlanVector& p = places[i];
      if (length(p - places[i - 1]) < kShort) return false;
      const double at = dot(p - places.front(), chord) / size;
      if (std::fabs(cross(chord, p - places.front())) > kStraight * size || at < furthest - kStraight) return false;
      furthest = std::max(furthest, at);
    }
    return true;
  }

  void finishChain(Chain& chain) const {
    chain.begin = surface_.begin(chain.sides.front());
    chain.end = surface_.end(chain.sides.back());
    const PlanVector whole = chain.end - chain.begin;
    const double size = length(whole);
    chain.isShort = size < kShort;
    chain.along = chain.isShort ? PlanVector{1, 0} : (1 / size) * whole;
    chain.slack = kSlack;
    for (const Index side : chain.sides)
      chain.slack = std::max({chain.slack, kSlack + 2 * surface_.error(surface_.beginVertex(side)),
                              kSlack + 2 * surface_.error(surface_.endVertex(side))});
    if (chain.slack <= mostSlack_) return;
    std::string least;
    appendNumber(least, std::ldexp(radius_ * chain.slack / mostSlack_, -state_.kernel->mesh().grid.scaleExponent()));
    throw InputError(FOOTFALL_TEXT("a radius so small is lost beside the largest coordinates; give at least %1, or "
                                   "check the scale and the largest coordinates"),
                     least);
  }

  [[nodiscard]] double distanceOf(const Chain& chain) const { return radius_ * (1 + 0x1p-46) + chain.slack; }

  // --- Corners ---

  [[nodiscard]] Corner cornerBetween(const Chain& first, const Chain& second) const {
    Corner corner;
    if (first.isShort || second.isShort) return corner;
    surface_.fanBehind(first.sides.back(), corner.fan);
    const PlanVector back = -1.0 * first.along, apex = first.end;
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
    const double end = turn - 1;
    corner.isReflex = end > 1 - kTouch;
    if (!corner.isReflex) return corner;
    const double distance = std::max(distanceOf(first), distanceOf(second));
    const PlanVector last = leftOf(second.along);
    PlanVector d = leftOf(first.along);
    turn = 1;
    for (bool isDone = false; !isDone;) {
      PlanVector e = unitOf({cosine_ * d.x + sine_ * d.y, cosine_ * d.y - sine_ * d.x});
      const double there = turn + ahead(e);
      isDone = there >= end - kTouch;
      if (isDone) e = last;
      const PlanVector middle = d + e;
      corner.tangents.push_back(roundToUnit(apex + (distance / (1 + dot(d, e))) * middle));
      corner.turns.push_back(turn + ahead(middle));
      turn = there;
      d = e;
    }
    return corner;
  }

  // --- Margins ---

  void makeMargins(const Chain& chain, Spread& spread, std::vector<Margin>& margins) const {
    if (chain.isShort) {
      addDisc(chain, spread, margins);
      return;
    }
    const Corner before = chain.before < 0 ? Corner{} : cornerBetween(chains_[chain.before], chain);
    const Corner behind = chain.behind < 0 ? Corner{} : cornerBetween(chain, chains_[chain.behind]);
    addRectangle(chain, before, behind, spread, margins);
    for (std::size_t i = 0; i + 1 < behind.tangents.size(); i += kArcsPerMargin) {
      const std::size_t j = std::min(i + kArcsPerMargin, behind.tangents.size() - 1);
      Margin margin{{behind.tangents.begin() + static_cast<std::ptrdiff_t>(i),
                     behind.tangents.begin() + static_cast<std::ptrdiff_t>(j) + 1},
                    {}};
      spread.start();
      spreadFrom(chain.end, behind, behind.turns[i], behind.turns[j], margin.corners.front() - chain.end,
                 margin.corners.back() - chain.end, spread);
      addSector(std::move(margin), chain.end, chain.slack, spread, margins);
    }
  }

  void addRectangle(const Chain& chain, const Corner& before, const Corner& behind, Spread& spread,
                    std::vector<Margin>& margins) const {
    const double slack = chain.slack, distance = distanceOf(chain);
    const PlanVector out = leftOf(chain.along);
    const PlanVector from = chain.begin - slack * chain.along, to = chain.end + slack * chain.along;
    Margin margin{{roundToUnit(from - slack * out), roundToUnit(to - slack * out)}, {}};
    margin.corners.push_back(behind.isReflex ? behind.tangents.front() : roundToUnit(to + distance * out));
    margin.corners.push_back(before.isReflex ? before.tangents.back() : roundToUnit(from + distance * out));
    spread.start();
    const Beams beams{chain.begin, chain.along, distance + slack};
    for (const Index side : chain.sides)
      spread.enter(side, beams.at(surface_.begin(side)), beams.at(surface_.end(side)));
    spread.run(beams);
    if (behind.isReflex) {
      spreadFrom(chain.end, behind, 1, behind.turns.front(), out, behind.tangents.front() - chain.end, spread);
    }
    if (before.isReflex)
      spreadFrom(chain.begin, before, before.turns.back(), before.end - 1, before.tangents.back() - chain.begin, out,
                 spread);
    addMargin(std::move(margin), spread, margins);
  }

  // The sector between two turns, clockwise; `first` and `last` are the directions there.
  void spreadFrom(const PlanVector& apex, const Corner& corner, double from, double to, const PlanVector& first,
                  const PlanVector& last, Spread& spread) const {
    const Rays rays{apex, unitOf(unitOf(first) + unitOf(last)), radius_ * 1.25};
    const double low = turnFrom(rays.middle, last) - kTouch, high = turnFrom(rays.middle, first) + kTouch;
    for (std::size_t i = 0; i < corner.fan.size(); ++i)
      if (corner.wedges[i][0] <= to + kTouch && corner.wedges[i][1] >= from - kTouch)
        spread.enter(corner.fan[i], low, high);
    spread.run(rays);
  }

  void addSector(Margin&& margin, const PlanVector& apex, double slack, Spread& spread,
                 std::vector<Margin>& margins) const {
    const PlanVector middle = unitOf(unitOf(margin.corners.front() - apex) + unitOf(margin.corners.back() - apex));
    std::reverse(margin.corners.begin(), margin.corners.end());
    margin.corners.push_back(roundToUnit(apex - slack * middle));
    addMargin(std::move(margin), spread, margins);
  }

  // A border that is hardly more than a point.
  void addDisc(const Chain& chain, Spread& spread, std::vector<Margin>& margins) const {
    const double distance = distanceOf(chain) + kShort;
    std::vector<PlanVector> tangents;
    PlanVector d{1, 0};
    bool hasTurned = false;
    for (bool isDone = false; !isDone;) {
      const PlanVector e = unitOf({cosine_ * d.x + sine_ * d.y, cosine_ * d.y - sine_ * d.x});
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
      surface_.fanBehind(chains_[i].sides.back(), fan);
      around.insert(around.end(), fan.begin(), fan.end());
    }
    for (const PlanVector& middle : {PlanVector{1, 0}, PlanVector{0, 1}, PlanVector{-1, 0}, PlanVector{0, -1}}) {
      for (const Index side : around) spread.enter(side, -1, 1);
      spread.run(Rays{chain.begin, middle, 1.25 * radius_});
    }
    for (std::size_t i = 0; i + 1 < tangents.size(); i += kArcsPerMargin) {
      const std::size_t j = std::min(i + kArcsPerMargin, tangents.size() - 1);
      Margin margin{
          {tangents.begin() + static_cast<std::ptrdiff_t>(i), tangents.begin() + static_cast<std::ptrdiff_t>(j) + 1},
          {}};
      addSector(std::move(margin), chain.begin, chain.slack, spread, margins);
    }
  }

  void addMargin(Margin&& margin, Spread& spread, std::vector<Margin>& margins) const {
    box_.clip(margin.corners);
    if (margin.corners.empty()) return;
    margin.corners = hullOf(std::move(margin.corners));
    if (margin.corners.size() < 3) return;
    margin.faces = spread.takeFaces();
    margins.push_back(std::move(margin));
  }

  const WalkableState& state_;
  RunContext& context_;
  double radius_ = 0;
  MarginSurface surface_;
  PlanBox box_;
  double cosine_ = 0, sine_ = 0;
  double mostSlack_ = 0;
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<Margin> findMargins(const WalkableState& state, double radius, double tolerance, RunContext& context) {
  return MarginFinder(state, radius, tolerance, context).find();
}

}  // namespace footfall::detail
