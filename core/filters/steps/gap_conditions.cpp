// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/sorted_list.hpp"
#include "core/exact/sign_of_difference.hpp"
#include "core/filters/steps/gap_strip.hpp"

namespace footfall::detail {
namespace {

constexpr double kSlack = GapConditions::kSlack;
constexpr double kTouch = 8 * GapConditions::kUnit;
constexpr double kWide = 16 * kTouch;
constexpr double kSpareWidth = 16 * kSlack;  // more than rounding can make a way wider
/// The least sine of the angle between a way from corner to corner and a border: a degree. Both corners are vertices,
/// so that no place on a border depends on the angle.
constexpr double kLeastTurnedSine = 1.0 / 64;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The height and distance of a border as functions of the place along a frame.
struct Profile {
  double begin = 0, end = 0;  ///< along the frame, ascending
  std::array<double, 2> across{}, height{};

  Profile(const GapFrame& frame, const Vec3& low, const Vec3& high)
      : begin(frame.along(low.x, low.y)),
        end(frame.along(high.x, high.y)),
        across{frame.across(low.x, low.y), frame.across(high.x, high.y)},
        height{low.z, high.z} {}

  [[nodiscard]] double at(const std::array<double, 2>& values, double along) const {
    const double t = std::clamp((along - begin) / (end - begin), 0.0, 1.0);
    return values[0] + t * (values[1] - values[0]);
  }
  [[nodiscard]] double acrossAt(double along) const { return at(across, along); }
  [[nodiscard]] double heightAt(double along) const { return at(height, along); }
  [[nodiscard]] double slope() const { return std::fabs(height[1] - height[0]) / (end - begin); }
};

/// Shortens an interval, along which a number changes from `atLow` to `atHigh`, to the part where the number is not
/// negative. Returns false when nothing is left.
bool keepPositive(std::array<double, 2>& ends, double atLow, double atHigh) {
  if (atLow < 0 && atHigh < 0) return false;
  const double zero = ends[0] + (ends[1] - ends[0]) * (atLow / (atLow - atHigh));
  if (atLow < 0) ends[0] = zero;
  if (atHigh < 0) ends[1] = zero;
  return ends[1] - ends[0] > GapConditions::kShort;
}

/// Clips a convex polygon to the part where `distance` is not negative.
template <class Corner, class Distance>
void clip(std::vector<Corner>& polygon, std::vector<Corner>& room, Distance distance) {
  room.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double atP = distance(p), atQ = distance(q);
    if (atP >= 0) room.push_back(p);
    if ((atP < 0) == (atQ < 0)) continue;
    const double t = atP / (atP - atQ);
    Corner between{};
    for (std::size_t k = 0; k < between.size(); ++k) between[k] = p[k] + t * (q[k] - p[k]);
    room.push_back(between);
  }
  polygon.swap(room);
}

/// A linear function of the place, also beyond the ends.
double lineAt(const Profile& border, const std::array<double, 2>& values, double along) {
  return values[0] + (along - border.begin) * ((values[1] - values[0]) / (border.end - border.begin));
}

struct Profiles {
  Profile first, second;
  Profiles(const GapFrame& frame, const GapBorder& e, const GapBorder& f)
      : first(frame, e.from, e.to), second(frame, f.to, f.from) {}
  [[nodiscard]] double widthAt(double along) const { return second.acrossAt(along) - first.acrossAt(along); }
  [[nodiscard]] double riseAt(double along) const { return second.heightAt(along) - first.heightAt(along); }
  /// The error of heights, which grows with the slope because places have errors along it.
  [[nodiscard]] double heightSlack() const { return kSlack * (1 + std::max(first.slope(), second.slope())); }
};

// Every corner that is left of a clipped triangle lies within 2^-10 of the triangle and of the hull of these places:
// each of six cuts rounds coordinates of 2^37 a few times. The products that compare it with a side are off by less
// than 2^-11 of the side. The margin of kSlack, 2^-8, is more than both together, so a triangle beyond it has no part
// that clip() leaves.
GapStrip stripOf(const Profiles& p, const std::array<double, 2>& ends) {
  const double low = ends[0] - 2 * kSlack, high = ends[1] + 2 * kSlack;
  return {{{{low, lineAt(p.first, p.first.across, low) - kSlack},
            {high, lineAt(p.first, p.first.across, high) - kSlack},
            {low, lineAt(p.second, p.second.across, low) + kSlack},
            {high, lineAt(p.second, p.second.across, high) + kSlack}}},
          kSlack};
}

/// The heights over a strip at which obstacles matter, `above[0]` over the lower border to `above[1]` over the higher.
/// clip() cuts nearer to the borders by one slack of heights than findFree() gives here.
GapStrip::Heights heightsOf(const Profiles& p, const std::array<double, 2>& ends, const std::array<double, 2>& above) {
  GapStrip::Heights heights;
  for (const std::size_t i : {0, 1}) {
    const double along = ends[i] + (i == 0 ? -2 : 2) * kSlack;
    const auto [low, high] =
        std::minmax({lineAt(p.first, p.first.height, along), lineAt(p.second, p.second.height, along)});
    heights.lowest[i] = low + above[0];
    heights.highest[i] = high + above[1];
  }
  return heights;
}

}  // namespace

