// Finds the floors of an environment that the pieces of a result lie on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::ui {

struct FloorShare {
  std::uint32_t piece = 0;  ///< triangle of the mesh
  std::uint32_t floor = 0;  ///< triangle of the environment under it
  double area = 0;          ///< area that they have in common
};

/// Every pair that has an area in common, in the order of the pieces. The source triangle of a piece is one of its
/// floors; there are more where coplanar triangles were joined. It has display precision.
std::vector<FloorShare> floorsUnder(const NavigationMesh& mesh, const Environment& environment);

/// A floor that is coplanar with another one and overlaps it, such as a copy of a floor; pieces name only one of them.
struct DoubledFloor {
  std::uint32_t floor = 0;  ///< no piece names it
  std::uint32_t named = 0;  ///< some piece names it
};

/// All pairs of floors that overlap in half of their area or more. It has display precision.
std::vector<DoubledFloor> doubledFloors(const std::vector<FloorShare>& shares, const Environment& environment);

}  // namespace footfall::ui
