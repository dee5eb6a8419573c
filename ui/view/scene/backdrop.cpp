// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "ui/view/geometry/surface_triangles.hpp"

namespace footfall::ui {
namespace {

constexpr double kWallNormalZ = 0.02;  // steeper surfaces are walls, as in environments that are loaded

std::array<double, 3> numbersOf(const Vec3& p) { return {p.x, p.y, p.z}; }

// Returns whether the ray can meet a triangle in the box of a piece.
bool meetsBox(const Ray& ray, const BackdropPiece& piece) {
  const std::array<double, 3> from = numbersOf(ray.origin), along = numbersOf(ray.direction);
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double lower = piece.lower[axis] - from[axis], upper = piece.upper[axis] - from[axis];
    if (along[axis] == 0) {
      if (lower > 0 || upper < 0) return false;
      continue;
    }
    const double a = lower / along[axis], b = upper / along[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last * (1 + 1e-6) + 1e-6;
}

// Finds the nearest of some triangles of a piece.
void meetTriangles(const Ray& ray, const BackdropPiece& piece, Backdrop::Range range, const ShownSpace& shown,
                   bool backs, std::optional<double>& nearest) {
  for (std::size_t t = range.first; t < range.first + range.second; ++t) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = piece.surface[3 * t + k].position;
      corners[k] = {p[0], p[1], p[2]};
    }
    const std::optional<double> met = meet(ray, corners);
    if (!met || (nearest && *met >= *nearest) || !shown.contains(pointOn(ray, *met))) continue;
    if (backs || meetsFront(ray, corners)) nearest = met;
  }
}

}  // namespace

void addBackdropTriangle(BackdropPiece& piece, const std::array<Vec3, 3>& corners, const Vec3& centre, bool bothSides) {
  const Vec3 normal = unitNormal(corners[0], corners[1], corners[2]);
  const double up = bothSides ? std::abs(normal.z) : normal.z;
  const bool isFirst = piece.surface.empty();
  addTriangle(piece.surface, {corners.data(), corners.data() + 1, corners.data() + 2}, centre, normal, wallPaint(),
              up > kWallNormalZ);
  if (isFirst) piece.lower = piece.upper = piece.surface.front().position;
  for (std::size_t v = piece.surface.size() - 3; v < piece.surface.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      piece.lower[axis] = std::min(piece.lower[axis], piece.surface[v].position[axis]);
      piece.upper[axis] = std::max(piece.upper[axis], piece.surface[v].position[axis]);
    }
  }
}

std::optional<double> meetBackdrop(const Ray& ray, const Backdrop& backdrop, const ShownSpace& shown, bool backs) {
  std::optional<double> nearest;
  if (backdrop.coarse && meetsBox(ray, *backdrop.coarse)) {
    for (const Backdrop::Range& range : backdrop.shownCoarse)
      meetTriangles(ray, *backdrop.coarse, range, shown, backs, nearest);
  }
  for (const BackdropPiecePtr& piece : backdrop.loaded)
    if (meetsBox(ray, *piece)) meetTriangles(ray, *piece, {0, piece->triangles()}, shown, backs, nearest);
  return nearest;
}

}  // namespace footfall::ui
