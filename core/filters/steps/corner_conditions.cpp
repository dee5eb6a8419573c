// Gaps at corners of borders: free ways around the nearest places of two borders.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/filters/steps/gap_conditions.hpp"

namespace footfall::detail {
namespace {

constexpr double kSlack = GapConditions::kSlack;
/// Places may be off by kSlack / 2 along a frame, which is eight times as much along a border, and ways are longer by
/// the same amount.
constexpr double kSpare = 16 * kSlack;
/// The square of the cosine of half of 60 degrees. Borders at a larger angle meet in a corner, or diverge from one.
constexpr double kOblique = 0.75;
/// The angle by which a direction is turned is halved this many times at most; the smallest angle is the last one.
constexpr int kTurns = 20;
constexpr double kMostTurn = 8;  // tangent of the angle
/// The greatest distance of a corner from the end of a piece, along the frame: as a part of the piece's length, and as
/// a part of the gap.
constexpr double kMostOfLength = 0.25, kMostOfGap = 0.5;

struct PlanDirection {
  double x = 0, y = 0;
};
double dot(const PlanDirection& a, const PlanDirection& b) { return a.x * b.x + a.y * b.y; }
PlanDirection between(const Vec3& a, const Vec3& b) { return {b.x - a.x, b.y - a.y}; }
double lengthOf(const PlanDirection& d) { return std::sqrt(dot(d, d)); }
PlanDirection unit(const PlanDirection& d) {
  const double length = lengthOf(d);
  return {d.x / length, d.y / length};
}

/// A frame whose ways run in a direction to the right of the first border.
GapFrame frameAcross(const Vec3& origin, const PlanDirection& way) { return {origin.x, origin.y, -way.y, way.x}; }

/// The place of a border that is nearest to another place: its begin (0), its end (1), or between them.
struct Foot {
  Vec3 place;
  int end = -1;
};
Foot footOn(const GapBorder& border, const Vec3& place) {
  const PlanDirection d = between(border.from, border.to);
  const double t = dot(between(border.from, place), d) / dot(d, d);
  if (t <= 0) return {border.from, 0};
  if (t >= 1) return {border.to, 1};
  return {{border.from.x + t * d.x, border.from.y + t * d.y, 0}, -1};
}

/// The places where two borders are nearest to each other, and whether each is the begin of its border (0), its end
/// (1), or between them (-1).
struct NearestPlaces {
  std::array<Vec3, 2> places;
  std::array<int, 2> ends{-1, -1};
  double distance = 0;
};
NearestPlaces nearestPlaces(const GapBorder& first, const GapBorder& second) {
  std::optional<NearestPlaces> best;
  const auto take = [&](const Foot& p, const Foot& q) {
    const double distance = lengthOf(between(p.place, q.place));
    if (!best || distance < best->distance) best = {{p.place, q.place}, {p.end, q.end}, distance};
  };
  take({first.from, 0}, footOn(second, first.from));
  take({first.to, 1}, footOn(second, first.to));
  take(footOn(first, second.from), {second.from, 0});
  take(footOn(first, second.to), {second.to, 1});
  return *best;
}

/// The largest angle by which the direction between two ends of borders can be turned, so that ways lie between both
/// borders.
struct TurnLimits {
  /// Sine and cosine of the angle between the direction and the border, from that end on.
  struct Border {
    double sine = 0, cosine = 0, length = 0;
  };
  double distance = 0, most = 0;  ///< distance of the ends, and longest way
  std::array<Border, 2> borders;

