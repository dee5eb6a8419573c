// The measure of a filter's value at a place of the level, as it is drawn and dragged in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/filters/filter_traits.hpp"
#include "ui/view/overlays/view_overlay.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall {
struct FilterDescriptor;
struct ParameterDescriptor;
}  // namespace footfall

namespace footfall::ui {

using detail::MeasureKind;

/// Empty for parameters that are not drawn.
std::optional<MeasureKind> measureKindOf(const FilterDescriptor& filter, std::size_t parameter);

struct ParameterMeasure {
  int filter = 0;             ///< id of its FilterEntry
  std::size_t parameter = 0;  ///< index of the parameter in the filter
  MeasureKind kind{};
  Vec3 at;           ///< start of the measure, on a floor
  Vec3 along;        ///< level unit vector along which angles, lengths and distances are drawn
  double value = 0;  ///< in degrees, or in the environment's units
  double arm = 1;    ///< length of an angle's sides, in the environment's units
  QString text;

  /// The place of the handle.
  [[nodiscard]] Vec3 handle() const;
  /// The value after the handle was taken on the line of sight `from` and moved to `to`; empty where these give no
  /// value, because they run along the dragged direction.
  [[nodiscard]] std::optional<double> dragged(const Ray& from, const Ray& to) const;
  /// `marked` is true while the mouse is on the handle, or holds it.
  [[nodiscard]] ViewOverlay overlay(double unitsPerPixel, bool marked) const;
};

/// Rounds a value to steps of `grain`, within the range of its parameter.
double keptInRange(const ParameterDescriptor& parameter, double value, double grain);

}  // namespace footfall::ui
