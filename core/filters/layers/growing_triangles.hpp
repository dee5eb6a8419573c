// A growing set of triangles of a mesh, with the question which of them a triangle overlaps in the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/filters/layers/growing_boxes.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The box of a triangle in the plan.
BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& triangle);

class GrowingTriangles {
 public:
  explicit GrowingTriangles(const WalkableMesh& mesh) : mesh_(&mesh) {}

  void add(std::span<const Index> triangles, RunContext& context);
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Calls visit(other) for each triangle of the set whose box touches that of `triangle`, until it returns true.
  /// Returns whether it did.
  template <class Visit>
  bool visitUntil(const PlanTriangle& triangle, const Visit& visit) const {
    return boxes_.visitUntil(planBoundsOf(triangle), visit);
  }

  /// Calls visit(triangle) for each triangle of the set.
  template <class Visit>
  void forEach(const Visit& visit) const {
    boxes_.forEach(visit);
  }

 private:
  const WalkableMesh* mesh_;
  GrowingBoxes boxes_;
  std::size_t size_ = 0;
};

}  // namespace footfall::detail
