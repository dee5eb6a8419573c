// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/plan_column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// All triangles whose boxes touch the vertical line; sorted, as the tree's order must not show.
std::vector<Index> candidatesAt(const SourceMesh& mesh, const mpq_class& x, const mpq_class& y) {
  // get_d() cuts digits off: the place is at most one double farther out.
  const auto around = [](const mpq_class& value) {
    const double cut = value.get_d();
    return std::array{std::nextafter(cut, -kInfinity), std::nextafter(cut, kInfinity)};
  };
  const auto [x0, x1] = around(x);
  const auto [y0, y1] = around(y);
  std::vector<Index> found;
  std::vector<std::int32_t> stack;
  mesh.tree.visitOverlapping({{x0, y0, -kInfinity}, {x1, y1, kInfinity}}, stack, [&](Index face) {
    found.push_back(face);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

/// A corner of a wall and its height over the floor's plane.
struct WallCorner {
  mpq_class x, y, height;
};

/// Clips a convex outline to where `keep`, which is linear, is at least 0.
template <class Keep>
std::vector<WallCorner> clipped(const std::vector<WallCorner>& outline, const Keep& keep) {
  std::vector<WallCorner> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const WallCorner &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const mpq_class vp = keep(p), vq = keep(q);
    if (vp >= 0) kept.push_back(p);
    if ((vp > 0 && vq < 0) || (vp < 0 && vq > 0)) {
      const mpq_class s = vp / (vp - vq);
      kept.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.height + s * (q.height - p.height)});
    }
  }
  return kept;
}

bool standsAt(const std::array<ExactPoint, 3>& wall, const mpq_class& x, const mpq_class& y,
              const std::array<ExactPoint, 3>& floor, const mpq_class& clearance) {
  // Quickly: in the plan it is a line.
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactPoint &a = wall[k], &b = wall[(k + 1) % 3];
    if ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) != 0) return false;
  }
  std::vector<WallCorner> outline;
  for (const ExactPoint& p : wall) {
    const auto below = GenericPlace(p[0], p[1], p[0], p[1]).heightOf(floor);
    outline.push_back({p[0], p[1], p[2] - below->value});
  }
  outline = clipped(outline, [](const WallCorner& c) { return c.height; });
  outline = clipped(outline, [&](const WallCorner& c) { return mpq_class(clearance - c.height); });
  const auto allAt = [&](const mpq_class& height) {
    return std::all_of(outline.begin(), outline.end(), [&](const WallCorner& c) { return c.height == height; });
  };
  if (outline.empty() || allAt(0) || allAt(clearance)) return false;
  const auto before = [](const WallCorner& p, const WallCorner& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
  const auto [first, last] = std::minmax_element(outline.begin(), outline.end(), before);
  if (first->x == last->x && first->y == last->y) return false;
  const WallCorner here{x, y, 0};
  return !before(here, *first) && !before(*last, here);
}

bool isUnder(const std::array<ExactPoint, 3>& corners, const mpq_class& x, const mpq_class& y) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactPoint &a = corners[k], &b = corners[(k + 1) % 3];
    const mpq_class side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    left += static_cast<int>(side > 0);
    right += static_cast<int>(side < 0);
  }
  return left == 0 || right == 0;
}

}  // namespace

std::array<ExactPoint, 3> cornersOf(const SourceMesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return {exactPoint(mesh.vertices[a]), exactPoint(mesh.vertices[b]), exactPoint(mesh.vertices[c])};
}

std::vector<ColumnFace> facesAt(const SourceMesh& mesh, const GenericPlace& place) {
  std::vector<ColumnFace> column;
  for (const Index face : candidatesAt(mesh, place.x(), place.y())) {
    if (mesh.facing[face] == 0) continue;
    const auto corners = cornersOf(mesh, face);
    if (place.isInside(corners)) column.push_back({face, *place.heightOf(corners)});
  }
  return column;
}

const ColumnFace* lowestAbove(const SourceMesh& mesh, const std::vector<ColumnFace>& column,
                              const GenericNumber& height) {
  const ColumnFace* lowest = nullptr;
  for (const ColumnFace& candidate : column) {
    if ((candidate.height - height).sign() <= 0) continue;
    const int order = lowest == nullptr ? -1 : (candidate.height - lowest->height).sign();
    if (order < 0 || (order == 0 && mesh.inputTriangles[candidate.face] < mesh.inputTriangles[lowest->face]))
      lowest = &candidate;
  }
  return lowest;
}

std::vector<Index> wallsAt(const SourceMesh& mesh, const mpq_class& x, const mpq_class& y,
                           const std::array<ExactPoint, 3>& floor, const mpq_class& clearance) {
  std::vector<Index> walls;
  for (const Index face : candidatesAt(mesh, x, y))
    if (mesh.facing[face] == 0 && mesh.degenerate[face] == 0 && standsAt(cornersOf(mesh, face), x, y, floor, clearance))
      walls.push_back(face);
  return walls;
}

std::vector<Index> highestBelow(const SourceMesh& mesh, const Vec3& point, double reach) {
  const mpq_class x(point.x), y(point.y), ceiling = mpq_class(point.z) + mpq_class(reach);
  const GenericPlace place(x, y, x, y);
  std::vector<Index> highest;
  mpq_class best;
  for (const Index face : candidatesAt(mesh, x, y)) {
    if (mesh.facing[face] == 0) continue;
    const auto corners = cornersOf(mesh, face);
    if (!isUnder(corners, x, y)) continue;
    const mpq_class height = place.heightOf(corners)->value;
    if (height > ceiling || (!highest.empty() && height < best)) continue;
    if (highest.empty() || height > best) highest.clear();
    best = height;
    highest.push_back(face);
  }
  return highest;
}

}  // namespace footfall::detail
