// Vertex buffers for the view, made from environments and meshes by background threads. Coordinates are moved to the
// environment's centre while they are doubles: map coordinates such as 122000.123 do not tremble as floats.
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
#include "ui/view/appearance.hpp"
#include "ui/view/floor_shares.hpp"

namespace footfall::ui {

/// 20 bytes; locations 0, 1 and 2 of shaders/surface.vert.
struct SurfaceVertex {
  std::array<float, 3> position{};
  std::array<std::int8_t, 4> normal{};   ///< w: FillPattern, and kCover
  std::array<std::uint8_t, 4> colour{};  ///< alpha 0: takes the view's floor paint
};

/// Added to the pattern of what closes a level (ui/view/level_covers.hpp), and of what lies on that.
inline constexpr std::int8_t kCover = 64;

/// Locations 0 to 2 of shaders/line.vert.
struct LineSegment {
  std::array<float, 3> from{}, to{};
  /// Around it, of all lines of its kind and for each unit of area: their length, and how many they are. 0: it is
  /// alone.
  std::array<float, 2> crowd{};
  bool operator==(const LineSegment&) const = default;
};

/// The layer of what belongs to none, or to several: it is always shown.
inline constexpr std::uint32_t kNoLayer = 0x7fffffff;
/// Added to the layer of a surface that is shown as plain floor while its layer is hidden: other layers lie on the same
/// triangle of the environment, which therefore stays.
inline constexpr std::uint32_t kFloorStays = 0x80000000;

/// For each triangle of an environment the layer that all walkable pieces of it belong to, or kNoLayer.
using EnvironmentLayers = std::vector<std::uint32_t>;

/// What a triangle of an environment is: a layer (0 where there are none), or one of these; from kFirstRemoval down,
/// what the filters of ViewContent::removed have removed, in their order.
inline constexpr std::int32_t kFloorAsItIs = -1, kFirstRemoval = -2;
using FloorStates = std::vector<std::int32_t>;

/// On either side of a line; it is shown when one of them is.
using LineLayers = std::array<std::uint32_t, 2>;

/// A large surface with fewer triangles; empty for others (ui/view/coarse_geometry.hpp).
struct CoarseSurface {
  std::vector<SurfaceVertex> surface;
  std::vector<std::uint32_t> triangles;  ///< of the large one, for each
};

void setPaint(SurfaceVertex& vertex, const Paint& paint);

/// What an environment of which a part is shown takes up in all, around its own centre.
struct WholeBounds {
  Vec3 centre;
  Vec3 lower, upper;                           ///< relative to the centre
  std::vector<Vec3> extremes, detailExtremes;  ///< as of EnvironmentGeometry
};
/// `surface` stands for all of it.
std::shared_ptr<const WholeBounds> makeWholeBounds(const Vec3& lower, const Vec3& upper, const Vec3& centre,
                                                   const std::vector<SurfaceVertex>& surface);

struct EnvironmentGeometry {
  Vec3 centre;        ///< of the bounds, in the environment's coordinates: the origin of everything here
  Vec3 lower, upper;  ///< bounds relative to the centre
  std::vector<SurfaceVertex> surface;  ///< three a triangle; upward facing ones have alpha 0
  CoarseSurface coarse;
  /// Its outermost points in many directions, for fitting the camera.
  std::vector<Vec3> extremes;
  /// The same for where its detail is, when that is a small part of it: a town in the middle of an endless plain.
  std::vector<Vec3> detailExtremes;
  std::vector<LineSegment> creases;  ///< open, non-manifold and sharp edges
  /// Triangles at each crease: one twice at an open edge, kNoLayer twice where there are more than two, not all floors.
  std::vector<std::array<std::uint32_t, 2>> creaseTriangles;
  /// Heights (relative to the centre) at which there is much floor, from the lowest up: storeys, terraces, decks.
  std::vector<double> floors;
  bool bothSides = false;  ///< fronts and backs of triangles mean nothing
  /// Of a part, which then has its bounds and extremes; null for all others.
  std::shared_ptr<const WholeBounds> whole;
  bool covered = false;  ///< some triangles are covers

