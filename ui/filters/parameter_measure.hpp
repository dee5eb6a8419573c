// What a value of a filter means at a place of the level, as it is drawn and dragged in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "footfall/filter.hpp"
#include "ui/view/scene_picker.hpp"
#include "ui/view/view_overlay.hpp"

namespace footfall::ui {

/// A slope is an angle, a clearance and a step are heights, a gap is a length over a floor, a radius is a distance to
/// all sides.
enum class MeasureKind : std::uint8_t { Angle, Height, Length, Distance };

/// Nothing for parameters that are not drawn.
std::optional<MeasureKind> measureKindOf(const FilterDescriptor& filter, std::size_t parameter);

struct ParameterMeasure {
  int filter = 0;             ///< its FilterEntry
  std::size_t parameter = 0;  ///< its place in the filter
  MeasureKind kind{};
  Vec3 at;           ///< where it begins, on a floor
  Vec3 along;        ///< a level unit vector: where angles, lengths and distances are drawn
  double value = 0;  ///< in degrees, or in the environment's units
  double arm = 1;    ///< how long the sides of an angle are, in the environment's units
  QString text;

  /// The place of its handle.
  [[nodiscard]] Vec3 handle() const;
  /// The value when the handle was taken on one line of sight and is now on another; nothing where these do not tell
  /// (they run along what is dragged).
  [[nodiscard]] std::optional<double> dragged(const Ray& from, const Ray& to) const;
  /// `marked`: the mouse is on the handle, or holds it.
  [[nodiscard]] ViewOverlay overlay(double unitsPerPixel, bool marked) const;
};

/// A value in steps of `grain`, no further than the range of its parameter.
double keptInRange(const ParameterDescriptor& parameter, double value, double grain);

}  // namespace footfall::ui
