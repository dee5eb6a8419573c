// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/camera_pose.hpp"

#include <QGLViewer/camera.h>
#include <QGLViewer/manipulatedCameraFrame.h>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Quaternion;
using qglviewer::Vec;

Quaternion orientationOf(const CameraPose& pose) {
  return {pose.orientation[0], pose.orientation[1], pose.orientation[2], pose.orientation[3]};
}

std::array<double, 4> numbersOf(const Quaternion& q) { return {q[0], q[1], q[2], q[3]}; }

Vec mixed(const Vec& a, const Vec& b, double part) { return a + (b - a) * part; }

}  // namespace

CameraPose poseOf(const Camera& camera, const Vec3& origin) {
  return {fromVec(camera.position()) + origin, fromVec(camera.pivotPoint()) + origin, numbersOf(camera.orientation()),
          camera.type() == Camera::ORTHOGRAPHIC};
}

void setPose(Camera& camera, const CameraPose& pose, const Vec3& origin) {
  camera.setType(Camera::PERSPECTIVE);  // parallel projections then compute their scale anew
  camera.frame()->setPivotPoint(toVec(pose.pivot - origin));
  camera.setOrientation(orientationOf(pose));
  camera.setPosition(toVec(pose.position - origin));
  if (pose.orthographic) camera.setType(Camera::ORTHOGRAPHIC);
}

CameraPose between(const CameraPose& from, const CameraPose& to, double part) {
  const Quaternion first = orientationOf(from);
  const Quaternion last = orientationOf(to);
  // Interpolates the pivot, the rotation about it, and the position of the eye relative to it.
  const Vec pivot = mixed(toVec(from.pivot), toVec(to.pivot), part);
  const Vec eye = mixed(first.inverseRotate(toVec(from.position) - toVec(from.pivot)),
                        last.inverseRotate(toVec(to.position) - toVec(to.pivot)), part);
  const Quaternion turn = Quaternion::slerp(first, last, part);
  return {fromVec(pivot + turn.rotate(eye)), fromVec(pivot), numbersOf(turn), from.orthographic && to.orthographic};
}

QMatrix4x4 modelViewProjection(const Camera& camera) {
  GLdouble modelView[16];
  GLdouble projection[16];
  camera.getModelViewMatrix(modelView);
  camera.getProjectionMatrix(projection);
  QMatrix4x4 product;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += projection[k * 4 + row] * modelView[column * 4 + k];
      product(row, column) = static_cast<float>(sum);
    }
  }
  return product;
}

Ray sightAt(const Camera& camera, const QPoint& place) {
  Vec origin, direction;
  camera.convertClickToLine(place, origin, direction);
  return {fromVec(origin), fromVec(direction)};
}

}  // namespace footfall::ui
