// The connected parts of a walkable area: where can agents get to without leaving it?
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

struct Component {
  double area = 0;  ///< of the surface, rounded; the square of the environment's unit
  std::size_t triangles = 0;
  Vec3 lower, upper;                  ///< the box around it
  Vec3 centre;                        ///< of mass; it may lie beside the component
  std::vector<std::uint32_t> layers;  ///< that it has a part in, ascending; empty when there are no layers
  std::uint32_t firstTriangle = 0;
};

struct Components {
  std::vector<Component> list;            ///< largest area first, then by `firstTriangle`
  std::vector<std::uint32_t> ofTriangle;  ///< for each triangle of the mesh its place in `list`

  [[nodiscard]] double totalArea() const;
};

/// Triangles belong to one component when they share an edge by its two vertices: an agent crosses it, also from layer
/// to layer. The two sides of an obstacle edge have vertices of their own, so it parts components, and so does a single
/// vertex in common. Linear in the mesh; on all threads. `poll` is called every few milliseconds, by any thread, and
/// may throw to cancel.
Components findComponents(
    const NavigationMesh& mesh, const std::function<void()>& poll = [] {});

}  // namespace footfall::detail
