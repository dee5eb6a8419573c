// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/border_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace footfall::reference {
namespace {

constexpr double kLeastReach = 1e-10;  // doubles of a level resolve less, but not by much
constexpr double kHair = 1e-7;         // tolerance of heights and shares
constexpr double kBeside = 1e-6;       // distance to the right of the border of a place beside it
constexpr double kCloser = 1e-3;    // share of that: a border that differs there, or as much closer, has another limit
                                    // than doubles resolve
constexpr double kLeaning = 1e-11;  // least lean from foot to top: below it, the wall is an upright one that was
                                    // rounded

/// Heights of a triangle straight over a place of the plan.
struct HeightRange {
  double lowest = 0, highest = 0;
};

double squaredPlanLength(const Vec3& p, const Vec3& q) { return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y); }

/// The heights at which an upright triangle or any other one is cut by the upright line at (x, y), which upright ones
/// need meet only within `reach`.
std::optional<HeightRange> heightsAt(const std::array<Vec3, 3>& t, double x, double y, double reach) {
  const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
  const double longest =
      std::max({squaredPlanLength(t[0], t[1]), squaredPlanLength(t[1], t[2]), squaredPlanLength(t[2], t[0])});
  if (area * area <= kLeaning * kLeaning * longest) {
    HeightRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = t[k], &q = t[(k + 1) % 3];
      const double dx = q.x - p.x, dy = q.y - p.y, square = dx * dx + dy * dy;
      if (square == 0) continue;
      const double s = ((x - p.x) * dx + (y - p.y) * dy) / square;
      if (s < 0 || s > 1 || std::fabs((x - p.x) * dy - (y - p.y) * dx) > reach * std::sqrt(square)) continue;
      const double z = p.z + s * (q.z - p.z);
      range = {std::min(range.lowest, z), std::max(range.highest, z)};
    }
    return range.lowest <= range.highest ? std::optional(range) : std::nullopt;
  }
  std::array<double, 3> share{};
  for (int k = 0; k < 3; ++k) {
    const Vec3 &p = t[(k + 1) % 3], &q = t[(k + 2) % 3];
    share[k] = ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)) / area;
    if (share[k] < 0) return std::nullopt;
  }
  const double z = share[0] * t[0].z + share[1] * t[1].z + share[2] * t[2].z;
  return HeightRange{z, z};
}

void addShare(double share, std::vector<double>& shares) {
  if (share > 0 && share < 1) shares.push_back(share);
}

/// Adds the places along the edge at which something about a triangle may change.
void addShares(const std::array<Vec3, 3>& t, const Vec3& a, const Vec3& b, double step, double height,
               std::vector<double>& shares) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const auto shareOf = [&](const Vec3& p) { return ((p.x - a.x) * dx + (p.y - a.y) * dy) / square; };
  for (int k = 0; k < 3; ++k) {
    const Vec3 &p = t[k], &q = t[(k + 1) % 3];
    addShare(shareOf(p), shares);
    const double atP = dx * (p.y - a.y) - dy * (p.x - a.x), atQ = dx * (q.y - a.y) - dy * (q.x - a.x);
    if (atP * atQ < 0) {
      const double s = atP / (atP - atQ);
      addShare(shareOf({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), 0}), shares);
    }
    for (const double level : {step, height}) {  // levels along an upright triangle's edge
      const double overP = p.z - (a.z + shareOf(p) * (b.z - a.z) + level);
      const double overQ = q.z - (a.z + shareOf(q) * (b.z - a.z) + level);
      if (overP * overQ < 0) addShare(shareOf(p) + overP / (overP - overQ) * (shareOf(q) - shareOf(p)), shares);
    }
  }
  // The place where the plane is that much over the edge.
  const Vec3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z}, v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  const Vec3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  if (n.z == 0) return;
  const auto over = [&](const Vec3& p) { return t[0].z - (n.x * (p.x - t[0].x) + n.y * (p.y - t[0].y)) / n.z - p.z; };
  const double atA = over(a), atB = over(b);
  for (const double level : {step, height})
    if (atA != atB) addShare((level - atA) / (atB - atA), shares);
}

