// Where the camera stands for each frame of a turntable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <span>
#include <vector>

#include "ui/view/steering/eye_pose.hpp"

namespace footfall::ui {

/// The poses of `frames` (at least 1) evenly around the upright axis through the middle of `points`, to be seen whole
/// in each of them. The first one looks as `first` does, but never straight up or down; from frame to frame the camera
/// goes round counter-clockwise, seen from above. `field` is the vertical field of view in radians. Points and poses
/// are in the same coordinates.
std::vector<CameraPose> turntablePoses(std::span<const Vec3> points, const Sight& first, int frames,
                                       const QSize& picture, double field);

}  // namespace footfall::ui
