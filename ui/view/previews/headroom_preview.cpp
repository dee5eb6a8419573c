// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/headroom_preview.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/triangle_tree.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr double kClearanceReach = 2;  // factor on the clearance of the run: only a run computes larger edits
// share of the reach: anything lower above a floor is the floor itself, or its support
constexpr double kTouching = 1e-6;
constexpr double kThinnestCover = 1e-9;        // share of the floor's own area: a smaller cover is invisible
constexpr std::size_t kMostPairs = 4'000'000;  // 64 MB; larger levels have no preview

double planCross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

}  // namespace

HeadroomPreview::HeadroomPreview(const EditedStep& step, std::shared_ptr<const Environment> environment,
                                 const Vec3& centre, Poll poll)
    : floors_(step.before),
      environment_(std::move(environment)),
      centre_(centre),
      limit_(kClearanceReach * step.values[0]) {
  findPairs(poll);
}

// The corners are relative to the centre, where doubles are most precise.
std::array<Vec3, 3> HeadroomPreview::cornersOf(const std::vector<Vec3>& vertices, const Triangle& triangle) const {
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = vertices[triangle[k]];
    corners[k] = {p.x - centre_.x, p.y - centre_.y, p.z - centre_.z};
  }
  return corners;
}

void HeadroomPreview::findPairs(Poll poll) {
  const auto boxOf = [](const std::array<Vec3, 3>& p) {
    const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto [z0, z1] = std::minmax({p[0].z, p[1].z, p[2].z});
    return Box{{x0, y0, z0}, {x1, y1, z1}};
  };
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (const Triangle& triangle : environment_->triangles) {
    ids.push_back(static_cast<std::int32_t>(ids.size()));
    boxes.push_back(boxOf(cornersOf(environment_->vertices, triangle)));
  }
  TriangleTree tree;
  tree.build(boxes, ids, poll);
  std::vector<std::int32_t> stack;
  for (std::uint32_t f = 0; f < floors_->triangles.size(); ++f) {
    poll();
    Box query = boxOf(cornersOf(floors_->vertices, floors_->triangles[f]));
    query.upper[2] += limit_;
    tree.visitOverlapping(query, stack, [&](std::int32_t id) {
      Pair pair{f, static_cast<std::uint32_t>(id), 0, 0};
      const Polygon polygon = overlap(pair, kTouching * limit_, limit_);
      if (polygon.size == 0) return true;
      const auto corners = std::span(polygon.corners).first(polygon.size);
      const auto [low, high] = std::ranges::minmax(corners, {}, &Corner::height);
      // The bounds are rounded outwards, so that rounding to floats loses no pair.
      pair.low = std::nextafter(static_cast<float>(low.height), 0.0F);
      pair.high = std::nextafter(static_cast<float>(high.height), std::numeric_limits<float>::max());
      pairs_.push_back(pair);
      return true;
    });
    if (pairs_.size() <= kMostPairs) continue;
    pairs_.clear();
    limit_ = 0;
    return;
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) { return a.low < b.low; });
}

// Keeps the part where the distance, which must be linear, is at least 0.
template <class DistanceOf>
void HeadroomPreview::clip(Polygon& polygon, DistanceOf distanceOf) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Corner& a = polygon.corners[i];
    const Corner& b = polygon.corners[(i + 1) % polygon.size];
    const double da = distanceOf(a);
    const double db = distanceOf(b);
    if (kept.size + 2 > kept.corners.size()) break;  // rounding has bent it by too little to be visible
    if (da >= 0) kept.corners[kept.size++] = a;
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const double t = da / (da - db);
      kept.corners[kept.size++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.height + t * (b.height - a.height)};
    }
  }
  polygon = kept;
}