/// How far a triangle leans in the plan for each unit of height.
double leanOf(const std::array<Vec3, 3>& t) {
  const Vec3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z}, v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
  return std::fabs(z) / std::hypot(x, y);
}

}  // namespace

std::vector<BorderStretch> stretchesOf(const Environment& environment, const Vec3& a, const Vec3& b, double step,
                                       double height) {
  std::vector<std::array<Vec3, 3>> near;
  std::vector<double> shares{0, 1};
  for (const Triangle& f : environment.triangles) {
    const std::array<Vec3, 3> t{environment.vertices[f[0]], environment.vertices[f[1]], environment.vertices[f[2]]};
    const auto isBeyond = [&](double Vec3::*axis) {
      const double low = std::min(a.*axis, b.*axis), high = std::max(a.*axis, b.*axis);
      return std::max({t[0].*axis, t[1].*axis, t[2].*axis}) < low - 1e-3 ||
             std::min({t[0].*axis, t[1].*axis, t[2].*axis}) > high + 1e-3 + (axis == &Vec3::z ? height : 0);
    };
    if (isBeyond(&Vec3::x) || isBeyond(&Vec3::y) || isBeyond(&Vec3::z)) continue;
    near.push_back(t);
    addShares(t, a, b, step, height, shares);
  }
  std::sort(shares.begin(), shares.end());
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double outX = (b.y - a.y) / length, outY = -(b.x - a.x) / length;
  const auto reaches = [&](const std::vector<std::array<Vec3, 3>>& some, double share, double more, double beside) {
    const double x = a.x + share * (b.x - a.x), y = a.y + share * (b.y - a.y), z = a.z + share * (b.z - a.z);
    return std::any_of(some.begin(), some.end(), [&](const std::array<Vec3, 3>& t) {
      for (const double out : {0.0, beside}) {
        const auto range = heightsAt(t, x + out * outX, y + out * outY, out == 0 ? 1e-9 : 0);
        if (range && range->highest > z + step - more && range->lowest < z + height + more) return true;
      }
      return false;
    });
  };
  // A wall that leans by at most four steps of a grid between the step and the height stands at the border if it is
  // within four steps; where two or eight steps decide, it is doubtful. Halving the distance misses no such wall.
  const auto reachesWithin = [&](double share, double steps) {
    const double most = steps * environment.grid.step;
    std::vector<std::array<Vec3, 3>> tilted;
    for (const auto& t : near)
      if (leanOf(t) * (height - step) <= most) tilted.push_back(t);
    bool isReached = false;
    for (double out = most; out > kLeastReach && !isReached && !tilted.empty(); out /= 2)
      isReached = reaches(tilted, share, 0, out);
    return isReached;
  };
  std::vector<BorderStretch> stretches;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double begin = shares[i - 1], end = shares[i], middle = begin + (end - begin) / 2;
    if (begin == end) continue;
    BorderKind kind = BorderKind::Doubtful;
    const bool isWall = reaches(near, middle, 0, kBeside);
    const auto isSure = [&](double beside) {
      return reaches(near, middle, kHair, beside) == isWall && reaches(near, middle, -kHair, beside) == isWall;
    };
    if ((end - begin) * length > 10 * kBeside && isSure(kBeside) && isSure(kCloser * kBeside) &&
        isSure(kCloser * kCloser * kBeside))
      kind = isWall ? BorderKind::Wall : BorderKind::Ledge;
    if (kind == BorderKind::Ledge && reachesWithin(middle, 8))
      kind = reachesWithin(middle, 2) ? BorderKind::Wall : BorderKind::Doubtful;
    if (!stretches.empty() && stretches.back().kind == kind)
      stretches.back().end = end;
    else
      stretches.push_back({begin, end, kind});
  }
  return stretches;
}

}  // namespace footfall::reference
