// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/sight_lines.hpp"

#include <QString>
#include <charconv>
#include <cmath>
#include <string>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

std::optional<double> alongAxis(const Ray& ray, const Vec3& origin, const Vec3& axis) {
  const Vec3 w = ray.origin - origin;
  const double b = dot(axis, ray.direction), c = dot(ray.direction, ray.direction);
  const double determinant = c - b * b;
  if (!(determinant > 1e-4 * c)) return std::nullopt;  // the line is along the axis
  const double along = (c * dot(axis, w) - b * dot(ray.direction, w)) / determinant;
  return std::isfinite(along) ? std::optional(along) : std::nullopt;
}

std::optional<Vec3> meetHeight(const Ray& ray, double z) { return meetPlane(ray, {0, 0, z}, {0, 0, 1}); }

std::optional<Vec3> meetPlane(const Ray& ray, const Vec3& at, const Vec3& normal) {
  const double t = dot(at - ray.origin, normal) / dot(ray.direction, normal);
  if (!(t > 0) || !std::isfinite(t)) return std::nullopt;
  return pointOn(ray, t);
}

double roundTo(double value, double step) {
  const double rounded = std::round(value / step) * step;
  const std::string text = QString::number(rounded, 'g', 12).toStdString();
  double typed = rounded;
  std::from_chars(text.data(), text.data() + text.size(), typed);
  return typed + 0.0;  // avoids -0
}

}  // namespace footfall::ui