  [[nodiscard]] bool isCover(std::uint32_t triangle) const {
    const std::size_t vertex = std::size_t{3} * triangle;
    return vertex < surface.size() && (surface[vertex].normal[3] & kCover) != 0;
  }
};

/// Figures of one layer, or of all that is walkable where there are no layers.
struct LayerFigures {
  double area = 0;  ///< of the surface, square units
  std::uint32_t triangles = 0;
  std::string storeys;  ///< of a building, on which it lies; else empty
  /// Bounds relative to the centre.
  std::array<float, 3> lower{}, upper{};
};

struct NavigationMeshGeometry {
  std::vector<SurfaceVertex> surface;  ///< three a triangle
  std::vector<std::uint32_t> sources;  ///< the triangle of the environment, for each of them; empty: not known
  std::vector<LineSegment> creases;    ///< sharp edges between two triangles
  std::vector<LineSegment> outline;    ///< edges with one triangle
  std::vector<LineSegment> obstacleEdges;
  std::vector<LineSegment> connections;
  std::vector<LineSegment> steps;  ///< of each link both edges, and what joins them at the ends
  std::vector<LineSegment> gaps;   ///< the same with dashes for edges
  std::vector<LineSegment> drops;  ///< of each drop its stretch of border, and arrows from there to the landing
  std::uint32_t layers = 0;
  /// The layers of each triangle and line of the above; all empty without layers.
  std::vector<std::uint32_t> surfaceLayers;
  std::vector<LineLayers> creaseLayers, outlineLayers, obstacleEdgeLayers, connectionLayers, stepLayers, gapLayers,
      dropLayers;
  /// One for each layer, one for the whole without layers, none for what is only shown with a paint of its own.
  std::vector<LayerFigures> figures;
};

/// Around `centre`, or the middle of the bounds. Without `withCovers`, nothing is a cover, and it takes less time.
/// `whole`: the environment is a part of that; its centre is the centre.
std::shared_ptr<const EnvironmentGeometry> makeEnvironmentGeometry(const Environment& environment,
                                                                   const std::optional<Vec3>& centre = std::nullopt,
                                                                   bool withCovers = true,
                                                                   std::shared_ptr<const WholeBounds> whole = nullptr);

/// Finds the layers of the triangles of the environment under a mesh; null for a mesh without layers. `shares`: what
/// floorsUnder() says of it.
std::shared_ptr<const EnvironmentLayers> makeEnvironmentLayers(const NavigationMesh& mesh,
                                                               const Environment& environment,
                                                               const std::vector<FloorShare>& shares);

/// `paint` for everything, or layer colours where it is empty. With `environmentLayers`, its parts can be hidden with
/// the layers; those of a mesh without layers follow their triangles of the environment.
std::shared_ptr<const NavigationMeshGeometry> makeMeshGeometry(const NavigationMesh& mesh, const Vec3& centre,
                                                               const std::optional<Paint>& paint = std::nullopt,
                                                               const EnvironmentLayers* environmentLayers = nullptr);

/// Replaces the creases by the edges on which pieces of different triangles of the environment meet.
void addSourceEdges(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry);

/// What the view shows over the environment.
struct ViewContent {
  struct Removed {
    const RemovalStyle* style = nullptr;
    std::shared_ptr<const NavigationMeshGeometry> before;  ///< what was walkable before
  };
  /// Drawn in this order, each over the ones before it and all under the result: what stays visible of each is what
  /// its filter removed.
  std::vector<Removed> removed;
  /// Upward facing parts of the environment are what nothing was walkable of; shown so when set.
  const RemovalStyle* firstRemoval = nullptr;
  /// Some margins are too near a border, and whether it is a wall or a ledge is still to be found.
  bool hasMixedMargins = false;
  std::vector<std::shared_ptr<const NavigationMeshGeometry>>
      walkable;  ///< the result, or its parts while a run goes on
  /// What is not as in all of the above any more: surfaces that are drawn over it, each over the ones before.
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> changes;
  /// Which triangles of the environment go with which layer; null without layers.
  std::shared_ptr<const EnvironmentLayers> environmentLayers;
  /// What the coarse surface of a large environment shows of a finished result; null for others.
  std::shared_ptr<const FloorStates> floorStates;
};

}  // namespace footfall::ui
