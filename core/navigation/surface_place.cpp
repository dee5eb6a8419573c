// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/surface_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/base/infinity.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

// A tree is made anew once this part of the triangles, or more, changed since it was made: one of so many.
constexpr std::size_t kMostChanged = 4;

std::array<Vec3, 3> cornersOf(const NavigationMesh& mesh, std::uint32_t t) {
  const Triangle& f = mesh.triangles[t];
  return {mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]};
}

bool containsInPlan(const std::array<Vec3, 3>& f, const Vec3& p) {
  return facing(f[0], f[1], p) >= 0 && facing(f[1], f[2], p) >= 0 && facing(f[2], f[0], p) >= 0;
}

/// Height of the plane over a place in the triangle; between those of its corners, whatever is rounded.
double heightAt(const std::array<Vec3, 3>& f, const Vec3& p) {
  for (const Vec3& corner : f)
    if (corner.x == p.x && corner.y == p.y) return corner.z;
  const double ux = f[1].x - f[0].x, uy = f[1].y - f[0].y, vx = f[2].x - f[0].x, vy = f[2].y - f[0].y;
  const double area = ux * vy - uy * vx, px = p.x - f[0].x, py = p.y - f[0].y;
  const double first = (px * vy - py * vx) / area, second = (ux * py - uy * px) / area;
  const double z = f[0].z + first * (f[1].z - f[0].z) + second * (f[2].z - f[0].z);
  const auto [low, high] = std::minmax({f[0].z, f[1].z, f[2].z});
  return z >= low && z <= high ? z : std::isnan(z) ? low : std::clamp(z, low, high);
}

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 along(const Vec3& a, const Vec3& u, double s) { return {a.x + s * u.x, a.y + s * u.y, a.z + s * u.z}; }

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5), rounded.
Vec3 nearestIn(const std::array<Vec3, 3>& f, const Vec3& p) {
  const Vec3 ab = minus(f[1], f[0]), ac = minus(f[2], f[0]);
  const Vec3 ap = minus(p, f[0]), bp = minus(p, f[1]), cp = minus(p, f[2]);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
               d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return f[0];
  if (d3 >= 0 && d4 <= d3) return f[1];
  if (d6 >= 0 && d5 <= d6) return f[2];
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(f[0], ab, d1 / (d1 - d3));
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(f[0], ac, d2 / (d2 - d6));
  if (va <= 0 && d4 >= d3 && d5 >= d6) return along(f[1], minus(f[2], f[1]), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
  return along(along(f[0], ab, vb / (va + vb + vc)), ac, vc / (va + vb + vc));
}

/// Moves a rounded point into the triangle, where it is not: towards the middle by steps that double, and to the
/// nearest corner where the triangle is too thin for that.
Vec3 moveInside(const std::array<Vec3, 3>& f, Vec3 p) {
  if (containsInPlan(f, p)) return p;
  const Vec3 middle{(f[0].x + f[1].x + f[2].x) / 3, (f[0].y + f[1].y + f[2].y) / 3, 0};
  for (double step = 0x1p-50; step <= 1; step *= 2) {
    const Vec3 moved{p.x + step * (middle.x - p.x), p.y + step * (middle.y - p.y), p.z};
    if (containsInPlan(f, moved)) return moved;
  }
  return *std::min_element(f.begin(), f.end(), [&](const Vec3& a, const Vec3& b) {
    return std::hypot(a.x - p.x, a.y - p.y) < std::hypot(b.x - p.x, b.y - p.y);
  });
}

/// Leaves out triangles that do not face up.
void buildTree(const NavigationMesh& mesh, const SurfaceTopology& topology, std::span<const std::uint32_t> triangles,
               TriangleTree& tree, Poll poll) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  boxes.reserve(triangles.size());
  ids.reserve(triangles.size());
  for (const std::uint32_t t : triangles) {
    if (topology.components[t] == SurfaceTopology::kNone) continue;
    const auto f = cornersOf(mesh, t);
    const auto [x0, x1] = std::minmax({f[0].x, f[1].x, f[2].x});
    const auto [y0, y1] = std::minmax({f[0].y, f[1].y, f[2].y});
    const auto [z0, z1] = std::minmax({f[0].z, f[1].z, f[2].z});
    boxes.push_back({{x0, y0, z0}, {x1, y1, z1}});
    ids.push_back(static_cast<std::int32_t>(t));
  }
  if (!boxes.empty()) tree.build(boxes, ids, poll);
}

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

PlaceIndex::PlaceIndex(const NavigationMesh& mesh, const SurfaceTopology& topology, Poll poll)
    : mesh_(mesh), topology_(topology) {
  build(poll);
}

