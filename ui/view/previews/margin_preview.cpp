// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/margin_preview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kMostNearPairs = 2'000'000;
constexpr double kSteepest = 1.2;    // largest rise of a floor on the way to it
constexpr int kCapSides = 4;         // straight sides that stand for a quarter of a circle
constexpr double kLeastArea = 1e-9;  // share of the square of the distance: smaller areas are invisible

/// Clips a convex polygon to the part where `distance`, which is linear, is at least 0.
template <class Distance>
void clip(std::vector<Vec3>& polygon, std::vector<Vec3>& kept, const Distance& distance) {
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = distance(a), db = distance(b);
    if (da >= 0) kept.push_back(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  polygon.swap(kept);
}

double areaInPlan(const std::vector<Vec3>& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += (polygon[i].x - polygon[0].x) * (polygon[i + 1].y - polygon[0].y) -
             (polygon[i].y - polygon[0].y) * (polygon[i + 1].x - polygon[0].x);
  return twice / 2;
}

double distanceTo(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0) : 0;
  return std::hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

/// A lower bound of the distance between a border and a triangle in the plan.
double gapBetween(const PreviewBorder& border, const std::array<Vec3, 3>& triangle) {
  const auto side = [](const Vec3& a, const Vec3& b, const Vec3& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  double least = std::numeric_limits<double>::infinity();
  bool isInside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = triangle[k], &b = triangle[(k + 1) % 3];
    isInside = isInside && side(a, b, border.from) >= 0;
    if (side(a, b, border.from) * side(a, b, border.to) <= 0 &&
        side(border.from, border.to, a) * side(border.from, border.to, b) <= 0)
      return 0;
    least = std::min(
        {least, distanceTo(border.from, a, b), distanceTo(border.to, a, b), distanceTo(a, border.from, border.to)});
  }
  return isInside ? 0 : least;
}

}  // namespace

BorderStrips::BorderStrips(std::shared_ptr<const NavigationMesh> mesh, double limit, Poll poll)
    : mesh_(std::move(mesh)), borders_(findBorders(*mesh_, poll)) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (const Triangle& t : mesh_->triangles) {
    ids.push_back(static_cast<std::int32_t>(ids.size()));
    boxes.push_back(boxAround({mesh_->vertices[t[0]], mesh_->vertices[t[1]], mesh_->vertices[t[2]]}, 0, 0));
  }
  TriangleTree tree;
  tree.build(boxes, ids, poll);
  std::vector<std::int32_t> stack;
  for (std::uint32_t i = 0; i < borders_.size(); ++i) {
    poll();
    const PreviewBorder& border = borders_[i];
    tree.visitOverlapping(boxAround({border.from, border.to}, limit, kSteepest * limit), stack, [&](std::int32_t id) {
      const auto t = static_cast<std::uint32_t>(id);
      const Triangle& corners = mesh_->triangles[t];
      const bool isInside = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
        return dot(mesh_->vertices[corner] - border.from, border.inward) > 0;
      });
      const double least =
          gapBetween(border, {mesh_->vertices[corners[0]], mesh_->vertices[corners[1]], mesh_->vertices[corners[2]]});
      if (isInside && least <= limit) pairs_.push_back({i, t, static_cast<float>(least)});
      return true;
    });
    if (pairs_.size() <= kMostNearPairs) continue;
    pairs_.clear();
    tooMany_ = true;
    return;
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) { return a.least < b.least; });
}

void BorderStrips::add(NavigationMesh& soup, const Pair& pair, double distance) const {
  thread_local std::vector<Vec3> polygon, kept;
  const PreviewBorder& border = borders_[pair.border];
  polygon.clear();
  for (const std::uint32_t corner : mesh_->triangles[pair.triangle]) polygon.push_back(mesh_->vertices[corner]);
  const auto limitTo = [&](const Vec3& end, const Vec3& out) {
    clip(polygon, kept, [&](const Vec3& p) { return distance - dot(p - end, out); });
  };
  clip(polygon, kept, [&](const Vec3& p) { return dot(p - border.from, border.inward); });
  limitTo(border.from, border.inward);
  // Rounds the ends, on the inner side.
  for (int i = 0; i < kCapSides; ++i) {
    const double angle = std::numbers::pi / 2 * i / kCapSides;
    const Vec3 sideways = std::cos(angle) * border.along, in = std::sin(angle) * border.inward;
    limitTo(border.to, in + sideways);
    limitTo(border.from, in - sideways);
  }
  if (polygon.size() < 3 || areaInPlan(polygon) <= kLeastArea * distance * distance) return;
  const auto base = static_cast<std::uint32_t>(soup.vertices.size());
  soup.vertices.insert(soup.vertices.end(), polygon.begin(), polygon.end());
  for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i) soup.triangles.push_back({base, base + i, base + i + 1});
}

NavigationMesh BorderStrips::within(double distance) const {
  NavigationMesh soup;
  const auto isWithin = [distance](const Pair& pair) { return pair.least <= distance; };
  const auto end = std::partition_point(pairs_.begin(), pairs_.end(), isWithin);
  // Most pairs give some triangles.
  if (end - pairs_.begin() > static_cast<std::ptrdiff_t>(kMostPreviewed)) return {};
  for (auto pair = pairs_.begin(); pair != end; ++pair) {
    add(soup, *pair, distance);
    if (soup.triangles.size() > kMostPreviewed) return {};
  }
  return soup;
}

MarginPreview::MarginPreview(const EditedStep& step, const Vec3& centre, Poll poll)
    : centre_(centre),
      radius_(step.values[0]),
      left_(step.result, radius_, poll),
      before_(step.before, radius_, poll) {}

bool MarginPreview::suits(const EditedStep& step) const {
  return step.result == left_.mesh() && step.before == before_.mesh() && step.values[0] == radius_;
}

EditPreview::Surfaces MarginPreview::changes(const Values& from, const Values& to) const {
  const bool even = from[0] == from[1] && to[0] == to[1] && std::equal(from.begin() + 2, from.end(), to.begin() + 2);
  if (!even || from[0] != radius_ || !(to[0] <= 2 * radius_)) return {};
  const Paint removed = removalStyle(FilterType::Radius)->paint;
  if (to[0] > radius_) {
    const NavigationMesh gone = left_.within(to[0] - radius_);
    if (gone.triangles.empty()) return {};
    return {makeMeshGeometry(gone, centre_, removed)};
  }
  const NavigationMesh back = before_.within(radius_), still = before_.within(to[0]);
  if (back.triangles.empty()) return {};
  Surfaces surfaces{makeMeshGeometry(back, centre_, walkablePaint())};
  if (!still.triangles.empty()) surfaces.push_back(makeMeshGeometry(still, centre_, removed));
  return surfaces;
}

}  // namespace footfall::ui
