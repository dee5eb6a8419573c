// The border of a surface, divided into walls and ledges (model, Walls and ledges).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/filters/radius/margin_surface.hpp"
#include "core/filters/steps/border_kinds.hpp"

namespace footfall::detail {

/// A border side, or a part of one.
struct BorderPiece {
  Index side = -1;
  PlanVector begin, end;
  bool isLedge = false;
  double error = 0;  ///< error of ends that are no vertices; scaled
};

/// Whole sides, ascending, of unknown kind.
std::vector<BorderPiece> wholeBorders(const MarginSurface& surface);

/// Divides borders of a state that has a mesh. Not for sharing between threads.
class BorderDivider {
 public:
  /// The state's kernel must be kernelForKinds(). Where a wall ends within a side doubles say only to within
  /// BorderPiece::error, and what is in doubt counts as ledge (`isLedgeInDoubt`) or as wall.
  BorderDivider(const WalkableState& state, const MarginSurface& surface, bool isLedgeInDoubt);

  /// Adds the pieces of a border side, in order along it.
  void divide(Index side, std::vector<BorderPiece>& pieces);
  [[nodiscard]] const ExactFallbacks& fallbacks() { return kinds_.signs().fallbacks; }

 private:
  const WalkableMesh& mesh_;
  const MarginSurface& surface_;
  bool isLedgeInDoubt_;
  double reach_ = 0;  ///< the distance on the far side within which a wall stands at the border; scaled
  BorderKinds kinds_;
};

/// All pieces, by side and then along it.
std::vector<BorderPiece> dividedBorders(const WalkableState& state, const MarginSurface& surface, bool isLedgeInDoubt,
                                        RunContext& context, ExactFallbacks& fallbacks);

/// The state's kernel, or one that has as levels the heights by which walls and ledges differ: the state's step and its
/// clearance, or a height above everything where it has none.
std::shared_ptr<const PlanKernel> kernelForKinds(const WalkableState& state);

}  // namespace footfall::detail
