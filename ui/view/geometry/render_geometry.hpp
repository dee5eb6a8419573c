// Vertex buffers for the view, made from environments and meshes by background threads. Coordinates are made relative
// to the environment's centre in doubles, so that map coordinates such as 122000.123 do not jitter as floats.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "ui/view/geometry/floor_shares.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {

/// A vertex of 20 bytes; locations 0, 1 and 2 of shaders/surface.vert.
struct SurfaceVertex {
  std::array<float, 3> position{};
  std::array<std::int8_t, 4> normal{};   ///< w: FillPattern, and kCover
  std::array<std::uint8_t, 4> colour{};  ///< alpha 0: drawn in the view's floor paint
};

/// Added to the pattern of covers of a level (ui/view/geometry/level_covers.hpp), and of surfaces on covers.
inline constexpr std::int8_t kCover = 64;

/// Locations 0 to 2 of shaders/line.vert.
struct LineSegment {
  std::array<float, 3> from{}, to{};
  /// The length and number of all lines of its kind around it, for each unit of area. 0: the line is alone.
  std::array<float, 2> crowd{};
  bool operator==(const LineSegment&) const = default;
};

/// The layer of surfaces in none or several layers, which are always shown.
inline constexpr std::uint32_t kNoLayer = 0x7fffffff;
/// Added to the layer of a surface that is shown as plain floor while its layer is hidden, because other layers lie on
/// the same triangle of the environment, which therefore stays.
inline constexpr std::uint32_t kFloorStays = 0x80000000;

/// The layer of all walkable pieces of each triangle of an environment, or kNoLayer.
using EnvironmentLayers = std::vector<std::uint32_t>;

/// The state of a triangle of an environment: a layer (0 where there are none), or one of these; from kFirstRemoval
/// down, the filters of ViewContent::removed that removed it, in their order.
inline constexpr std::int32_t kFloorAsItIs = -1, kFirstRemoval = -2;
using FloorStates = std::vector<std::int32_t>;

/// The layers on either side of a line; the line is shown when one of them is.
using LineLayers = std::array<std::uint32_t, 2>;

/// A large surface with fewer triangles; empty for small surfaces (ui/view/geometry/coarse_geometry.hpp).
struct CoarseSurface {
  std::vector<SurfaceVertex> surface;
  std::vector<std::uint32_t> triangles;  ///< triangle of the large surface, for each
};

void setPaint(SurfaceVertex& vertex, const Paint& paint);

/// The extent of a whole environment of which a part is shown, around its own centre.
struct WholeBounds {
  Vec3 centre;
  Vec3 lower, upper;                           ///< relative to the centre
  std::vector<Vec3> extremes, detailExtremes;  ///< as in EnvironmentGeometry
};
/// `surface` stands for all of it.
std::shared_ptr<const WholeBounds> makeWholeBounds(const Vec3& lower, const Vec3& upper, const Vec3& centre,
                                                   const std::vector<SurfaceVertex>& surface);

struct EnvironmentGeometry {
  Vec3 centre;        ///< centre of the bounds in the environment's coordinates: the origin of all coordinates here
  Vec3 lower, upper;  ///< bounds relative to the centre
  std::vector<SurfaceVertex> surface;  ///< three for each triangle; upward facing ones have alpha 0
  CoarseSurface coarse;
  /// Its outermost points in many directions, for fitting the camera.
  std::vector<Vec3> extremes;
  /// The outermost points of its detail, when that is a small part of it: a town in the middle of an endless plain.
  std::vector<Vec3> detailExtremes;
  std::vector<LineSegment> creases;  ///< open, non-manifold and sharp edges
  /// The triangles at each crease: the same one twice at an open edge, kNoLayer twice where there are more than two
  /// that are not all floors.
  std::vector<std::array<std::uint32_t, 2>> creaseTriangles;
  /// Heights (relative to the centre) with much floor, from the lowest up: storeys, terraces, decks.
  std::vector<double> floors;
  bool bothSides = false;  ///< fronts and backs of triangles have no meaning
  /// Set for a part, which then has the bounds and extremes of the whole; null for all others.
  std::shared_ptr<const WholeBounds> whole;
  bool covered = false;  ///< some triangles are covers

