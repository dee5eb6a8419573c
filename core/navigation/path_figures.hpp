// Figures of a path over a mesh, and its pieces over gaps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "footfall/path.hpp"

namespace footfall::detail {

/// Adds lengths, heights, layers and slopes to a path that has its points, triangles, bends, steps and gaps.
void addFigures(const NavigationMesh& mesh, PathResult& result);

/// Makes one piece of each way over a gap, from its last bend on, that belongs to the triangle where it arrives.
/// Triangles from `triangleCount` on are bridges over gaps.
void joinGaps(std::uint32_t triangleCount, PathResult& result);

}  // namespace footfall::detail
