// Exact decisions on the vertices of a walkable mesh, seen in the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// A triangle as the plan shows it, with all that a first look needs in one place.
struct PlanTriangle {
  std::array<Index, 3> corners{};
  std::array<double, 3> x{}, y{};
  double error = 0;      ///< error of each coordinate
  bool isSource = true;  ///< all corners are source vertices
};

/// The part of a vertex that a PlanTriangle holds.
struct PlanPlace {
  double x = 0, y = 0, error = 0;
  bool isSource = false;
};
inline PlanPlace planPlaceOf(const MeshVertex& v) { return {v.x, v.y, v.error, v.source >= 0}; }

/// `placeOf(v)` gives those of the corners.
template <class PlaceOf>
PlanTriangle planTriangleOf(const MeshTriangle& triangle, PlaceOf placeOf) {
  PlanTriangle result{triangle.corners, {}, {}, 0, true};
  for (int k = 0; k < 3; ++k) {
    const PlanPlace& place = placeOf(triangle.corners[k]);
    result.x[k] = place.x;
    result.y[k] = place.y;
    result.error = std::max(result.error, place.error);
    result.isSource = result.isSource && place.isSource;
  }
  return result;
}
PlanTriangle planTriangleOf(const std::vector<MeshVertex>& vertices, const MeshTriangle& triangle);

/// Predicates on the vertices of a walkable mesh. Not for sharing between threads: it counts fall-backs.
class MeshGeometry {
 public:
  MeshGeometry(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices)
      : kernel_(kernel), vertices_(vertices) {}

  /// Orientation of three vertices in the plan.
  int orientation(Index a, Index b, Index c);
  /// Compares x (axis 0) or y (axis 1).
  int compare(Index a, Index b, int axis);
  /// The same of two vertices wherever they are kept.
  int compare(const MeshVertex& a, const MeshVertex& b, int axis);
  /// True when v lies strictly between u and w on one line in the plan.
  bool isBetween(Index u, Index v, Index w);
  /// True when the insides of two triangles that face up overlap in the plan.
  bool overlap(const PlanTriangle& s, const PlanTriangle& t);

  ExactFallbacks fallbacks;

 private:
  /// The orientation by rounded coordinates.
  [[nodiscard]] MaybeSign filtered(Index a, Index b, Index c) const;
  int doubtfulOrientation(Index a, Index b, Index c);
  /// The line of the source edge on which an EdgePlane point lies.
  [[nodiscard]] PlanLine edgeOf(const PlanPoint& p) const;
  /// The point lies on the line (taken on `face`) by what it is.
  [[nodiscard]] bool isKnownOn(const PlanLine& line, Index face, const PlanPoint& p) const;
  [[nodiscard]] Index origin(Index vertex) const;

  const PlanKernel& kernel_;
  const std::vector<MeshVertex>& vertices_;
};

}  // namespace footfall::detail
