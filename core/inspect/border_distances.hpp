// The distance of a place of the walkable area from walls and from ledges (model, Margins).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/radius/border_pieces.hpp"

namespace footfall::detail {

/// Measures on the mesh of one state, in doubles. What is wall and what is ledge is decided exactly. Immutable.
class BorderDistances {
 public:
  /// The state must have a mesh.
  BorderDistances(const WalkableState& state, RunContext& context);

  struct Nearest {
    std::optional<double> wall, ledge;  ///< environment units; empty where there is none
  };
  /// The least lengths, in the plan, of straight walks from a place on a triangle of the mesh; walks that bend
  /// (core/filters/radius/bent_margins.hpp) are not looked for. `x` and `y` in the environment's units.
  [[nodiscard]] Nearest at(Index triangle, double x, double y, RunContext& context) const;

  [[nodiscard]] const WalkableState& state() const { return state_; }

 private:
  /// True when a straight way leads from a place on a triangle to a place on another one. Places on borders count as
  /// inside.
  [[nodiscard]] bool leadsTo(Index triangle, const PlanVector& from, Index goal, const PlanVector& to) const;

  WalkableState state_;
  MarginSurface surface_;
};

}  // namespace footfall::detail
