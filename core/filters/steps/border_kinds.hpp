// Walls and ledges: what stands at a border of the walkable area (design section 7).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/filters/steps/edge_region.hpp"
#include "core/filters/steps/edge_signs.hpp"

namespace footfall::detail {

/// A triangle of the environment, which is not vertical, near an edge of the border. Where its signs change is known by
/// BorderKinds::locate().
struct CoverAlong {
  Index triangle = -1;
  std::array<SignAlong, 3> inside{};  ///< of its sides; zero where the edge lies along one of them
  bool isOutside = true;  ///< it has an inside in the limit on the far side, where all of `inside` are positive
  SignAlong overStep{}, underHeight{};  ///< over the border, raised by the step and by the height

  /// Some of it is over the step, and some under the height.
  [[nodiscard]] bool mayBeWall() const {
    return (overStep.begin > 0 || overStep.end > 0) && (underHeight.begin < 0 || underHeight.end < 0);
  }
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

  /// Turns to an edge, and looks at what is near it, from its lowest point on. Its ends must differ in the plan.
  /// `begin` and `end` are its rounded ends, scaled.
  void turnTo(const BorderEdge& edge, const Vec3& begin, const Vec3& end);

  // Of the edge that it turned to:
  [[nodiscard]] std::vector<EdgePiece> ledges() {
    return ledges([](const CoverAlong&) { return false; });
  }
  /// The same without the covers that are left out, of which only the signs at both ends are looked at.
  template <class IsLeftOut>
  [[nodiscard]] std::vector<EdgePiece> ledges(const IsLeftOut& isLeftOut) {
    std::vector<std::size_t> covers;
    for (std::size_t i = 0; i < covers_.size(); ++i)
      if (covers_[i].mayBeWall() && !isLeftOut(covers_[i])) covers.push_back(i);
    return ledgesWithout(covers);
  }
  /// Looks at what is near it and lower as well, from `below` (scaled, at least 0) under its lowest point on. Only for
  /// covers(), from then on.
  void lookBelow(double below);
  [[nodiscard]] const std::vector<CoverAlong>& covers() const { return covers_; }
  /// One of covers(), with all that its signs know.
  const CoverAlong& locate(std::size_t cover);
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
  void sortCovers();
  void addCover(Index triangle);
  void addWall(Index triangle);
  [[nodiscard]] std::vector<EdgePiece> ledgesWithout(const std::vector<std::size_t>& covers);

  const PlanKernel& kernel_;
  const std::vector<char>& removed_;
  Index step_, height_;
  double largest_ = 0;
  EdgeSigns signs_;
  BorderEdge edge_;
  EdgeFrame frame_;
  Box near_;  ///< of the edge and what is over it
  std::vector<CoverAlong> covers_;
  std::vector<EdgePiece> walls_;  ///< upright, along the edge
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
