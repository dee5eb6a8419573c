// The walkable area as polygons with holes, seen from above, for programs that compute with polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "footfall/geometry.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// A connected region in the plan of one layer.
struct PlanArea {
  std::uint32_t layer = 0;               ///< 0 for a mesh without layers
  std::uint32_t part = 0;                ///< connected part, numbered as findComponents() does
  std::vector<Vec3> outer;               ///< counter-clockwise seen from above, the first place not repeated
  std::vector<std::vector<Vec3>> holes;  ///< clockwise
  double area = 0;                       ///< of the surface, not of its plan; the square of the environment's unit
};

/// The polygons of a .wkt export, in the environment's units and with Z up: by layer, then by their first triangles.
/// Triangles of one part and one layer that share an edge in the plan are one polygon, so that obstacle edges inside
/// are not seen. With `part`, only those of that connected part. Throws InputError for a part that is not there, and
/// Cancelled.
std::vector<PlanArea> planAreas(const NavigationMesh& mesh, std::optional<std::uint32_t> part = std::nullopt,
                                const RunContext* context = nullptr);

}  // namespace footfall
