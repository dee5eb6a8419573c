// Where the camera is when it is somebody's eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view/camera/camera_pose.hpp"

namespace footfall::ui {

/// A direction of sight: degrees from X towards Y in the plan, and upwards.
struct Sight {
  double turn = 0, pitch = 0;
  bool operator==(const Sight&) const = default;
};

/// The unit vector of a direction of sight.
Vec3 directionOf(const Sight& sight);
/// The direction in which a camera looks.
Sight sightOf(const CameraPose& pose);
/// The pose of an upright camera at `eye`, in perspective. The pivot lies `reach` ahead; the nearest surfaces that are
/// drawn are a fiftieth of that away.
CameraPose poseOfEye(const Vec3& eye, const Sight& sight, double reach);

}  // namespace footfall::ui
