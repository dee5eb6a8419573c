// The walkable area as polygons with holes in the plan, for simulators and geographic programs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/plan_outline.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {

/// What hangs together in the plan of one layer.
struct PlanPolygon {
  std::uint32_t layer = 0;
  std::uint32_t part = 0;  ///< a place in NumberedParts
  PlanPart outline;
  double area = 0;  ///< of the surface, not of its plan; the square of the environment's unit
};

struct PlanPolygons {
  std::uint32_t layerCount = 1;  ///< 1 for a mesh without layers
  NumberedParts parts;
  std::vector<PlanPolygon> polygons;  ///< by layer, then by their first triangles
  /// Edges inside a polygon that cannot be crossed, by layer.
  std::vector<std::array<std::uint32_t, 2>> barriers;
};

/// Within a layer, triangles of one connected part that share an edge in the plan are one polygon, whatever their
/// heights: polygons have no slits. Polygons of different parts may share a border. `poll` may throw.
PlanPolygons makePlanPolygons(const NavigationMesh& mesh, Poll poll = {});

/// Throws InputError where `options` ask for a part that is not there, or a scale that is none (checkScale()).
void checkPolygonOptions(const NavigationMesh& mesh, const PlanPolygons& polygons, const ExportOptions& options);

}  // namespace footfall::detail