std::optional<GapFrame> GapConditions::frameOf(const GapBorder& first, const GapBorder& second) {
  const double ex = first.to.x - first.from.x, ey = first.to.y - first.from.y;
  const double fx = second.from.x - second.to.x, fy = second.from.y - second.to.y;
  const double e = std::sqrt(ex * ex + ey * ey), f = std::sqrt(fx * fx + fy * fy);
  if (!(e > kShort) || !(f > kShort) || !(ex * fx + ey * fy >= kLeastSine * e * f)) return std::nullopt;
  const double x = ex / e + fx / f, y = ey / e + fy / f, size = std::sqrt(x * x + y * y);
  return GapFrame{first.from.x, first.from.y, x / size, y / size};
}

void GapPiece::setWays(const std::array<double, 2>& places) {
  const double factor = (ends[1] - ends[0]) / (places[1] - places[0]);
  const double shift = ends[0] / factor - places[0];
  secondFrame = {frame.originX - shift * frame.alongX, frame.originY - shift * frame.alongY, factor * frame.alongX,
                 factor * frame.alongY};
  skew = std::max(std::fabs(ends[0] - places[0]), std::fabs(ends[1] - places[1]));
}

std::optional<GapPiece> GapConditions::findNear(const GapBorder& first, const GapBorder& second) const {
  const std::optional<GapFrame> frame = frameOf(first, second);
  return frame ? findNear(first, second, *frame, kSlack) : std::nullopt;
}

std::optional<GapPiece> GapConditions::findNear(const GapBorder& first, const GapBorder& second, const GapFrame& frame,
                                                double spare) const {
  const Profiles p(frame, first, second);
  GapPiece piece{frame, {std::max(p.first.begin, p.second.begin), std::min(p.first.end, p.second.end)}, {}};
  std::array<double, 2>& ends = piece.ends;
  if (!(ends[1] - ends[0] > kShort)) return std::nullopt;
  // Where the borders are hardly apart, or end in one place, the caller decides on which side they are.
  std::array<double, 2> room{p.widthAt(ends[0]), p.widthAt(ends[1])};
  if (std::min(room[0], room[1]) < -kTouch || std::max(room[0], room[1]) > kWide) {
    for (const int i : {0, 1}) {
      const auto isVertexOf = [&](const Profile& border) {
        return std::fabs(ends[i] - (i == 0 ? border.begin : border.end)) <= kSnap;
      };
      if (std::fabs(room[i]) <= kTouch && isVertexOf(p.first) && isVertexOf(p.second))
        room[i] = 0;
      else
        room[i] -= 2 * kTouch;
    }
    if (!keepPositive(ends, room[0], room[1])) return std::nullopt;
  }
  const double most = gap_ - spare;
  const std::array<double, 2> widths{p.widthAt(ends[0]), p.widthAt(ends[1])};
  piece.isAsWide = std::max(widths[0], widths[1]) > most && std::max(widths[0], widths[1]) <= gap_ + kTouch;
  if (!piece.isAsWide && !keepPositive(ends, most - widths[0], most - widths[1])) return std::nullopt;
  if (first.level && second.level) {
    const auto [low, high] = std::minmax(*first.level, *second.level);
    return signOfDifference(high, low, step_) <= 0 ? std::optional(std::move(piece)) : std::nullopt;
  }
  for (const double sign : {1.0, -1.0}) {
    const auto [low, high] = std::minmax({sign * p.riseAt(ends[0]), sign * p.riseAt(ends[1])});
    if (atLimit_ && low >= (*atLimit_)[0] && high > (*atLimit_)[1]) return std::nullopt;
    const double highest = step_ - 4 * p.heightSlack();  // keeps the higher floor itself from being an obstacle
    if (!keepPositive(ends, highest - sign * p.riseAt(ends[0]), highest - sign * p.riseAt(ends[1])))
      return std::nullopt;
  }
  return piece;
}

