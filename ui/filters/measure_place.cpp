// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/measure_place.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "core/base/vector.hpp"

namespace footfall::ui {
namespace {

std::optional<Vec3> levelDirection(const Vec3& way) {
  const double size = std::hypot(way.x, way.y);
  if (!(size > 0)) return std::nullopt;
  return Vec3{way.x / size, way.y / size, 0};
}

}  // namespace

std::optional<MeasurePlace> findLink(const NavigationMesh& result, StepKind kind, const Vec3& near,
                                     const std::function<bool(const Vec3&)>& isShown) {
  std::optional<MeasurePlace> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const StepLink& link : result.links) {
    if (link.kind != kind) continue;
    const std::array<Vec3, 2> from{result.vertices[link.from[0]], result.vertices[link.from[1]]};
    const Vec3 first = 0.5 * (from[0] + from[1]);
    const Vec3 second = 0.5 * (result.vertices[link.to[0]] + result.vertices[link.to[1]]);
    const double distance = length(first - near);
    if (distance >= least) continue;
    const auto along = levelDirection(kind == StepKind::Step ? from[1] - from[0] : second - first);
    const Vec3 at = kind == StepKind::Step && second.z < first.z ? second : first;
    if (!along || !isShown(at)) continue;
    least = distance;
    nearest = MeasurePlace{at, *along, kind == StepKind::Step ? link.height : link.width};
  }
  return nearest;
}

}  // namespace footfall::ui
