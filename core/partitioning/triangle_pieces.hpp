// Triangles and what cuts leave of them, as the recursive strategies count them (thesis 4.3.2, 4.3.3).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only a count that chooses where to cut: rounded coordinates are good enough, and always finite.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/partitioning/partition_builder.hpp"

namespace footfall {

/// A triangle, or the convex part of one that lies in a node of the tree of cuts.
struct TrianglePiece {
  PlanBox box;
  Index triangle = -1;
  Index firstCorner = -1;  ///< in TrianglePieces::corners; -1: the whole triangle
  Index cornerCount = 0;
};

/// What lies in one node of the tree of cuts.
struct TrianglePieces {
  using Point = std::array<double, 2>;
  std::vector<TrianglePiece> pieces;
  std::vector<Point> corners;

  /// All triangles that are not removed.
  static TrianglePieces of(const StrategyInput& input);

  [[nodiscard]] std::size_t size() const { return pieces.size(); }
  /// Divides the pieces at a border. As in the thesis, what lies on the border and nowhere above it is below.
  [[nodiscard]] std::array<TrianglePieces, 2> split(int axis, double coordinate, const StrategyInput& input) const;

 private:
  void add(const TrianglePiece& piece, const TrianglePieces& from);
  void add(Index triangle, std::span<const Point> outline);
};

}  // namespace footfall
