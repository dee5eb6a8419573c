// Classifies the borders of the walkable area as walls and ledges (model, Walls and ledges).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/filters/steps/edge_region.hpp"
#include "core/filters/steps/edge_signs.hpp"

namespace footfall::detail {

/// The places along an edge between which a triangle lies, and the heights (scaled); roundings may make them smaller.
struct EdgeExtent {
  double first = 0, last = 0, lowest = 0, highest = 0;
};

/// A triangle of the environment, which is not vertical, near an edge of the border. BorderKinds::locate() finds where
/// its signs change.
struct CoverAlong {
  Index triangle = -1;
  std::array<SignAlong, 3> inside{};  ///< sides of the triangle; zero where the edge lies along one of them
  /// the triangle reaches the far side of the edge in the limit, where all of `inside` are positive
  bool isOutside = true;
  /// over the border raised by the step, and under the border raised by the height
  SignAlong overStep{}, underHeight{};
  EdgeExtent extent{};

  /// Returns whether some of it is over the step, and some under the height.
  [[nodiscard]] bool mayBeWall() const {
    return (overStep.begin > 0 || overStep.end > 0) && (underHeight.begin < 0 || underHeight.end < 0);
  }
  /// Returns whether the border is under or over the triangle, its outline included.
  [[nodiscard]] bool covers(const EdgePiece& piece) const;
};

/// A border point is at a wall when the environment reaches into the heights (z + step, z + height) straight over it or
/// in the limit on its far side; otherwise it is at a ledge. Single points do not count.
///
/// The decision is exact, by signs at the edge's ends; pieces end a little inside (edge_signs.hpp). Ends of upright
/// walls along the edge are rounded so that the wall is not smaller.
class BorderKinds {
 public:
  /// `step` and `height` are levels of the kernel; a step of 0 is level 0. `removed` has an entry for each source
  /// triangle, true where it is out of the environment. All arguments must outlive this object. Threads cannot share
  /// it.
  BorderKinds(const PlanKernel& kernel, const std::vector<char>& removed, Index step, Index height);

  /// Sets the current edge, and finds the obstacles near it from its lowest point upwards. Its ends must differ in the
  /// plan. `begin` and `end` are its rounded ends, scaled.
  void turnTo(const BorderEdge& edge, const Vec3& begin, const Vec3& end);

  // The ledges of the current edge.
  [[nodiscard]] std::vector<EdgePiece> ledges() {
    return ledges([](const CoverAlong&) { return false; });
  }
  /// The ledges without the covers that are left out; only the signs of those covers at both ends are computed.
  template <class IsLeftOut>
  [[nodiscard]] std::vector<EdgePiece> ledges(const IsLeftOut& isLeftOut) {
    std::vector<std::size_t> covers;
    for (std::size_t i = 0; i < covers_.size(); ++i)
      if (covers_[i].mayBeWall() && !isLeftOut(covers_[i])) covers.push_back(i);
    return ledgesWithout(covers);
  }
  /// Also finds the obstacles that are up to `below` (scaled, at least 0) under the lowest point of the edge. They
  /// appear in covers() only.
  void lookBelow(double below);
  [[nodiscard]] const std::vector<CoverAlong>& covers() const { return covers_; }
  /// Returns one of covers() after locating all its signs.
  const CoverAlong& locate(std::size_t cover);
  [[nodiscard]] const BorderEdge& edge() const { return edge_; }
  [[nodiscard]] const EdgeFrame& frame() const { return frame_; }

  EdgeSigns& signs() { return signs_; }
  [[nodiscard]] const PlanKernel& kernel() const { return kernel_; }
  /// The height of a level, scaled.
  [[nodiscard]] double heightOf(Index level) const;
  [[nodiscard]] Index stepLevel() const { return step_; }
  [[nodiscard]] Index heightLevel() const { return height_; }
  /// Calls visit(triangle) for all triangles whose boxes overlap a box (scaled), including vertical ones. The tree may
  /// find more, which depend on how it was built.
  template <class Visit>
  void visitNear(Box box, const Visit& visit) {
    widen(box);
    kernel_.mesh().tree.visitOverlapping(box, stack_, [&](Index t) {
      if (removed_[t] == 0 && overlap(boxOf(kernel_.mesh(), t), box)) visit(t);
      return true;
    });
  }
  [[nodiscard]] std::array<Vec3, 3> cornersOf(Index triangle) const;
  [[nodiscard]] EdgeExtent extentOf(const std::array<Vec3, 3>& corners) const;
  /// Returns false only where a triangle is nowhere over another one, at any place over the edge.
  [[nodiscard]] bool mayBeOver(const EdgeExtent& triangle, const EdgeExtent& other) const;
  /// Returns whether no corner is higher than the border raised by a level (`sign` 1), or lower (`sign` -1). The answer
  /// is exact on level floors; elsewhere it may be falsely negative.
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
  Box near_;  ///< box around the edge and the space over it
  std::vector<CoverAlong> covers_;
  std::vector<EdgePiece> walls_;  ///< upright walls along the edge
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