// The part of the obstacle over the floor, between two heights above it; no corners when there is none.
HeadroomPreview::Polygon HeadroomPreview::overlap(const Pair& pair, double low, double high) const {
  const auto floor = cornersOf(floors_->vertices, floors_->triangles[pair.floor]);
  const auto obstacle = cornersOf(environment_->vertices, environment_->triangles[pair.obstacle]);
  const Vec3 u{floor[1].x - floor[0].x, floor[1].y - floor[0].y, floor[1].z - floor[0].z};
  const Vec3 v{floor[2].x - floor[0].x, floor[2].y - floor[0].y, floor[2].z - floor[0].z};
  const double area = planCross(u.x, u.y, v.x, v.y);
  const double obstacleArea = planCross(obstacle[1].x - obstacle[0].x, obstacle[1].y - obstacle[0].y,
                                        obstacle[2].x - obstacle[0].x, obstacle[2].y - obstacle[0].y);
  if (!(area > 0) || std::abs(obstacleArea) <= kThinnestCover * area) return {};  // a wall covers nothing
  const double slopeX = (u.z * v.y - v.z * u.y) / area;
  const double slopeY = (u.x * v.z - v.x * u.z) / area;
  Polygon polygon;
  for (const Vec3& p : obstacle) {
    const double plane = floor[0].z + slopeX * (p.x - floor[0].x) + slopeY * (p.y - floor[0].y);
    polygon.corners[polygon.size++] = {p.x, p.y, p.z - plane};
  }
  clip(polygon, [&](const Corner& c) { return c.height - low; });
  clip(polygon, [&](const Corner& c) { return high - c.height; });
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = floor[k], &b = floor[(k + 1) % 3];
    clip(polygon, [&](const Corner& c) { return planCross(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y); });
  }
  double covered = 0;
  for (std::size_t i = 1; i + 1 < polygon.size; ++i) {
    const Corner &o = polygon.corners[0], &a = polygon.corners[i], &b = polygon.corners[i + 1];
    covered += planCross(a.x - o.x, a.y - o.y, b.x - o.x, b.y - o.y);
  }
  if (std::abs(covered) <= kThinnestCover * area) return {};
  // The polygon is counter-clockwise like the floor seen from above, even where the obstacle faces down.
  if (covered < 0) std::reverse(polygon.corners.begin(), polygon.corners.begin() + polygon.size);
  return polygon;
}

// Adds the part of the floor under the obstacle.
void HeadroomPreview::addShadow(NavigationMesh& mesh, const Pair& pair, double low, double high) const {
  const Polygon polygon = overlap(pair, low, high);
  if (polygon.size < 3) return;
  const auto floor = cornersOf(floors_->vertices, floors_->triangles[pair.floor]);
  const Vec3 u{floor[1].x - floor[0].x, floor[1].y - floor[0].y, floor[1].z - floor[0].z};
  const Vec3 v{floor[2].x - floor[0].x, floor[2].y - floor[0].y, floor[2].z - floor[0].z};
  const double area = planCross(u.x, u.y, v.x, v.y);
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Corner& c : std::span(polygon.corners).first(polygon.size)) {
    const double dx = c.x - floor[0].x, dy = c.y - floor[0].y;
    const double z = floor[0].z + (planCross(dx, dy, v.x, v.y) * u.z + planCross(u.x, u.y, dx, dy) * v.z) / area;
    mesh.vertices.push_back({c.x, c.y, z});
  }
  for (std::uint32_t i = 1; i + 1 < polygon.size; ++i) mesh.triangles.push_back({base, base + i, base + i + 1});
}

bool HeadroomPreview::suits(const EditedStep& step) const {
  return step.before == floors_ && step.values[0] < limit_ &&
         limit_ < kClearanceReach * kClearanceReach * step.values[0];
}

EditPreview::Surfaces HeadroomPreview::changes(const Values& from, const Values& to) const {
  const auto [low, high] = std::minmax(from[0], to[0]);
  if (high > limit_) return {};
  // Adds the shadows of pairs between two heights, on floors for which `wanted` is true; returns false when they are
  // too many.
  const auto addShadows = [this](NavigationMesh& mesh, double above, double below, const auto& wanted) {
    for (const Pair& pair : pairs_) {
      if (pair.low > below || mesh.triangles.size() > kMostPreviewed) break;
      if (pair.high > above && wanted(pair.floor)) addShadow(mesh, pair, above, below);
    }
    return mesh.triangles.size() <= kMostPreviewed;
  };
  NavigationMesh between;
  std::vector<bool> changed(floors_->triangles.size(), false);
  const auto noted = [&](std::uint32_t floor) { return changed[floor] = true; };
  if (!addShadows(between, low, high, noted) || between.triangles.empty()) return {};
  const Paint removed = removalStyle(FilterType::VerticalClearance)->paint;
  if (to[0] > from[0]) return {makeMeshGeometry(between, {}, removed)};
  // A part reappears only where no lower obstacle stands over it.
  NavigationMesh below;
  if (!addShadows(below, kTouching * limit_, low, [&](std::uint32_t floor) { return changed[floor]; })) return {};
  return {makeMeshGeometry(between, {}, walkablePaint()), makeMeshGeometry(below, {}, removed)};
}

}  // namespace footfall::ui
