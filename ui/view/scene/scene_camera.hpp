// The camera that draws a scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMatrix4x4>
#include <QSize>
#include <QVector3D>

#include "ui/view/scene/clip_planes.hpp"

namespace footfall::ui {

struct SceneCamera {
  QMatrix4x4 modelViewProjection;
  QVector3D eye, viewDirection;
  bool orthographic = false;
  QSize viewport;  ///< device pixels
  float devicePixelRatio = 1;
  ClipPlanes clip;
  bool operator==(const SceneCamera&) const = default;
};

}  // namespace footfall::ui
