// Fewer triangles that look alike from afar, for while the camera moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// Above this many triangles, geometry has a coarse surface.
inline constexpr std::size_t kCoarseAbove = 150000;
/// About as many triangles as a coarse surface has.
inline constexpr std::size_t kCoarseAim = 60000;

/// Joins all corners within cells of a grid and leaves out triangles that have lost their area by it (Rossignac and
/// Borrel 1993); small things vanish. `kept` gets the numbers of the triangles that are left. Empty for surfaces that
/// are small enough.
std::vector<SurfaceVertex> coarsened(const std::vector<SurfaceVertex>& surface, std::vector<std::uint32_t>& kept);

/// What most of each triangle of a large environment is; null for small ones. `shares`: what floorsUnder() says of the
/// result. `before`: the meshes of ViewContent::removed.
std::shared_ptr<const FloorStates> makeFloorStates(const Environment& environment, const NavigationMesh& result,
                                                   const std::vector<FloorShare>& shares,
                                                   const std::vector<const NavigationMesh*>& before);

enum class CoarsePaints {
  Result,
  Vivid,         ///< those of ViewMode::RejectedBy
  WalkableOnly,  ///< none for what was removed
};

/// The coarse surface with its floors in the paints of a result: one surface for all, as surfaces that are made coarse
/// each for itself lie in front of each other in places.
std::vector<SurfaceVertex> paintedCoarse(const CoarseSurface& coarse, const ViewContent& content, CoarsePaints paints);

}  // namespace footfall::ui
