// A heat map of the distances from one mesh to another, as bands of equal width in which triangles are divided (thesis
// 5.5, figures 35 to 37). Only for display.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/palette.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Distances in the way of MeshLab: they are taken at the vertices of the first mesh, and are linear over each
/// triangle.
struct DistanceBands {
  static constexpr std::size_t kCount = 24;
  using Corners = std::array<Vec3, 3>;
  /// Band b holds the distances from b to b + 1 parts of `largest`, of kCount parts. Counter-clockwise from above.
  std::array<std::vector<Corners>, kCount> triangles;
  std::size_t samples = 0;   ///< different places that are corners
  double largest = 0;        ///< of the samples; 0 exactly where all lie on the other surface
  double mean = 0, rms = 0;  ///< of the samples
  Vec3 farthest;             ///< a sample whose distance is `largest`
  std::size_t leftOut = 0;   ///< triangles of the mesh that there was no room for
  [[nodiscard]] bool isEmpty() const { return samples == 0; }
};

/// Distances from `from` to `to`, which lie in one frame. About `mostTriangles` are made: where that is too few, the
/// triangles with the smallest distances are left out. Empty when a mesh has no triangle with an area. On all threads;
/// the same input gives the same result. Throws Cancelled.
DistanceBands findDistanceBands(const NavigationMesh& from, const NavigationMesh& to, std::size_t mostTriangles,
                                RunContext& context);

/// The colour of a band: red for 0, over green, to blue for the largest distance, as in the thesis's figures.
Rgb colourOfBand(std::size_t band);

}  // namespace footfall::detail
