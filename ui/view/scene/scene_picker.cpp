// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_picker.hpp"

#include <cmath>
#include <vector>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

ShownSpace shownSpace(const HeightRange& heights, const std::optional<CutPlane>& cut,
                      const EnvironmentGeometry& environment) {
  ShownSpace shown;
  const Vec3& centre = environment.centre;
  // The limit is extended a little, so that a floor at exactly this height stays visible.
  const double more = 1e-4 * (environment.upper.z - environment.lower.z);
  constexpr HeightRange kAll;
  if (heights.upper < kAll.upper) shown.heights.upper = heights.upper - centre.z + more;
  if (heights.lower > kAll.lower) shown.heights.lower = heights.lower - centre.z - more;
  shown.cut = cut;
  if (cut) shown.cut->at -= cut->nx * centre.x + cut->ny * centre.y;
  return shown;
}

// The method is that of Möller and Trumbore 1997.
std::optional<double> meet(const Ray& ray, const std::array<Vec3, 3>& p) {
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  const Vec3 h = cross(ray.direction, v);
  const double determinant = dot(u, h);
  if (determinant == 0) return std::nullopt;
  const Vec3 s = ray.origin - p[0];
  const double a = dot(s, h) / determinant;
  if (a < 0 || a > 1) return std::nullopt;
  const Vec3 q = cross(s, u);
  const double b = dot(ray.direction, q) / determinant;
  if (b < 0 || a + b > 1) return std::nullopt;
  const double distance = dot(v, q) / determinant;
  return distance > 0 ? std::optional(distance) : std::nullopt;
}

Vec3 pointOn(const Ray& ray, double distance) {
  return {ray.origin.x + distance * ray.direction.x, ray.origin.y + distance * ray.direction.y,
          ray.origin.z + distance * ray.direction.z};
}

bool meetsFront(const Ray& ray, const std::array<Vec3, 3>& p) {
  return dot(ray.direction, normalOf(p[0], p[1], p[2])) < 0;
}

namespace {

std::array<Vec3, 3> cornersAt(const std::vector<SurfaceVertex>& surface, std::size_t first) {
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& p = surface[first + k].position;
    corners[k] = {p[0], p[1], p[2]};
  }
  return corners;
}

bool isFloor(const EnvironmentGeometry& geometry, std::uint32_t triangle) {
  return geometry.surface[std::size_t{3} * triangle].colour[3] == 0;
}

// The floor under a piece that the ray meets at this distance.
std::optional<SurfacePoint> floorAt(const Ray& ray, const EnvironmentGeometry& geometry, double distance) {
  std::optional<SurfacePoint> nearest;
  double apart = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v + 2 < geometry.surface.size(); v += 3) {
    const auto triangle = static_cast<std::uint32_t>(v / 3);
    if (!isFloor(geometry, triangle)) continue;
    const std::optional<double> met = meet(ray, cornersAt(geometry.surface, v));
    if (!met || std::abs(*met - distance) >= apart) continue;
    apart = std::abs(*met - distance);
    nearest = {triangle, pointOn(ray, *met)};
  }
  return nearest;
}

}  // namespace

std::optional<SurfacePoint> pickSurface(const Ray& ray, const EnvironmentGeometry& geometry, const ShownSpace& shown) {
  std::optional<SurfacePoint> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v + 2 < geometry.surface.size(); v += 3) {
    const std::array<Vec3, 3> corners = cornersAt(geometry.surface, v);
    const std::optional<double> met = meet(ray, corners);
    if (!met || *met >= distance) continue;
    const Vec3 point = pointOn(ray, *met);
    const auto triangle = static_cast<std::uint32_t>(v / 3);
    if (!shown.contains(point) || (shown.shows && !shown.shows(triangle, meetsFront(ray, corners)))) continue;
    distance = *met;
    nearest = {triangle, point};
  }
  return nearest;
}