PlaceIndex::PlaceIndex(const NavigationMesh& mesh, const SurfaceTopology& topology, const PlaceIndex& before,
                       const SurfaceRelation& relation, Poll poll)
    : mesh_(mesh), topology_(topology), tree_(before.tree_) {
  const std::size_t then = before.mesh_.triangles.size(), count = mesh.triangles.size();
  const bool isFirst = before.numberNow_.empty();
  numberNow_.assign(isFirst ? then : before.numberNow_.size(), kNoElement);
  std::vector<char> isInTree(count, 0);
  std::size_t gone = 0;
  for (std::size_t id = 0; id < numberNow_.size(); ++id) {
    const std::size_t old = isFirst ? id : before.numberNow_[id];
    const std::uint32_t now = old < then ? relation.triangleNow[old] : kNoElement;
    // Triangles behind those of the mesh are bridges, which are no places.
    if (now < count) {
      numberNow_[id] = now;
      isInTree[now] = 1;
    } else {
      ++gone;
    }
  }
  std::vector<std::uint32_t> others;
  for (std::uint32_t t = 0; t < count; ++t)
    if (isInTree[t] == 0) others.push_back(t);
  if ((gone + others.size()) * kMostChanged > count) {
    numberNow_.clear();
    build(poll);
    return;
  }
  buildTree(mesh_, topology_, others, added_, poll);
}

void PlaceIndex::build(Poll poll) {
  std::vector<std::uint32_t> all(mesh_.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  auto tree = std::make_shared<TriangleTree>();
  buildTree(mesh_, topology_, all, *tree, poll);
  tree_ = std::move(tree);
}

template <class Visit>
void PlaceIndex::visitAt(const Vec3& p, const Visit& visit) const {
  std::vector<std::int32_t> stack;
  const Box query{{p.x, p.y, -kInfinity}, {p.x, p.y, kInfinity}};
  tree_->visitOverlapping(query, stack, [&](std::int32_t id) {
    const std::uint32_t t = numberNow_.empty() ? static_cast<std::uint32_t>(id) : numberNow_[id];
    if (t != kNoElement) visit(t);
    return true;
  });
  added_.visitOverlapping(query, stack, [&](std::int32_t id) {
    visit(static_cast<std::uint32_t>(id));
    return true;
  });
}

std::optional<SurfacePlace> PlaceIndex::locate(const Vec3& p, double reach) const {
  std::optional<SurfacePlace> best;
  visitAt(p, [&](std::uint32_t t) {
    const auto f = cornersOf(mesh_, t);
    if (!containsInPlan(f, p)) return;
    const double z = heightAt(f, p);
    const double apart = std::fabs(z - p.z);
    if (apart > reach) return;
    if (!best || apart < best->distance || (apart == best->distance && t < best->triangle))
      best = SurfacePlace{{p.x, p.y, z}, t, apart};
  });
  return best;
}

std::optional<SurfacePlace> PlaceIndex::nearest(const Vec3& p, const std::vector<char>* components) const {
  std::optional<SurfacePlace> best;
  double least = kInfinity;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (topology_.components[t] == SurfaceTopology::kNone) continue;
    if (components != nullptr && (*components)[topology_.components[t]] == 0) continue;
    const auto f = cornersOf(mesh_, t);
    // Farther along one axis than the best in space: most triangles end here.
    const auto [x0, x1] = std::minmax({f[0].x, f[1].x, f[2].x});
    const auto [y0, y1] = std::minmax({f[0].y, f[1].y, f[2].y});
    if (p.x - x1 > least || x0 - p.x > least || p.y - y1 > least || y0 - p.y > least) continue;
    const Vec3 q = nearestIn(f, p);
    const double apart = distance(p, q);
    if (apart < least || !best) {
      least = std::min(least, apart);
      best = SurfacePlace{q, t, apart};
    }
  }
  if (best) best = nearestInside(p, best->triangle);
  return best;
}

SurfacePlace PlaceIndex::nearestInside(const Vec3& p, std::uint32_t triangle) const {
  const auto f = cornersOf(mesh_, triangle);
  SurfacePlace place{moveInside(f, nearestIn(f, p)), triangle, 0};
  place.position.z = heightAt(f, place.position);
  place.distance = distance(p, place.position);
  return place;
}

SurfacePlace PlaceIndex::placeInside(const Vec3& p, std::uint32_t triangle) const {
  const auto f = cornersOf(mesh_, triangle);
  SurfacePlace place{moveInside(f, p), triangle, 0};
  place.position.z = heightAt(f, place.position);
  return place;
}

}  // namespace footfall::detail