  [[nodiscard]] bool isCover(std::uint32_t triangle) const {
    const std::size_t vertex = std::size_t{3} * triangle;
    return vertex < surface.size() && (surface[vertex].normal[3] & kCover) != 0;
  }
};

/// The figures of one layer, or of the whole walkable area where there are no layers.
struct LayerFigures {
  double area = 0;  ///< area of the surface, square units
  std::uint32_t triangles = 0;
  std::string storeys;  ///< storeys of a building that it lies on; else empty
  /// Bounds relative to the centre.
  std::array<float, 3> lower{}, upper{};
};

struct NavigationMeshGeometry {
  std::vector<SurfaceVertex> surface;  ///< three for each triangle
  std::vector<std::uint32_t> sources;  ///< triangle of the environment for each of them; empty: not known
  std::vector<LineSegment> creases;    ///< sharp edges between two triangles
  std::vector<LineSegment> outline;    ///< edges with one triangle
  std::vector<LineSegment> obstacleEdges;
  std::vector<LineSegment> connections;
  std::vector<LineSegment> steps;  ///< both edges of each link, and lines that join their ends
  std::vector<LineSegment> gaps;   ///< the same with dashes for edges
  std::vector<LineSegment> drops;  ///< border of each drop, and arrows from there to the landing
  std::uint32_t layers = 0;
  /// The layers of each triangle and line; all empty without layers.
  std::vector<std::uint32_t> surfaceLayers;
  std::vector<LineLayers> creaseLayers, outlineLayers, obstacleEdgeLayers, connectionLayers, stepLayers, gapLayers,
      dropLayers;
  /// One entry for each layer; one for the whole without layers; none for geometry with a paint of its own.
  std::vector<LayerFigures> figures;
};

/// The geometry around `centre`, or around the middle of the bounds. Without `withCovers`, there are no covers, and it
/// takes less time. `whole` is the environment that this one is a part of; its centre is used.
std::shared_ptr<const EnvironmentGeometry> makeEnvironmentGeometry(const Environment& environment,
                                                                   const std::optional<Vec3>& centre = std::nullopt,
                                                                   bool withCovers = true,
                                                                   std::shared_ptr<const WholeBounds> whole = nullptr);

/// Finds the layers of the triangles of the environment under a mesh; null for a mesh without layers. `shares` is the
/// result of floorsUnder().
std::shared_ptr<const EnvironmentLayers> makeEnvironmentLayers(const NavigationMesh& mesh,
                                                               const Environment& environment,
                                                               const std::vector<FloorShare>& shares);

/// `paint` is used for everything; empty: layer colours. With `environmentLayers`, its parts can be hidden with the
/// layers; parts of a mesh without layers are hidden with their triangles of the environment.
std::shared_ptr<const NavigationMeshGeometry> makeMeshGeometry(const NavigationMesh& mesh, const Vec3& centre,
                                                               const std::optional<Paint>& paint = std::nullopt,
                                                               const EnvironmentLayers* environmentLayers = nullptr);

/// Replaces the creases by the edges between pieces of different triangles of the environment.
void addSourceEdges(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry);

/// The content of the view over the environment.
struct ViewContent {
  struct Removed {
    const RemovalStyle* style = nullptr;
    std::shared_ptr<const NavigationMeshGeometry> before;  ///< walkable area before the removal
  };
  /// Drawn in this order, each over the ones before it and all under the result; the visible rest of each is what its
  /// filter removed.
  std::vector<Removed> removed;
  /// Set when upward facing parts of the environment that were never walkable are shown in this style.
  const RemovalStyle* firstRemoval = nullptr;
  /// Some margins are too near a border, and whether it is a wall or a ledge is not known yet.
  bool hasMixedMargins = false;
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> walkable;  ///< the result, or its parts during a run
  /// Surfaces that have changed; they are drawn over everything above, each over the ones before.
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> changes;
  /// The layer of each triangle of the environment; null without layers.
  std::shared_ptr<const EnvironmentLayers> environmentLayers;
  /// The states that the coarse surface of a large environment shows of a finished result; null for others.
  std::shared_ptr<const FloorStates> floorStates;
};

}  // namespace footfall::ui
