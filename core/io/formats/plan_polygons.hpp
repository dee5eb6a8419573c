// The walkable area as polygons with holes in the plan, for simulators and geographic programs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/plan_outline.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {

/// A connected region in the plan of one layer.
struct PlanPolygon {
  std::uint32_t layer = 0;
  std::uint32_t part = 0;  ///< a place in NumberedParts
  PlanPart outline;
  double area = 0;  ///< area of the surface, not of its plan, in square units of the environment
};

struct PlanPolygons {
  std::uint32_t layerCount = 1;  ///< 1 for a mesh without layers
  NumberedParts parts;
  std::vector<PlanPolygon> polygons;  ///< ordered by layer, then by their first triangles
  /// Edges inside a polygon that agents cannot cross, by layer.
  std::vector<std::array<std::uint32_t, 2>> barriers;
};

/// Within a layer, triangles of one connected part that share an edge in the plan belong to one polygon, whatever their
/// heights, so polygons have no slits. Polygons of different parts may share a border. `poll` may throw.
PlanPolygons makePlanPolygons(const NavigationMesh& mesh, Poll poll = {});

/// Throws InputError where `options` name a part that does not exist, or an invalid scale (checkScale()).
void checkPolygonOptions(const NavigationMesh& mesh, const PlanPolygons& polygons, const ExportOptions& options);

}  // namespace footfall::detail
