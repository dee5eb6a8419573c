// Stairs of a walkable area as an architect draws them: one arrow up each flight.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/report/plan_walls.hpp"

namespace footfall::detail {

/// One riser after the other, upwards.
struct PlanFlight {
  struct Riser {
    PlanPlace middle{};
    PlanPlace up{};                      ///< one unit long, from the lower side to the upper one
    double length = 0;                   ///< length in the plan
    std::uint32_t lower = 0, upper = 0;  ///< a triangle of the mesh on each side
  };
  std::vector<Riser> risers;
};

/// Steps (not gaps) that are in a row or nearly so are one riser. A riser leads on to another one when the tread
/// between them has no longer way down and no longer way up, and is no longer than `longestTread`. Flights and risers
/// are in an order that depends on the mesh alone. `poll` may throw.
std::vector<PlanFlight> findFlights(const NavigationMesh& mesh, double longestTread, Poll poll = {});

}  // namespace footfall::detail
