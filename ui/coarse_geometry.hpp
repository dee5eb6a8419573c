// Fewer triangles that look alike from afar, for while the camera moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ui/render_geometry.hpp"

namespace footfall {

/// Above this many triangles, geometry brings a coarse surface along.
inline constexpr std::size_t kCoarseAbove = 150000;
/// About as many triangles as a coarse surface has.
inline constexpr std::size_t kCoarseAim = 25000;

/// Joins all corners within cells of a grid and leaves out triangles that have lost their area by it (Rossignac and
/// Borrel 1993); small things vanish. `kept` gets the numbers of the triangles that are left. Empty for surfaces that
/// are small enough.
std::vector<SurfaceVertex> coarsened(const std::vector<SurfaceVertex>& surface, std::vector<std::uint32_t>& kept);

}  // namespace footfall
