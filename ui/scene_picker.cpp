// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_picker.hpp"

#include <vector>

namespace footfall {

// Möller and Trumbore 1997.
std::optional<double> meet(const Ray& ray, const std::array<Vec3, 3>& p) {
  const auto minus = [](const Vec3& a, const Vec3& b) { return Vec3{a.x - b.x, a.y - b.y, a.z - b.z}; };
  const auto dot = [](const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const auto cross = [](const Vec3& a, const Vec3& b) {
    return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const Vec3 u = minus(p[1], p[0]);
  const Vec3 v = minus(p[2], p[0]);
  const Vec3 h = cross(ray.direction, v);
  const double determinant = dot(u, h);
  if (determinant == 0) return std::nullopt;
  const Vec3 s = minus(ray.origin, p[0]);
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

std::optional<SurfacePoint> pickSurface(const Ray& ray, const EnvironmentGeometry& geometry, const ShownSpace& shown) {
  std::optional<SurfacePoint> nearest;
  double distance = std::numeric_limits<double>::infinity();
  const std::vector<SurfaceVertex>& surface = geometry.surface;
  const auto corner = [&](std::size_t vertex) {
    const auto& p = surface[vertex].position;
    return Vec3{p[0], p[1], p[2]};
  };
  for (std::size_t v = 0; v + 2 < surface.size(); v += 3) {
    const std::optional<double> met = meet(ray, {corner(v), corner(v + 1), corner(v + 2)});
    if (!met || *met >= distance) continue;
    const Vec3 point = pointOn(ray, *met);
    if (!shown.contains(point) || (shown.shows && !shown.shows(static_cast<std::uint32_t>(v / 3)))) continue;
    distance = *met;
    nearest = {static_cast<std::uint32_t>(v / 3), point};
  }
  return nearest;
}

}  // namespace footfall