// Widths and rises are linear functions of the way's place, so it suffices to test both ends.
std::optional<GapPiece> GapConditions::findBetween(const GapBorder& first, const GapBorder& second,
                                                   const GapPiece& piece,
                                                   const std::array<std::array<double, 2>, 2>& places) {
  const auto& [own, other] = places;
  if (!(own[1] - own[0] > kShort) || !(other[1] - other[0] > kShort)) return std::nullopt;
  const Profiles p(piece.frame, first, second);
  // The slack that findFree() gives turned ways must not make the higher floor an obstacle.
  const double skew = std::max(std::fabs(other[0] - own[0]), std::fabs(other[1] - own[1]));
  const double highest = step_ - 4 * p.heightSlack() - 2 * skew * std::max(p.first.slope(), p.second.slope());
  const double most = gap_ - kSpareWidth;
  std::array<double, 2> rises{};
  for (const std::size_t i : {0, 1}) {
    const double along = other[i] - own[i];
    const double across = p.second.acrossAt(other[i]) - p.first.acrossAt(own[i]);
    const bool isKnown = own[i] == piece.ends[i] && other[i] == piece.ends[i];  // an end of the piece as it was
    if (!isKnown && !(along * along + across * across <= most * most && across > 2 * kTouch)) return std::nullopt;
    // The way's angle with a border has the sine of their cross product.
    for (const Profile* border : {&p.first, &p.second}) {
      const double length = border->end - border->begin, turn = border->across[1] - border->across[0];
      const double product = length * across - turn * along, least = kLeastTurnedSine * kLeastTurnedSine;
      if (!isKnown && !(product > 0 && product * product >=
                                           least * (length * length + turn * turn) * (along * along + across * across)))
        return std::nullopt;
    }
    rises[i] = p.second.heightAt(other[i]) - p.first.heightAt(own[i]);
  }
  if (!first.level || !second.level)
    for (const double sign : {1.0, -1.0}) {
      const auto [low, high] = std::minmax({sign * rises[0], sign * rises[1]});
      if (high > highest || (atLimit_ && low >= (*atLimit_)[0] && high > (*atLimit_)[1])) return std::nullopt;
    }
  GapPiece skewed = piece;
  skewed.ends = own;
  skewed.setWays(other);
  std::vector<GapPiece> free = findFree(first, second, skewed);
  if (free.size() != 1 || free[0].ends != own) return std::nullopt;
  return std::move(free[0]);
}

