// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/parameter_measure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/vector.hpp"
#include "footfall/filter.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/camera/sight_lines.hpp"
#include "ui/view/overlays/handle_colours.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr double kTick = 9;  // length in pixels, to either side of an end
constexpr int kCircleSides = 72, kArcSides = 16;
constexpr float kHandle = 13, kMarkedHandle = 17;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The vector raised by an angle over the ground.
Vec3 raised(const Vec3& along, double degrees) {
  return std::cos(radians(degrees)) * along + Vec3{0, 0, std::sin(radians(degrees))};
}

void addPath(ViewOverlay::Lines& lines, const std::vector<Vec3>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    // Segments overlap, because their ends are blurred.
    const Vec3 more = 0.2 * (points[i] - points[i - 1]);
    lines.segments.push_back({points[i - 1] - more, points[i] + more});
  }
}

void addArea(ViewOverlay& overlay, const Vec3& middle, const std::vector<Vec3>& rim, const QColor& colour) {
  ViewOverlay::Surface surface{{}, colour};
  surface.colour.setAlphaF(0.25F);
  for (std::size_t i = 1; i < rim.size(); ++i) surface.triangles.push_back({middle, rim[i - 1], rim[i]});
  overlay.surfaces.push_back(std::move(surface));
}

}  // namespace

std::optional<MeasureKind> measureKindOf(const FilterDescriptor& filter, std::size_t parameter) {
  return parameterUse(filter, parameter).drawnAs;
}

Vec3 ParameterMeasure::handle() const {
  switch (kind) {
    case MeasureKind::Angle:
      return at + arm * raised(along, value);
    case MeasureKind::Height:
      return at + Vec3{0, 0, value};
    case MeasureKind::Length:
    case MeasureKind::Distance:
      break;
  }
  return at + value * along;
}

std::optional<double> ParameterMeasure::dragged(const Ray& from, const Ray& to) const {
  if (kind == MeasureKind::Angle) {
    const auto angle = [this](const Ray& ray) -> std::optional<double> {
      const std::optional<Vec3> met = meetPlane(ray, at, {-along.y, along.x, 0});
      if (!met) return std::nullopt;
      return std::atan2(met->z - at.z, dot(*met - at, along)) * 180 / std::numbers::pi;
    };
    const auto before = angle(from), now = angle(to);
    if (!before || !now) return std::nullopt;
    return value + std::remainder(*now - *before, 360.0);
  }
  const Vec3 axis = kind == MeasureKind::Height ? Vec3{0, 0, 1} : along;
  const auto before = alongAxis(from, at, axis), now = alongAxis(to, at, axis);
  if (!before || !now) return std::nullopt;
  return value + *now - *before;
}

ViewOverlay ParameterMeasure::overlay(double unitsPerPixel, bool marked) const {
  ViewOverlay overlay;
  overlay.throughWalls = true;
  const QColor colour = marked ? highlightColour() : handleColour();
  const Vec3 end = handle();
  ViewOverlay::Lines lines{{}, colour, 3, outlineColour()};
  const auto addTick = [&](const Vec3& place, const Vec3& direction) {
    const Vec3 half = kTick * unitsPerPixel * direction;
    lines.segments.push_back({place - half, place + half});
  };
  std::vector<Vec3> rim;
  switch (kind) {
    case MeasureKind::Angle:
      for (int i = 0; i <= kArcSides; ++i) rim.push_back(at + arm * raised(along, value * i / kArcSides));
      lines.segments.push_back({at, rim.front()});
      addPath(lines, rim);
      addArea(overlay, at, rim, colour);
      break;
    case MeasureKind::Height:
      addTick(at, along);
      addTick(end, along);
      break;
    case MeasureKind::Length:
      addTick(at, {-along.y, along.x, 0});
      addTick(end, {-along.y, along.x, 0});
      break;
    case MeasureKind::Distance:
      for (int i = 0; i <= kCircleSides; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCircleSides;
        rim.push_back(at + value * Vec3{std::cos(angle), std::sin(angle), 0});
      }
      addPath(lines, rim);
      addArea(overlay, at, rim, colour);
      break;
  }
  lines.segments.push_back({at, end});
  overlay.lines.push_back(std::move(lines));
  overlay.marks.push_back({end, colour, marked ? kMarkedHandle : kHandle});
  overlay.labels.push_back({end, text});
  return overlay;
}

double keptInRange(const ParameterDescriptor& parameter, double value, double grain) {
  const double least = parameter.minimumOpen ? parameter.minimum + grain : parameter.minimum;
  const double most = parameter.maximumOpen ? parameter.maximum - grain : parameter.maximum;
  return std::clamp(roundTo(value, grain), least, std::max(least, most));
}

}  // namespace footfall::ui
