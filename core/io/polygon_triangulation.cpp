// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/exact/source_predicates.hpp"
#include "core/io/outline_triangulation.hpp"

namespace footfall::detail {
namespace {

using Corners = std::vector<std::uint32_t>;

/// Newell's normal relative to the first corner, with the coordinates scaled so that it neither overflows nor vanishes.
Vec3 newellNormal(const Corners& corners, const std::vector<Vec3>& vertices) {
  const Vec3 origin = vertices[corners[0]];
  double extent = 0;
  for (const std::uint32_t corner : corners) {
    const Vec3& p = vertices[corner];
    extent = std::max({extent, std::fabs(p.x / 2 - origin.x / 2), std::fabs(p.y / 2 - origin.y / 2),
                       std::fabs(p.z / 2 - origin.z / 2)});
  }
  if (extent == 0) return {};
  const auto scaled = [&](std::uint32_t corner) {
    const Vec3& p = vertices[corner];
    return Vec3{(p.x / 2 - origin.x / 2) / extent, (p.y / 2 - origin.y / 2) / extent,
                (p.z / 2 - origin.z / 2) / extent};
  };
  Vec3 normal;
  Vec3 previous = scaled(corners.back());
  for (const std::uint32_t corner : corners) {
    const Vec3 p = scaled(corner);
    normal.x += previous.y * p.z - previous.z * p.y;
    normal.y += previous.z * p.x - previous.x * p.z;
    normal.z += previous.x * p.y - previous.y * p.x;
    previous = p;
  }
  return normal;
}

/// The polygon in the coordinate plane of its largest projection. All further decisions are exact in that plane.
class ProjectedPolygon {
 public:
  ProjectedPolygon(const Corners& corners, const std::vector<Vec3>& vertices) {
    const Vec3 normal = newellNormal(corners, vertices);
    const double ax = std::fabs(normal.x), ay = std::fabs(normal.y), az = std::fabs(normal.z);
    points_.reserve(corners.size());
    for (const std::uint32_t corner : corners) {
      const Vec3& p = vertices[corner];
      if (az >= ax && az >= ay) {
        points_.push_back(p);
      } else if (ax >= ay) {
        points_.push_back({p.y, p.z, p.x});
      } else {
        points_.push_back({p.z, p.x, p.y});
      }
    }
    const double dominant = az >= ax && az >= ay ? normal.z : ax >= ay ? normal.x : normal.y;
    orientation_ = dominant > 0 ? 1 : dominant < 0 ? -1 : 0;
  }

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool hasArea() const { return orientation_ != 0; }
  /// The corners in the plane, with the third coordinate as height above it.
  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }

  /// +1 when the corners a, b, c turn the same way as the polygon, 0 when they are collinear.
  [[nodiscard]] int turn(std::size_t a, std::size_t b, std::size_t c) const {
    return orientation_ * facing(points_[a], points_[b], points_[c]);
  }

  /// True when p lies in the triangle a, b, c (which turns the polygon's way) or on its border, but not on a corner.
  [[nodiscard]] bool blocks(std::size_t p, std::size_t a, std::size_t b, std::size_t c) const {
    const Vec3& q = points_[p];
    const Vec3 &pa = points_[a], &pb = points_[b], &pc = points_[c];
    if (q.x < std::min({pa.x, pb.x, pc.x}) || q.x > std::max({pa.x, pb.x, pc.x}) ||
        q.y < std::min({pa.y, pb.y, pc.y}) || q.y > std::max({pa.y, pb.y, pc.y})) {
      return false;
    }
    if (sameInPlane(q, pa) || sameInPlane(q, pb) || sameInPlane(q, pc)) return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  }

 private:
  static bool sameInPlane(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y; }

  std::vector<Vec3> points_;
  int orientation_ = 0;
};

using LocalTriangle = std::array<std::size_t, 3>;

bool fanIsValid(const ProjectedPolygon& polygon) {
  if (!polygon.hasArea()) return false;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    if (polygon.turn(0, i, i + 1) <= 0) return false;
  }
  return true;
}

