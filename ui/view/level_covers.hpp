// What closes a level: roofs and outer walls, which one takes away to look inside.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// Finds the triangles of a surface that stand between somebody outside, above the level, and floors inside of it; none
/// where little of the floors is inside. `regions` numbers the triangles that lie in one plane and hang together: they
/// are covers together. Looks along a few dozen directions at every triangle, in parallel; of a picture's precision.
std::vector<bool> findCovers(const std::vector<SurfaceVertex>& surface, const std::vector<std::uint32_t>& regions);

}  // namespace footfall::ui
