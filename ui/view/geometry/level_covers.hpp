// Finds the covers of a closed level: roofs and outer walls, which are hidden to look inside.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// Finds the triangles of a surface between a viewer outside, above the level, and floors inside of it. Finds none
/// where few floors are inside. `regions` numbers the connected coplanar triangles, which are covers together. It casts
/// lines of sight along a few dozen directions at every triangle, in parallel, with display precision.
std::vector<bool> findCovers(const std::vector<SurfaceVertex>& surface, const std::vector<std::uint32_t>& regions);

}  // namespace footfall::ui
