// Vertex buffers for the view, made from environments and meshes by background threads. Coordinates are moved to the
// environment's centre while they are doubles: map coordinates such as 122000.123 do not tremble as floats.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/environment/environment.hpp"
#include "core/environment/navigation_mesh.hpp"
#include "ui/appearance.hpp"

namespace footfall {

/// 20 bytes; locations 0, 1 and 2 of shaders/surface.vert.
struct SurfaceVertex {
  std::array<float, 3> position{};
  std::array<std::int8_t, 4> normal{};   ///< w: Pattern
  std::array<std::uint8_t, 4> colour{};  ///< alpha 0: takes the view's floor paint
};

/// Locations 0 and 1 of shaders/line.vert.
struct LineSegment {
  std::array<float, 3> from{}, to{};
};

struct EnvironmentGeometry {
  Vec3 centre;        ///< of the bounds, in the environment's coordinates: the origin of everything here
  Vec3 lower, upper;  ///< bounds relative to the centre
  std::vector<SurfaceVertex> surface;  ///< three a triangle; upward facing ones have alpha 0
  /// Its outermost points in many directions, for fitting the camera.
  std::vector<Vec3> extremes;
  /// The same for where its detail is, when that is a small part of it: a town in the middle of an endless plain.
  std::vector<Vec3> detailExtremes;
  std::vector<LineSegment> creases;  ///< open, non-manifold and sharp edges
};

struct MeshGeometry {
  std::vector<SurfaceVertex> surface;  ///< three a triangle
  std::vector<LineSegment> creases;    ///< sharp edges between two triangles
  std::vector<LineSegment> outline;    ///< edges with one triangle
  std::vector<LineSegment> obstacleEdges;
  std::vector<LineSegment> connections;
  std::uint32_t layers = 0;
};

/// Around `centre`, or the middle of the bounds.
std::shared_ptr<const EnvironmentGeometry> makeEnvironmentGeometry(const Environment& environment,
                                                                   const std::optional<Vec3>& centre = std::nullopt);

/// `paint` for everything, or layer colours where it is empty.
std::shared_ptr<const MeshGeometry> makeMeshGeometry(const NavigationMesh& mesh, const Vec3& centre,
                                                     const std::optional<Paint>& paint = std::nullopt);

/// What the view shows over the environment.
struct ViewContent {
  struct Removed {
    const RemovalStyle* style = nullptr;
    std::shared_ptr<const MeshGeometry> before;  ///< what was walkable before that filter
  };
  /// Drawn in this order, each over the ones before it and all under the result: what stays visible of each is what
  /// its filter removed.
  std::vector<Removed> removed;
  /// Upward facing parts of the environment are what nothing was walkable of; shown so when set.
  const RemovalStyle* firstRemoval = nullptr;
  std::vector<std::shared_ptr<const MeshGeometry>> walkable;  ///< the result, or its parts while a run goes on
  /// What is not as in all of the above any more: surfaces that are drawn over it, each over the ones before.
  std::vector<std::shared_ptr<const MeshGeometry>> changes;
};

}  // namespace footfall
