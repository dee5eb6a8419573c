// The drawn geometry of cells: the environment's floors cut at the borders, by cell, and each cell's box.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/partitioning/partition.hpp"
#include "footfall/environment.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

/// A vertex of 16 bytes; locations 0 and 1 of shaders/cell.vert.
struct CellVertex {
  std::array<float, 3> position{};
  std::uint32_t cell = 0;  ///< combined with the flags below in OpenGL's buffers
};
/// Flags added to the cell of triangles on a cover (ui/view/geometry/level_covers.hpp), or on a floor of a hidden
/// layer.
inline constexpr std::uint32_t kCellOnCover = 0x80000000, kCellHidden = 0x40000000;

/// Relative to the environment's centre, as all geometry of the view.
struct CellBox {
  std::array<float, 3> lower{}, upper{};
};

struct CellGeometry {
  std::vector<CellVertex> surface;       ///< three for each triangle, in the order of the cells
  std::vector<std::uint32_t> sources;    ///< the triangle of the environment, for each of them
  std::vector<std::size_t> firstVertex;  ///< one entry for each cell, and one more
  std::vector<LineSegment> borders;  ///< lines where borders cross floors, and the rectangle of each cell at its bottom
  std::vector<CellBox> boxes;        ///< outer sides are those of the environment
};

/// Drapes the cells over the triangles that face up. `poll` is called often and may throw. Computed in doubles, for
/// display only; the core decides exactly which triangle belongs to which cell.
std::shared_ptr<const CellGeometry> makeCellGeometry(const Environment& environment, const Vec3& centre,
                                                     const std::vector<CellBounds>& cells, Poll poll);

/// The box around the floors of a cell, not around all its heights, in the environment's coordinates, whose centre is
/// given. Empty where there is no such cell.
std::optional<SceneBox> boundsOfCell(const CellGeometry& cells, std::size_t cell, const Vec3& centre);

/// The twelve edges of a box.
std::vector<LineSegment> edgesOf(const CellBox& box);

/// The cell at the place where the ray (in the scene's coordinates) meets the first triangle within `shown`; where it
/// meets none, at the place where it meets the bottom. Empty outside of all cells.
std::optional<std::size_t> pickCell(const Ray& ray, const EnvironmentGeometry& environment,
                                    const CellGeometry& geometry, const ShownSpace& shown);

}  // namespace footfall::ui
