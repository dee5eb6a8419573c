// Where one looks from: poses, sides and boxes in the environment's coordinates, and what they are for libQGLViewer's
// camera, which is in the scene's.
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

/// Where the camera is, in the environment's coordinates; for sessions.
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

/// Where one looks from: along an axis of the environment, X to the right and Y to the back.
enum class ViewSide { Top, Bottom, Front, Back, Left, Right };

inline qglviewer::Vec toVec(const Vec3& p) { return {p.x, p.y, p.z}; }
inline Vec3 fromVec(const qglviewer::Vec& p) { return {p.x, p.y, p.z}; }

/// `origin` is the scene's, in the environment's coordinates.
CameraPose poseOf(const qglviewer::Camera& camera, const Vec3& origin);
void setPose(qglviewer::Camera& camera, const CameraPose& pose, const Vec3& origin);

/// The pose after `part` of the way from one to the other: the pivot goes straight, and the eye turns about it.
CameraPose between(const CameraPose& from, const CameraPose& to, double part);

QMatrix4x4 modelViewProjection(const qglviewer::Camera& camera);
/// The line of sight through a place of the view, in the scene's coordinates.
Ray sightAt(const qglviewer::Camera& camera, const QPoint& place);

}  // namespace footfall::ui
