// What lies around a level that is a part of an environment too large to be loaded: a picture, and nothing else.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/view/render_geometry.hpp"
#include "ui/view/scene_picker.hpp"

namespace footfall::ui {

/// Triangles that come and go together; in the scene's coordinates.
struct BackdropPiece {
  std::vector<SurfaceVertex> surface;  ///< three a triangle; upward facing ones have alpha 0
  std::array<float, 3> lower{}, upper{};

  [[nodiscard]] std::size_t triangles() const { return surface.size() / 3; }
};
using BackdropPiecePtr = std::shared_ptr<const BackdropPiece>;

/// Adds a triangle of the environment.
void addBackdropTriangle(BackdropPiece& piece, const std::array<Vec3, 3>& corners, const Vec3& centre, bool bothSides);

/// A picture that is complete at any time: where no blocks are loaded, their few coarse triangles stand for them.
struct Backdrop {
  /// From, and how many.
  using Range = std::pair<std::size_t, std::size_t>;

  BackdropPiecePtr coarse;               ///< of all blocks
  std::vector<Range> shownCoarse;        ///< triangles of it that are drawn
  std::vector<Range> coarseAlone;        ///< the same while nothing is drawn in full
  std::vector<BackdropPiecePtr> loaded;  ///< blocks in full
};
using BackdropPtr = std::shared_ptr<const Backdrop>;

/// How far a ray goes to the first triangle of what is shown; those seen from behind count with `backs` alone.
std::optional<double> meetBackdrop(const Ray& ray, const Backdrop& backdrop, const ShownSpace& shown, bool backs);

}  // namespace footfall::ui
