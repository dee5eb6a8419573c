// Coarse surfaces with fewer triangles, which are drawn while the camera moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// Geometry with more triangles than this has a coarse surface.
inline constexpr std::size_t kCoarseAbove = 150000;
/// The approximate number of triangles of a coarse surface.
inline constexpr std::size_t kCoarseAim = 60000;

/// Merges all corners within each cube of a grid, and removes triangles that lose their area by it (Rossignac and
/// Borrel 1993); small objects vanish. `kept` receives the numbers of the remaining triangles. Empty for surfaces that
/// are small enough.
std::vector<SurfaceVertex> coarsened(const std::vector<SurfaceVertex>& surface, std::vector<std::uint32_t>& kept);

/// The prevailing state of each triangle of a large environment; null for small ones. `shares` is the result of
/// floorsUnder(). `before` has the meshes of ViewContent::removed.
std::shared_ptr<const FloorStates> makeFloorStates(const Environment& environment, const NavigationMesh& result,
                                                   const std::vector<FloorShare>& shares,
                                                   const std::vector<const NavigationMesh*>& before);

enum class CoarsePaints {
  Result,
  Vivid,         ///< the paints of ViewMode::RejectedBy
  WalkableOnly,  ///< no paint for removed floors
};

/// The coarse surface with its floors in the paints of a result. It is one surface, because surfaces that are coarsened
/// separately overlap each other in places.
std::vector<SurfaceVertex> paintedCoarse(const CoarseSurface& coarse, const ViewContent& content, CoarsePaints paints);

}  // namespace footfall::ui