std::vector<GapPiece> GapConditions::findFree(const GapBorder& first, const GapBorder& second, const GapPiece& near) {
  const GapFrame& frame = near.frame;
  const Profiles p(frame, first, second);
  const double begin = near.ends[0], end = near.ends[1];
  // A turned way leads as far as its skew along the borders, whose heights change on the way.
  const double slack = p.heightSlack() + near.skew * std::max(p.first.slope(), p.second.slope());
  // The outermost places of both borders.
  const std::array<double, 2> reached{std::min(begin, near.placeAcross(begin)), std::max(end, near.placeAcross(end))};
  // The lower and the higher border; either may be both where they cross.
  std::vector<const Profile*> lower, higher;
  const double riseBegin = p.riseAt(begin), riseEnd = p.riseAt(end);
  if (std::min(riseBegin, riseEnd) < 0) lower.push_back(&p.second), higher.push_back(&p.first);
  if (std::max(riseBegin, riseEnd) >= 0) lower.push_back(&p.first), higher.push_back(&p.second);

  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = kInfinity;
    box.upper[k] = -kInfinity;
  }
  for (const Profile* border : {&p.first, &p.second})
    for (const double along : reached) {
      Vec3 place = frame.place(along, lineAt(*border, border->across, along));
      place.z = lineAt(*border, border->height, along);
      const std::array<double, 3> values{place.x, place.y, place.z};
      for (int k = 0; k < 3; ++k) {
        box.lower[k] = std::min(box.lower[k], values[k] - 4 * kSlack);
        box.upper[k] = std::max(box.upper[k], values[k] + 4 * kSlack);
      }
    }
  box.lower[2] += step_ - slack;
  box.upper[2] += clearance_ + slack;
  const int scale = mesh_.grid.scaleExponent();
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::nextafter(std::ldexp(box.lower[k], -scale), -kInfinity);
    box.upper[k] = std::nextafter(std::ldexp(box.upper[k], -scale), kInfinity);
  }

  GapPiece whole = near;
  const double skew = near.skew;  // no way leads farther along the borders
  std::vector<std::array<double, 2>> blocked;
  std::vector<Corner> polygon, room;
  const GapStrip strip = stripOf(p, reached);
  const GapStrip::Heights heights = heightsOf(p, reached, {step_ - 2 * slack, clearance_ + 2 * slack});
  bool isBlocked = false;  // as a whole, so that no other obstacle matters
  const auto block = [&](Index t) {
    const auto& corners = mesh_.triangles[t];
    std::array<GapStrip::Place, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& c = mesh_.scaled[corners[k]];
      places[k] = {frame.along(c.x, c.y), frame.across(c.x, c.y)};
    }
    const auto zOf = [&](std::size_t k) { return mesh_.scaled[corners[k]].z; };
    if (strip.isBeyondSide(places) || strip.isOffPlane(places, {zOf(0), zOf(1), zOf(2)}, heights)) return;
    double lowest = kInfinity, highest = -kInfinity;
    for (const Index v : corners) {
      lowest = std::min(lowest, mesh_.scaled[v].z);
      highest = std::max(highest, mesh_.scaled[v].z);
    }
    if (first.level && second.level) {
      const auto [low, high] = std::minmax(*first.level, *second.level);
      if (signOfDifference(highest, low, step_) <= 0 || signOfDifference(lowest, high, clearance_) >= 0) return;
    }
    for (const Profile* low : lower)
      for (const Profile* high : higher) {
        polygon.clear();
        for (std::size_t k = 0; k < 3; ++k) polygon.push_back({places[k][0], places[k][1], zOf(k)});
        clip(polygon, room, [&](const Corner& c) { return c[0] - reached[0] + 2 * kSlack; });
        clip(polygon, room, [&](const Corner& c) { return reached[1] - c[0] + 2 * kSlack; });
        clip(polygon, room, [&](const Corner& c) { return c[1] - lineAt(p.first, p.first.across, c[0]) + kSlack; });
        clip(polygon, room, [&](const Corner& c) { return lineAt(p.second, p.second.across, c[0]) - c[1] + kSlack; });
        clip(polygon, room, [&](const Corner& c) { return c[2] - lineAt(*low, low->height, c[0]) - step_ + slack; });
        clip(polygon, room,
             [&](const Corner& c) { return lineAt(*high, high->height, c[0]) + clearance_ - c[2] + slack; });
        if (polygon.empty()) continue;
        double from = kInfinity, to = -kInfinity;
        for (const Corner& c : polygon) {
          from = std::min(from, c[0]);
          to = std::max(to, c[0]);
        }
        if (to <= reached[0] + kSlack)
          whole.touching[0].push_back(t);
        else if (from >= reached[1] - kSlack)
          whole.touching[1].push_back(t);
        else {
          blocked.push_back({from - kSlack - skew, to + kSlack + skew});
          isBlocked = isBlocked || (blocked.back()[0] <= begin && blocked.back()[1] >= end);
        }
      }
  };
  mesh_.tree.visitOverlapping(box, stack_, [&](Index t) {
    if (removed_[t] == 0) block(t);
    return !isBlocked;
  });
  if (isBlocked) return {};
  for (std::vector<Index>& some : whole.touching) {
    sortOnce(some);
  }
  std::sort(blocked.begin(), blocked.end());

  std::vector<GapPiece> pieces;
  const auto add = [&](double from, double to) {
    if (!(to - from > kShort)) return;
    pieces.push_back({frame, {from, to}, {}, near.isAsWide, near.corner, near.secondFrame, skew});
    if (from == begin) pieces.back().touching[0] = whole.touching[0];
    if (to == end) pieces.back().touching[1] = whole.touching[1];
  };
  double from = begin;
  for (const auto& [low, high] : blocked) {
    add(from, low);
    from = std::max(from, high);
  }
  add(from, end);
  return pieces;
}

}  // namespace footfall::detail
