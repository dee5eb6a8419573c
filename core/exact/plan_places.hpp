// Places of the plan in a source mesh, many of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/exact/source_mesh.hpp"

namespace footfall::detail {

/// The number in one mesh of each place that was added to another one, or -1. The grids of both have one scale. Numbers
/// rise: where places changed their order, some have none.
std::vector<Index> relatePlanPlaces(const SourceMesh& before, const SourceMesh& now);

/// addPlanPlaces() (core/exact/source_mesh.hpp) that can be cancelled; the mesh is no good then.
std::vector<Index> addPlanPlaces(SourceMesh& mesh, std::span<const Vec3> scaled, const Poll& poll);

}  // namespace footfall::detail
