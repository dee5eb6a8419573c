// Camera poses, view sides and boxes in the environment's coordinates, and their conversion to libQGLViewer's camera,
// which uses the scene's coordinates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/vec.h>

#include <QMatrix4x4>
#include <QPoint>
#include <array>

#include "footfall/geometry.hpp"

namespace qglviewer {
class Camera;
}

namespace footfall::ui {

struct Ray;

/// The pose of the camera in the environment's coordinates; sessions save it.
struct CameraPose {
  Vec3 position, pivot;
  std::array<double, 4> orientation{0, 0, 0, 1};  ///< quaternion x, y, z, w
  bool orthographic = false;
  bool operator==(const CameraPose&) const = default;
};

/// A box along the axes, in the environment's coordinates.
struct SceneBox {
  Vec3 lower, upper;
  bool operator==(const SceneBox&) const = default;
};

/// A view along an axis of the environment, with X to the right and Y to the back.
enum class ViewSide { Top, Bottom, Front, Back, Left, Right };

inline qglviewer::Vec toVec(const Vec3& p) { return {p.x, p.y, p.z}; }
inline Vec3 fromVec(const qglviewer::Vec& p) { return {p.x, p.y, p.z}; }

/// `origin` is the scene's, in the environment's coordinates.
CameraPose poseOf(const qglviewer::Camera& camera, const Vec3& origin);
void setPose(qglviewer::Camera& camera, const CameraPose& pose, const Vec3& origin);

/// The pose after the share `part` of the way: the pivot moves in a straight line, and the eye turns about it.
CameraPose between(const CameraPose& from, const CameraPose& to, double part);

QMatrix4x4 modelViewProjection(const qglviewer::Camera& camera);
/// The line of sight through a place of the view, in the scene's coordinates.
Ray sightAt(const qglviewer::Camera& camera, const QPoint& place);

}  // namespace footfall::ui
