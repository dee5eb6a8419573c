// Intersections of lines of sight, for dragging in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

/// The place along the axis (a unit vector) through `origin` that is nearest to a line of sight; empty where the line
/// is along the axis.
std::optional<double> alongAxis(const Ray& ray, const Vec3& origin, const Vec3& axis);

/// The place where a line of sight meets a horizontal plane in front of the eye.
std::optional<Vec3> meetHeight(const Ray& ray, double z);
/// The place where it meets the plane through `at` with this normal.
std::optional<Vec3> meetPlane(const Ray& ray, const Vec3& at, const Vec3& normal);

/// A multiple of `step`, in the digits that a person would type.
double roundTo(double value, double step);

}  // namespace footfall::ui
