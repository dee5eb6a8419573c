// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/steering/eye_pose.hpp"

#include <QGLViewer/quaternion.h>

#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

Vec3 directionOf(const Sight& sight) {
  const double turn = sight.turn * M_PI / 180, pitch = sight.pitch * M_PI / 180;
  return {std::cos(pitch) * std::cos(turn), std::cos(pitch) * std::sin(turn), std::sin(pitch)};
}

Sight sightOf(const CameraPose& pose) {
  const qglviewer::Quaternion orientation(pose.orientation[0], pose.orientation[1], pose.orientation[2],
                                          pose.orientation[3]);
  qglviewer::Vec ahead = orientation.rotate(qglviewer::Vec(0, 0, -1));
  // Straight down or up, the upper edge of the picture is ahead.
  const qglviewer::Vec plan = std::hypot(ahead.x, ahead.y) > 1e-6 ? ahead : orientation.rotate(qglviewer::Vec(0, 1, 0));
  return {std::atan2(plan.y, plan.x) * 180 / M_PI, std::asin(std::clamp(ahead.z, -1.0, 1.0)) * 180 / M_PI};
}

CameraPose poseOfEye(const Vec3& eye, const Sight& sight, double reach) {
  const Vec3 ahead = directionOf(sight);
  const double turn = sight.turn * M_PI / 180;
  const qglviewer::Vec along = toVec(ahead), right(std::sin(turn), -std::cos(turn), 0);
  qglviewer::Quaternion orientation;
  orientation.setFromRotatedBasis(right, right ^ along, -along);
  return {eye, eye + reach * ahead, {orientation[0], orientation[1], orientation[2], orientation[3]}, false};
}

}  // namespace footfall::ui
