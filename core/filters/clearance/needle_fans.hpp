// Finds the triangles that may stand above a needle of a fan, without a look at the other needles.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Needles that share a corner in the plan have boxes that overlap although hardly any two of the needles do: a disc of
// n of them has n^2 / 8 such pairs. Two triangles with a common corner overlap in the plan only where the angles
// overlap that they take up around it. So the triangles at a corner of many, at any height, are looked up by their
// angle, and all others in a tree without them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/exact/source_mesh.hpp"

namespace footfall::detail {

class NeedleFans {
 public:
  /// Null where no corner has enough needles. O(n), and O(n log n) where there are fans.
  static std::unique_ptr<const NeedleFans> find(const SourceMesh& mesh, const Poll& poll);

  /// True where visit() can replace a look into the mesh's tree.
  [[nodiscard]] bool contains(Index triangle) const { return fanOf_[triangle] >= 0; }

  /// Calls visit(id) for each triangle that may overlap both `box` and, in the plan, a triangle of a fan; for each at
  /// most once, and perhaps for some that overlap neither. visit returns false to stop.
  template <class Visit>
  void visit(Index triangle, const Box& box, std::vector<std::int32_t>& stack, const Visit& visit) const {
    bool goesOn = true;
    const auto take = [&](std::int32_t id) { return goesOn = goesOn && visit(id); };
    rest_.visitOverlapping(box, stack, take);
    for (std::size_t i = 0; goesOn && i < fans_.size(); ++i) {
      const Fan& fan = fans_[i];
      if (fanOf_[triangle] != static_cast<std::int32_t>(i)) {
        fan.byBox.visitOverlapping(box, stack, take);
        continue;
      }
      const Angles own = anglesAt(fan.corner, triangle);
      for (const double turn : {-kTurn, 0.0, kTurn})
        fan.byAngle.visitOverlapping(
            {{own.first + turn - kSlack, box.lower[2]}, {own.last + turn + kSlack, box.upper[2]}},
            [&](Index id) { take(id); });
    }
  }

 private:
  /// The angles that a triangle takes up at a corner, `first` from 0 up to a turn.
  struct Angles {
    double first = 0, last = 0;
  };
  struct Fan {
    Index corner = -1;   ///< plan id
    BoxTree<2> byAngle;  ///< angle and height
    TriangleTree byBox;
  };
  static constexpr double kTurn = 6.283185307179586;
  /// More than angles are rounded by, which is some 2^-50. Triangles that only touch are visited in vain.
  static constexpr double kSlack = 0x1p-40;

  NeedleFans(const SourceMesh& mesh, std::vector<std::int32_t> fanOf, std::vector<Index> corners, const Poll& poll);
  static Angles anglesAt(const SourceMesh& mesh, Index corner, Index triangle);
  [[nodiscard]] Angles anglesAt(Index corner, Index triangle) const { return anglesAt(mesh_, corner, triangle); }

  const SourceMesh& mesh_;
  std::vector<std::int32_t> fanOf_;  ///< of each triangle; -1: it is in `rest_`
  std::vector<Fan> fans_;
  TriangleTree rest_;
};

}  // namespace footfall::detail
