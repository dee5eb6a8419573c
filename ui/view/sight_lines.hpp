// Where lines of sight lead: for what is dragged in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/view/scene_picker.hpp"

namespace footfall::ui {

/// How far along the axis (a unit vector) through `origin` a line of sight passes it; nothing where it looks along the
/// axis.
std::optional<double> alongAxis(const Ray& ray, const Vec3& origin, const Vec3& axis);

/// Where a line of sight meets a horizontal plane in front of the eye.
std::optional<Vec3> meetHeight(const Ray& ray, double z);
/// The same for the plane through `at` with this normal.
std::optional<Vec3> meetPlane(const Ray& ray, const Vec3& at, const Vec3& normal);

/// A multiple of `step`, in the digits that a person would type.
double roundTo(double value, double step);

}  // namespace footfall::ui
