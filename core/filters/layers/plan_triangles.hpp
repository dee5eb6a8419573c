// The triangles of a mesh as the plan shows them, each in few places of memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/box_tree.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The box of a triangle in the plan.
BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& triangle);

/// Shared by all threads.
class PlanTriangles {
 public:
  /// The mesh must outlive this.
  PlanTriangles(const WalkableMesh& mesh, RunContext& context);

  [[nodiscard]] PlanTriangle planOf(Index triangle) const {
    return planTriangleOf(mesh_.triangles[static_cast<std::size_t>(triangle)],
                          [this](Index v) -> const PlanPlace& { return places_[static_cast<std::size_t>(v)]; });
  }
  [[nodiscard]] const BoxTree<2>::Bounds& boundsOf(Index triangle) const {
    return bounds_[static_cast<std::size_t>(triangle)];
  }

 private:
  const WalkableMesh& mesh_;
  std::vector<PlanPlace> places_;           ///< of the vertices
  std::vector<BoxTree<2>::Bounds> bounds_;  ///< of the triangles
};

}  // namespace footfall::detail
