// Finds sides that a triangle may touch in the plan, however large the boxes around needles are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/base/poll.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// A tree of sides of triangles. A look-up compares boxes of the tree with the three sides of a triangle and not with
/// its box alone, which for a needle is far larger. Long sides are cut into pieces, each with a box of its own.
class BorderSides {
 public:
  using Tree = BoxTree<2>;
  /// A side between two rounded places of the plan.
  struct Side {
    Index triangle = -1;
    std::array<double, 2> begin{}, end{};
    double error = 0;  ///< that of each coordinate
  };

  void build(const std::vector<Side>& sides, Poll poll);

  /// Calls visit(triangle) for each piece of a side that `triangle`, which faces up, may touch: once or more for each
  /// triangle with such a side.
  template <class Visit>
  void visitNear(const PlanTriangle& triangle, const Tree::Bounds& bounds, const Visit& visit) const {
    const Outside outside(triangle, tree_.centre(), extent_);
    tree_.visitWhere(bounds, outside, [&](Index piece) { visit(triangleOf_[static_cast<std::size_t>(piece)]); });
  }

 private:
  /// Leaves out boxes that certainly lie beyond a side of the triangle.
  class Outside {
   public:
    Outside(const PlanTriangle& triangle, const std::array<double, 2>& centre, double extent);

    /// The lanes of the boxes that may touch the triangle.
    Int4 operator()(const std::array<Float4, 2>& lower, const std::array<Float4, 2>& upper) const {
      Int4 lanes = ~Int4{};
      for (const Line& line : lines_) {
        // The corner of each box that is furthest on the left of the side.
        const Float4 x = line.uy > 0 ? lower[0] : upper[0], y = line.ux > 0 ? upper[1] : lower[1];
        lanes &= ~Int4(line.ux * y - line.uy * x - line.start < -line.bound);
      }
      return lanes;
    }

   private:
    /// A point p is beyond the line where ux y(p) - uy x(p) - start is below -bound.
    struct Line {
      float ux = 0, uy = 0, start = 0, bound = 0;
    };
    std::array<Line, 3> lines_{};  ///< all zero: no box is left out
  };

  Tree tree_;
  double extent_ = 0;              ///< largest finite coordinate of a box from the tree's centre on
  std::vector<Index> triangleOf_;  ///< of each piece
};

}  // namespace footfall::detail
