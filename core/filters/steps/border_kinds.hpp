// Walls and ledges: what stands at a border of the walkable area (design section 7).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/filters/steps/edge_region.hpp"
#include "core/filters/steps/edge_signs.hpp"

namespace footfall::detail {

/// A triangle of the environment, which is not vertical, near an edge of the border.
struct CoverAlong {
  Index triangle = -1;
  std::array<SignAlong, 3> inside{};  ///< of its sides; zero where the edge lies along one of them
  bool isOutside = true;  ///< it has an inside in the limit on the far side, where all of `inside` are positive
  SignAlong overStep{}, underHeight{};  ///< over the border, raised by the step and by the height

  /// The border is under or over the triangle, its outline included.
  [[nodiscard]] bool covers(const EdgePiece& piece) const;
};

/// A border point is at a wall when the environment reaches into the heights (z + step, z + height) straight over it or
/// in the limit on its far side, else it is at a ledge. Single points do not count.
///
/// Decided exactly, by the signs at the edge's ends; pieces end a little inside (edge_signs.hpp). Ends where an upright
/// wall ends that stands along the edge are rounded so that the wall is not smaller.
class BorderKinds {
 public:
  /// `step` and `height` are levels of the kernel; a step of 0 is level 0. `removed`: for each source triangle, it is
  /// out of the environment. All must outlive it. Not for sharing between threads.
  BorderKinds(const PlanKernel& kernel, const std::vector<char>& removed, Index step, Index height);

  /// Turns to an edge, and looks at what is near it, from `below` (scaled, at least 0) under its lowest point on. Its
  /// ends must differ in the plan. `begin` and `end` are its rounded ends, scaled.
  void turnTo(const BorderEdge& edge, const Vec3& begin, const Vec3& end, double below);

  // Of the edge that it turned to:
  [[nodiscard]] std::vector<EdgePiece> ledges();
  [[nodiscard]] const std::vector<CoverAlong>& covers() const { return covers_; }
  [[nodiscard]] const BorderEdge& edge() const { return edge_; }
  [[nodiscard]] const EdgeFrame& frame() const { return frame_; }

  EdgeSigns& signs() { return signs_; }
  [[nodiscard]] const PlanKernel& kernel() const { return kernel_; }
  /// The height of a level, scaled.
  [[nodiscard]] double heightOf(Index level) const;
  [[nodiscard]] Index stepLevel() const { return step_; }
  [[nodiscard]] Index heightLevel() const { return height_; }
  /// Calls visit(triangle) for what may be in a box, scaled, vertical triangles among it.
  template <class Visit>
  void visitNear(Box box, const Visit& visit) {
    widen(box);
    kernel_.mesh().tree.visitOverlapping(box, stack_, [&](Index t) {
      if (removed_[t] == 0) visit(t);
      return true;
    });
  }
  [[nodiscard]] std::array<Vec3, 3> cornersOf(Index triangle) const;
  /// No corner is higher than the border raised by a level, or lower (`sign`: 1 or -1). Exact on level floors; else it
  /// may say no.
  [[nodiscard]] bool isKnownBeside(Index triangle, Index level, int sign);

 private:
  void widen(Box& box) const;
  void addCover(Index triangle);
  void addWall(Index triangle);

  const PlanKernel& kernel_;
  const std::vector<char>& removed_;
  Index step_, height_;
  double largest_ = 0;
  EdgeSigns signs_;
  BorderEdge edge_;
  EdgeFrame frame_;
  std::vector<CoverAlong> covers_;
  std::vector<EdgePiece> walls_;  ///< upright, along the edge
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
