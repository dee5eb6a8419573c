// Computes the camera distance at which objects fit into the uncovered part of the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>
#include <vector>

#include "footfall/geometry.hpp"

namespace qglviewer {
class Camera;
}

namespace footfall::ui {

/// Moves the camera, without turning it, until a view of this size shows all points (in the scene's coordinates) as
/// large as possible outside of the rectangles `covered`, or in the whole view where those leave too little. The pivot
/// moves to the middle of the remaining view, at half the depth of the points.
void fitCamera(qglviewer::Camera& camera, const std::vector<Vec3>& points, const QSize& view,
               const std::vector<QRect>& covered);

}  // namespace footfall::ui