  /// By the law of sines: when the direction is turned by an angle with this tangent, ways begin at most `distance`
  /// times the tangent by the divisor from the end, and become longer.
  [[nodiscard]] bool allow(double tangent) const {
    const double secant = std::sqrt(1 + tangent * tangent);
    return std::all_of(borders.begin(), borders.end(), [&](const Border& border) {
      const double divisor = border.sine - tangent * border.cosine;
      return divisor >= GapConditions::kLeastSine * secant && distance * border.sine * secant <= most * divisor &&
             distance * tangent <= border.length * divisor;
    });
  }
  [[nodiscard]] double findLargest() const {
    double low = 0, high = kMostTurn;
    for (int i = 0; i < 2 * kTurns; ++i) {
      const double middle = (low + high) / 2;
      (allow(middle) ? low : high) = middle;
    }
    return low;
  }
};

}  // namespace

std::optional<GapFrame> GapConditions::frameOf(const GapBorder& first, const GapBorder& second,
                                               const std::array<GapBorder, 2>& pieces) {
  const std::optional<GapFrame> straight = frameOf(first, second);
  const PlanDirection begin = between(pieces[0].from, pieces[1].to), end = between(pieces[0].to, pieces[1].from);
  const PlanDirection both{begin.x + end.x, begin.y + end.y};
  // Vertices of a link may be off by kSlack at either end.
  if (!straight || std::fabs(both.x * straight->alongX + both.y * straight->alongY) <= 2 * kSlack) return straight;
  const GapFrame turned = frameAcross(first.from, unit(both));
  const PlanDirection axis{turned.alongX, turned.alongY};
  const bool isSteep = std::ranges::all_of(
      std::array{between(first.from, first.to), between(second.to, second.from)},
      [&](const PlanDirection& border) { return dot(border, axis) >= kLeastSine / 2 * lengthOf(border); });
  return isSteep && std::fabs(dot(begin, axis)) <= kMostOff ? turned : straight;
}

std::optional<GapPiece> GapConditions::findWhole(const GapBorder& first, const GapBorder& second,
                                                 const GapFrame& frame) {
  const std::array<double, 4> along{frame.along(first.from.x, first.from.y), frame.along(first.to.x, first.to.y),
                                    frame.along(second.to.x, second.to.y), frame.along(second.from.x, second.from.y)};
  const std::optional<GapPiece> near = findNear(first, second, frame, kSpare / 2);
  if (!near || near->ends[0] > std::max(along[0], along[2]) + kSlack ||
      near->ends[1] < std::min(along[1], along[3]) - kSlack)
    return std::nullopt;
  std::vector<GapPiece> free = findFree(first, second, *near);
  if (free.size() != 1 || free[0].ends != near->ends) return std::nullopt;
  if (!free[0].touching[0].empty() || !free[0].touching[1].empty()) return std::nullopt;
  return std::move(free[0]);
}

void GapConditions::leadToCorners(const GapBorder& first, const GapBorder& second, GapPiece& piece) {
  const std::array<Vec3, 2> own{first.from, first.to}, other{second.to, second.from};
  const double farthest = std::min(kMostOfLength * (piece.ends[1] - piece.ends[0]), kMostOfGap * gap_);
  std::array<std::array<double, 2>, 2> corners{};
  std::array<bool, 2> isNear{};
  for (const std::size_t end : {0, 1}) {
    double distance = 0;
    for (const std::size_t border : {0, 1}) {
      const Vec3& corner = border == 0 ? own[end] : other[end];
      corners[border][end] = piece.frame.along(corner.x, corner.y);
      distance = std::max(distance, std::fabs(corners[border][end] - piece.ends[end]));
    }
    isNear[end] = distance > kAcross && distance <= farthest;
  }
  for (const auto& [low, high] : {std::pair(true, true), std::pair(true, false), std::pair(false, true)}) {
    if ((low && !isNear[0]) || (high && !isNear[1])) continue;
    std::array<std::array<double, 2>, 2> places{piece.ends, piece.ends};
    for (const std::size_t border : {0, 1}) {
      if (low) places[border][0] = corners[border][0];
      if (high) places[border][1] = corners[border][1];
    }
    if (std::optional<GapPiece> found = findBetween(first, second, piece, places)) {
      piece = std::move(*found);
      return;
    }
  }
}

std::vector<GapPiece> GapConditions::find(const GapBorder& first, const GapBorder& second) {
  std::vector<GapPiece> pieces;
  if (const std::optional<GapPiece> near = findNear(first, second)) pieces = findFree(first, second, *near);
  if (pieces.empty()) return findAtCorner(first, second);
  const PlanDirection e = between(first.from, first.to);
  const GapFrame& frame = pieces[0].frame;
  const double along = e.x * frame.alongX + e.y * frame.alongY;
  if (along * along >= kOblique * dot(e, e)) {
    for (GapPiece& piece : pieces) leadToCorners(first, second, piece);
    return pieces;
  }
  for (GapPiece& piece : pieces) {
    const double t = piece.ends[0] / along;
    piece.corner = Vec3{first.from.x + t * e.x, first.from.y + t * e.y, 0};
  }
  return pieces;
}

std::vector<GapPiece> GapConditions::findAtCorner(const GapBorder& first, const GapBorder& second) {
  const NearestPlaces nearest = nearestPlaces(first, second);
  const double distance = nearest.distance, most = gap_ - kSpare;
  const PlanDirection e = between(first.from, first.to), f = between(second.to, second.from);
  const double lengthE = lengthOf(e), lengthF = lengthOf(f);
  if (!(distance > kShort) || !(distance < most) || !(lengthE > kShort) || !(lengthF > kShort)) return {};
  const PlanDirection way = unit(between(nearest.places[0], nearest.places[1]));
  const GapFrame straight = frameAcross(first.from, way);
  const PlanDirection axis{straight.alongX, straight.alongY};
  const double sineE = dot(e, axis) / lengthE, sineF = dot(f, axis) / lengthF;
  if (!(sineE >= kLeastSine) || !(sineF >= kLeastSine) || !(dot(e, f) >= kLeastSine * lengthE * lengthF)) return {};
  std::vector<GapPiece> pieces;
  const auto mark = [&](GapPiece& piece) {
    piece.isAsWide = true;  // a proof that no way is too long is still needed
    piece.corner = nearest.places[0];
  };

  // Where one border goes on at the end of the other, ways in this direction meet each in one point at most.
  const bool isTurned = nearest.ends[0] >= 0 && nearest.ends[1] >= 0 && nearest.ends[0] == nearest.ends[1];
  if (!isTurned) {
    if (const auto near = findNear(first, second, straight, kSpare)) pieces = findFree(first, second, *near);
    for (GapPiece& piece : pieces) mark(piece);
    return pieces;
  }
  const double sign = nearest.ends[0] == 1 ? 1 : -1;
  const TurnLimits limits{
      distance,
      most,
      {{{sineE, sign * dot(e, way) / lengthE, lengthE}, {sineF, sign * dot(f, way) / lengthF, lengthF}}}};
  const double largest = limits.findLargest();
  const auto turned = [&](double tangent) {
    return findWhole(first, second,
                     frameAcross(first.from, unit({way.x + sign * tangent * axis.x, way.y + sign * tangent * axis.y})));
  };
  // A direction that is blocked at the smallest angle is blocked at all angles.
  const double smallest = std::max(std::ldexp(largest, -kTurns), 2 * kShort / distance);
  if (!(largest > smallest) || !turned(smallest)) return {};
  std::optional<GapPiece> piece;
  for (double tangent = largest; !piece; tangent = std::max(tangent / 2, smallest)) {
    piece = turned(tangent);
    if (tangent == smallest) break;
  }
  if (piece) {
    mark(*piece);
    pieces.push_back(std::move(*piece));
  }
  return pieces;
}

}  // namespace footfall::detail