std::optional<double> meetPieces(const Ray& ray, const PickedPieces& pieces, const ShownSpace& shown, bool backs) {
  std::optional<double> nearest;
  for (const std::shared_ptr<const NavigationMeshGeometry>& mesh : pieces.meshes) {
    const bool layered = pieces.has && !mesh->surfaceLayers.empty();
    for (std::size_t v = 0; v + 2 < mesh->surface.size(); v += 3) {
      if (layered && !pieces.has(mesh->surfaceLayers[v / 3])) continue;
      if (pieces.withoutCoversOf && v / 3 < mesh->sources.size() &&
          pieces.withoutCoversOf->isCover(mesh->sources[v / 3]))
        continue;
      const std::array<Vec3, 3> corners = cornersAt(mesh->surface, v);
      const std::optional<double> met = meet(ray, corners);
      if (!met || (nearest && *met >= *nearest) || !shown.contains(pointOn(ray, *met))) continue;
      if (backs || meetsFront(ray, corners)) nearest = met;
    }
  }
  return nearest;
}

std::function<bool(std::uint32_t triangle, bool front)> shownTriangles(const PickedScene& scene) {
  using Environment = SceneRule::Environment;
  // Heat maps and cells lie on all floors.
  const bool floors = scene.rule.environment == Environment::Floors || scene.rule.field || scene.cells;
  const bool all = scene.rule.environment == Environment::All;
  return [&scene, all, floors](std::uint32_t triangle, bool front) {
    if (!front && !scene.rule.backs) return false;
    if (!scene.rule.covers && scene.environment.isCover(triangle)) return false;
    if (!all && !(floors && isFloor(scene.environment, triangle))) return false;
    const auto& layers = scene.content.environmentLayers;
    return !layers || triangle >= layers->size() || !scene.hiddenLayers.contains((*layers)[triangle]);
  };
}

std::optional<SurfacePoint> pickSeen(const Ray& ray, const PickedScene& scene) {
  using Environment = SceneRule::Environment;
  using Unseen = SceneRule::Unseen;
  const SceneRule& rule = scene.rule;
  const std::set<std::uint32_t>& hidden = scene.hiddenLayers;
  const auto layerOf = [](std::uint32_t layer) { return layer & ~kFloorStays; };
  const EnvironmentGeometry* const open = rule.covers ? nullptr : &scene.environment;
  const PickedPieces seen{scene.content.walkable, [&](std::uint32_t layer) { return !hidden.contains(layerOf(layer)); },
                          open};
  // Nothing hides anything in wireframes, so a walkable piece is preferred.
  const bool pieces = rule.environment == Environment::None && !rule.field && !scene.cells;
  if ((pieces || rule.through) && rule.walkable) {
    const std::optional<double> met = meetPieces(ray, seen, scene.space, rule.backs);
    if (met) return floorAt(ray, scene.environment, *met);
  }
  if (pieces) return std::nullopt;
  ShownSpace shown = scene.space;
  shown.shows = shownTriangles(scene);
  const std::optional<SurfacePoint> found = pickSurface(ray, scene.environment, shown);
  const bool gaps = rule.unseen == Unseen::Gap || (rule.unseenLayer == Unseen::Gap && !hidden.empty());
  if (!found || !gaps || scene.cells) return found;
  // Hidden pieces hide what lies under them, including their own floor.
  const PickedPieces gap{scene.content.walkable,
                         [&](std::uint32_t layer) {
                           const bool stays = (layer & kFloorStays) != 0;
                           const bool isHidden = hidden.contains(layerOf(layer));
                           return rule.unseen == Unseen::Gap ? !isHidden || stays : isHidden && stays;
                         },
                         open};
  const std::optional<double> met = meetPieces(ray, gap, scene.space, rule.backs);
  const auto along = [&](const Vec3& p) {
    const Vec3& d = ray.direction;
    return (p.x - ray.origin.x) * d.x + (p.y - ray.origin.y) * d.y + (p.z - ray.origin.z) * d.z;
  };
  if (met && along(pointOn(ray, *met)) <= along(found->point) * (1 + 1e-5)) return std::nullopt;
  return found;
}

}  // namespace footfall::ui