/// Ears as triangles of corner numbers; empty when the polygon crosses itself.
///
/// The signed triangles of any ear clipping add up to the polygon's winding number, so a clipping whose triangles all
/// turn the polygon's way covers a simple polygon exactly once. The test for corners inside an ear only keeps the
/// clipping from getting stuck.
std::vector<LocalTriangle> clipEars(const ProjectedPolygon& polygon) {
  std::vector<LocalTriangle> ears;
  if (!polygon.hasArea()) return ears;
  const std::size_t count = polygon.size();
  std::vector<std::size_t> next(count), previous(count);
  for (std::size_t i = 0; i < count; ++i) {
    next[i] = (i + 1) % count;
    previous[i] = (i + count - 1) % count;
  }
  // Only corners that do not turn the polygon's way can lie in an ear; clipping never makes a convex corner reflex.
  std::vector<std::size_t> reflex;
  for (std::size_t i = 0; i < count; ++i) {
    if (polygon.turn(previous[i], i, next[i]) <= 0) reflex.push_back(i);
  }
  ears.reserve(count - 2);
  std::size_t corner = 0, remaining = count, rejected = 0;
  while (remaining > 3) {
    if (rejected == remaining) return {};  // all corners were tried without finding an ear
    const std::size_t a = previous[corner], c = next[corner];
    const bool isEar = polygon.turn(a, corner, c) > 0 && std::none_of(reflex.begin(), reflex.end(), [&](auto p) {
                         return p != a && p != corner && p != c && polygon.blocks(p, a, corner, c);
                       });
    if (!isEar) {
      corner = c;
      ++rejected;
      continue;
    }
    ears.push_back({a, corner, c});
    next[a] = c;
    previous[c] = a;
    --remaining;
    rejected = 0;
    std::erase_if(reflex, [&](auto p) { return (p == a || p == c) && polygon.turn(previous[p], p, next[p]) > 0; });
    corner = next[c];  // skipping one corner gives fewer thin triangles than continuing at the same one
  }
  const LocalTriangle last{previous[corner], corner, next[corner]};
  if (polygon.turn(last[0], last[1], last[2]) <= 0) return {};
  ears.push_back(last);
  return ears;
}

}  // namespace

bool triangulatePolygon(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                        std::vector<Triangle>& triangles, Poll poll) {
  if (corners.size() == 3) {
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return false;
    triangles.push_back({corners[0], corners[1], corners[2]});
    return true;
  }
  Corners distinct;
  distinct.reserve(corners.size());
  for (const std::uint32_t corner : corners) {
    if (distinct.empty() || distinct.back() != corner) distinct.push_back(corner);
  }
  while (distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
  const auto firstOther = [&](std::size_t from, std::uint32_t a, std::uint32_t b) {
    return std::any_of(distinct.begin() + static_cast<std::ptrdiff_t>(from), distinct.end(),
                       [&](std::uint32_t corner) { return corner != a && corner != b; });
  };
  if (distinct.size() < 3 || !firstOther(2, distinct[0], distinct[1])) return false;

  const ProjectedPolygon polygon(distinct, vertices);
  if (distinct.size() > 3 && !fanIsValid(polygon)) {
    const bool isLarge = distinct.size() > kMostClippedCorners;
    const std::vector<LocalTriangle> parts = isLarge ? triangulateOutline(polygon.points(), poll) : clipEars(polygon);
    for (const auto& [a, b, c] : parts) triangles.push_back({distinct[a], distinct[b], distinct[c]});
    if (!parts.empty()) return true;
  }
  for (std::size_t i = 1; i + 1 < distinct.size(); ++i) {
    const Triangle triangle{distinct[0], distinct[i], distinct[i + 1]};
    if (triangle[0] != triangle[1] && triangle[2] != triangle[0]) triangles.push_back(triangle);
  }
  return true;
}

}  // namespace footfall::detail
