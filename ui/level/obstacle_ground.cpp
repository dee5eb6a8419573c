// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/obstacle_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace footfall::ui {
namespace {

std::array<Vec3, 3> cornersOf(const Environment& level, std::size_t triangle) {
  const Triangle& t = level.triangles[triangle];
  return {level.vertices[t[0]], level.vertices[t[1]], level.vertices[t[2]]};
}

bool facesUp(const std::array<Vec3, 3>& p, bool bothSides) {
  const double z = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  return bothSides ? z != 0 : z > 0;
}

}  // namespace

Vec3 ObstacleGround::exactOn(std::uint32_t triangle, const Vec3& place) const {
  const auto p = cornersOf(*composer_.level(), triangle);
  return p[0].z == p[1].z && p[1].z == p[2].z ? Vec3{place.x, place.y, p[0].z} : place;
}

std::optional<Vec3> ObstacleGround::at(const QPoint& place, std::optional<std::uint32_t> without) const {
  const auto& level = composer_.level();
  if (!level) return std::nullopt;
  const std::optional<SurfacePoint> seen = view_.pick(place);
  if (seen && seen->triangle >= level->triangles.size()) return std::nullopt;  // a triangle of an earlier level
  if (!seen || !without || composer_.obstacleOf(seen->triangle) != without)
    return seen ? std::optional(exactOn(seen->triangle, seen->point)) : std::nullopt;
  // Searches behind the obstacle that is left out, from where the line of sight leaves it.
  const Ray ray = view_.rayAt(place);
  const LevelComposer::Triangles skipped = composer_.trianglesOf(*without);
  std::optional<SurfacePoint> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < level->triangles.size(); ++t) {
    if (t >= skipped.first && t - skipped.first < skipped.count) continue;
    const std::optional<double> met = meet(ray, cornersOf(*level, t));
    if (!met || *met >= distance) continue;
    distance = *met;
    nearest = {t, pointOn(ray, *met)};
  }
  return nearest ? std::optional(exactOn(nearest->triangle, nearest->point)) : std::nullopt;
}

std::optional<Vec3> ObstacleGround::under(const Vec3& place, std::optional<std::uint32_t> without) const {
  const auto& level = composer_.level();
  if (!level) return std::nullopt;
  const LevelComposer::Triangles skipped = without ? composer_.trianglesOf(*without) : LevelComposer::Triangles{};
  // Starts a little higher, so that a floor exactly there counts.
  const double above = 1e-9 * (1 + std::abs(place.z));
  const Ray down{{place.x, place.y, place.z + above}, {0, 0, -1}};
  std::optional<SurfacePoint> highest;
  for (std::uint32_t t = 0; t < level->triangles.size(); ++t) {
    if (t >= skipped.first && t - skipped.first < skipped.count) continue;
    const auto p = cornersOf(*level, t);
    if (std::min({p[0].x, p[1].x, p[2].x}) > place.x || std::max({p[0].x, p[1].x, p[2].x}) < place.x) continue;
    if (!facesUp(p, level->bothSides)) continue;
    const std::optional<double> met = meet(down, p);
    if (met && (!highest || down.origin.z - *met > highest->point.z))
      highest = {t, {place.x, place.y, down.origin.z - *met}};
  }
  return highest ? std::optional(exactOn(highest->triangle, highest->point)) : std::nullopt;
}

std::optional<std::uint32_t> ObstacleGround::obstacleAt(const QPoint& place) const {
  const std::optional<SurfacePoint> seen = view_.pick(place);
  return seen ? composer_.obstacleOf(seen->triangle) : std::nullopt;
}

}  // namespace footfall::ui
