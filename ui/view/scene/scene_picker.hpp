// Finds the surface under the mouse.
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
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/scene_rule.hpp"

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

/// Surfaces outside of these heights are hidden.
struct HeightRange {
  double lower = std::numeric_limits<double>::lowest();
  double upper = std::numeric_limits<double>::max();
  bool operator==(const HeightRange&) const = default;
};

/// A vertical plane that hides everything in front of it: nx * x + ny * y <= at is kept.
struct CutPlane {
  double nx = 1, ny = 0;  ///< a unit vector in the plan
  double at = 0;
  bool operator==(const CutPlane&) const = default;
};

/// The visible part of the scene.
struct ShownSpace {
  HeightRange heights;
  std::optional<CutPlane> cut;
  /// Returns whether a triangle of the environment is shown, seen from its front or from behind; empty: all are.
  std::function<bool(std::uint32_t triangle, bool front)> shows = {};

  [[nodiscard]] bool contains(const Vec3& place) const {
    return place.z <= heights.upper && place.z >= heights.lower &&
           (!cut || cut->nx * place.x + cut->ny * place.y <= cut->at);
  }
};

/// Converts limits in the environment's coordinates to the scene's.
ShownSpace shownSpace(const HeightRange& heights, const std::optional<CutPlane>& cut,
                      const EnvironmentGeometry& environment);

Vec3 pointOn(const Ray& ray, double distance);

/// The ray's parameter, above 0, where it meets the triangle from either side. Empty where it misses or lies in the
/// triangle's plane.
std::optional<double> meet(const Ray& ray, const std::array<Vec3, 3>& triangle);
/// Returns whether the ray comes from the triangle's front, where its corners are counter-clockwise.
bool meetsFront(const Ray& ray, const std::array<Vec3, 3>& triangle);

/// The first triangle that the ray meets within `shown`. Ray, limits and result are in the scene's coordinates, those
/// of `geometry`. Every triangle is tested: 1 ms for about 100,000.
std::optional<SurfacePoint> pickSurface(const Ray& ray, const EnvironmentGeometry& geometry, const ShownSpace& shown);

/// Pieces of a result, which lie on the environment.
struct PickedPieces {
  std::span<const std::shared_ptr<const NavigationMeshGeometry>> meshes;
  /// Returns whether pieces of a layer (its number, with kFloorStays) are shown; null: all are.
  std::function<bool(std::uint32_t layer)> has = {};
  /// Pieces on the covers of this geometry are ignored; null: none are.
  const EnvironmentGeometry* withoutCoversOf = nullptr;
};

/// The distance along the ray to the first of the pieces within the heights of `shown`.
std::optional<double> meetPieces(const Ray& ray, const PickedPieces& pieces, const ShownSpace& shown, bool backs);

/// The drawn content of a scene, for picking.
struct PickedScene {
  const EnvironmentGeometry& environment;
  const ViewContent& content;
  const std::set<std::uint32_t>& hiddenLayers;
  SceneRule rule;
  bool cells = false;  ///< all floors are covered with the colours of cells
  ShownSpace space;    ///< without `shows`
};

/// Returns which triangles of the environment are drawn, or replaced by other drawing.
std::function<bool(std::uint32_t triangle, bool front)> shownTriangles(const PickedScene& scene);

/// The visible place along the ray, and the triangle of the environment that it lies on.
std::optional<SurfacePoint> pickSeen(const Ray& ray, const PickedScene& scene);

}  // namespace footfall::ui
