// What lies under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "footfall/environment.hpp"
#include "ui/view/render_geometry.hpp"
#include "ui/view/scene_rule.hpp"

namespace footfall::ui {

/// A line of sight. Directions need not be unit vectors.
struct Ray {
  Vec3 origin, direction;
};

/// A place on a triangle of the environment.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  Vec3 point;
};

/// Heights outside of these are cut away.
struct HeightRange {
  double lower = std::numeric_limits<double>::lowest();
  double upper = std::numeric_limits<double>::max();
  bool operator==(const HeightRange&) const = default;
};

/// A vertical plane that cuts away what lies before it: what is left has nx * x + ny * y <= at.
struct CutPlane {
  double nx = 1, ny = 0;  ///< a unit vector in the plan
  double at = 0;
  bool operator==(const CutPlane&) const = default;
};

/// What of the scene is left to see.
struct ShownSpace {
  HeightRange heights;
  std::optional<CutPlane> cut;
  /// Whether a triangle of the environment is shown, seen from its front or from behind; empty: all are.
  std::function<bool(std::uint32_t triangle, bool front)> shows = {};

  [[nodiscard]] bool contains(const Vec3& place) const {
    return place.z <= heights.upper && place.z >= heights.lower &&
           (!cut || cut->nx * place.x + cut->ny * place.y <= cut->at);
  }
};

/// What limits in the environment's coordinates leave, in the scene's.
ShownSpace shownSpace(const HeightRange& heights, const std::optional<CutPlane>& cut,
                      const EnvironmentGeometry& environment);

Vec3 pointOn(const Ray& ray, double distance);

/// The ray's parameter where it meets the triangle, from either side; above 0. Nothing where it misses or lies in its
/// plane.
std::optional<double> meet(const Ray& ray, const std::array<Vec3, 3>& triangle);
/// Whether the ray comes from the triangle's front, where its corners go round counter-clockwise.
bool meetsFront(const Ray& ray, const std::array<Vec3, 3>& triangle);

/// The first triangle that the ray meets within `shown`. Ray, limits and result are in the scene's coordinates, those
/// of `geometry`. Looks at every triangle: 1 ms for about 100,000.
std::optional<SurfacePoint> pickSurface(const Ray& ray, const EnvironmentGeometry& geometry, const ShownSpace& shown);

/// Pieces that lie on the environment: parts of a result.
struct PickedPieces {
  std::span<const std::shared_ptr<const NavigationMeshGeometry>> meshes;
  /// Whether pieces of a layer (its number, with kFloorStays) are there; null: all are.
  std::function<bool(std::uint32_t layer)> has = {};
  /// What lies on its covers is left out; null: nothing is.
  const EnvironmentGeometry* withoutCoversOf = nullptr;
};

/// How far the ray goes to the first of the pieces within `heights` of `shown`.
std::optional<double> meetPieces(const Ray& ray, const PickedPieces& pieces, const ShownSpace& shown, bool backs);

/// All that a view draws of a scene, for picking in it.
struct PickedScene {
  const EnvironmentGeometry& environment;
  const ViewContent& content;
  const std::set<std::uint32_t>& hiddenLayers;
  SceneRule rule;
  bool cells = false;  ///< all floors are covered with their colours
  ShownSpace space;    ///< without `shows`
};

/// Which triangles of the environment are drawn, or have something drawn in their place.
std::function<bool(std::uint32_t triangle, bool front)> shownTriangles(const PickedScene& scene);

/// What is seen along the ray: the place, and the triangle of the environment that it lies on.
std::optional<SurfacePoint> pickSeen(const Ray& ray, const PickedScene& scene);

}  // namespace footfall::ui
