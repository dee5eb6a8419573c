// The surroundings of a level that is a part of an environment too large to be loaded. They are only displayed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

/// Triangles that are loaded and dropped together, in the scene's coordinates.
struct BackdropPiece {
  std::vector<SurfaceVertex> surface;  ///< three for each triangle; upward facing ones have alpha 0
  std::array<float, 3> lower{}, upper{};

  [[nodiscard]] std::size_t triangles() const { return surface.size() / 3; }
};
using BackdropPiecePtr = std::shared_ptr<const BackdropPiece>;

/// Adds a triangle of the environment.
void addBackdropTriangle(BackdropPiece& piece, const std::array<Vec3, 3>& corners, const Vec3& centre, bool bothSides);

/// A backdrop that is complete at any time: blocks that are not loaded are shown by their few coarse triangles.
struct Backdrop {
  /// The first triangle, and the number of triangles.
  using Range = std::pair<std::size_t, std::size_t>;

  BackdropPiecePtr coarse;               ///< coarse triangles of all blocks
  std::vector<Range> shownCoarse;        ///< coarse triangles that are drawn
  std::vector<Range> coarseAlone;        ///< the drawn ones while no block is drawn in full
  std::vector<BackdropPiecePtr> loaded;  ///< blocks in full
};
using BackdropPtr = std::shared_ptr<const Backdrop>;

/// The distance along a ray to the first shown triangle; triangles seen from behind count only with `backs`.
std::optional<double> meetBackdrop(const Ray& ray, const Backdrop& backdrop, const ShownSpace& shown, bool backs);

}  // namespace footfall::ui
