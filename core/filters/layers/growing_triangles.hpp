// A growing set of triangles of a mesh, with the question which of them a triangle overlaps in the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The box of a triangle in the plan.
BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& triangle);

/// Triangles in trees, each more than twice as large as the next, and the last few in none: adding n triangles one by
/// one takes O(n log^2 n) steps.
class GrowingTriangles {
 public:
  explicit GrowingTriangles(const WalkableMesh& mesh) : mesh_(&mesh) {}

  void add(std::span<const Index> triangles, RunContext& context);
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Calls visit(other) for each triangle of the set whose box touches that of `triangle`, until it returns true.
  /// Returns whether it did.
  template <class Visit>
  bool visitUntil(const PlanTriangle& triangle, const Visit& visit) const {
    const Tree::Bounds bounds = planBoundsOf(triangle);
    bool found = false;
    for (const Tree& tree : trees_)
      if (!found) tree.visitOverlapping(bounds, [&](Index o) { found = found || visit(o); });
    for (const Few& other : few_) {
      if (found) break;
      const Tree::Bounds& b = other.bounds;
      if (b.lower[0] <= bounds.upper[0] && b.upper[0] >= bounds.lower[0] && b.lower[1] <= bounds.upper[1] &&
          b.upper[1] >= bounds.lower[1])
        found = visit(other.triangle);
    }
    return found;
  }

  /// Calls visit(triangle) for each triangle of the set.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const Tree& tree : trees_)
      for (Index place = 0; place < tree.size(); ++place) visit(tree.idAt(place));
    for (const Few& other : few_) visit(other.triangle);
  }

 private:
  using Tree = BoxTree<2>;
  struct Few {
    Index triangle = -1;
    Tree::Bounds bounds;
  };
  [[nodiscard]] Tree::Bounds boundsOf(Index triangle) const;

  const WalkableMesh* mesh_;
  std::vector<Tree> trees_;
  std::vector<Few> few_;
  std::size_t size_ = 0;
};

}  // namespace footfall::detail
