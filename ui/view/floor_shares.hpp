// Which floors of an environment the pieces of a result lie on.
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
  double area = 0;          ///< that they have in common
};

/// Every pair that has an area in common, in the order of the pieces. The source triangle of a piece is one of its
/// floors, and where triangles in one plane were joined to fewer, there are more. Of a picture's precision.
std::vector<FloorShare> floorsUnder(const NavigationMesh& mesh, const Environment& environment);

/// A floor that lies in one plane with another one, as copies of a floor do: pieces name one of them only.
struct DoubledFloor {
  std::uint32_t floor = 0;  ///< no piece names it
  std::uint32_t named = 0;  ///< some piece does
};

/// All pairs of floors that are doubled over half of their area or more. Of a picture's precision.
std::vector<DoubledFloor> doubledFloors(const std::vector<FloorShare>& shares, const Environment& environment);

}  // namespace footfall::ui
