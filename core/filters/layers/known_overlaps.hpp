// Layers from known pairs of triangles that lie above one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh_topology.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The layer that LayerSubdivisionFilter gives each triangle. `overlaps` are all pairs of triangles that overlap in the
/// plan, each once, in any order; only `z` of vertices is read.
std::vector<std::uint32_t> layersOf(const WalkableMesh& mesh, const Adjacency& topology,
                                    std::vector<std::array<Index, 2>> overlaps, RunContext& context);

}  // namespace footfall::detail
