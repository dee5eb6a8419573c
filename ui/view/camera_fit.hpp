// How near the camera must stand to have something in sight, beside what lies over the view.
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
/// large as it can outside of the rectangles `covered`, or over the whole view where those leave too little. The pivot
/// goes to the middle of what is left of the view, at half the depth of the points.
void fitCamera(qglviewer::Camera& camera, const std::vector<Vec3>& points, const QSize& view,
               const std::vector<QRect>& covered);

}  // namespace footfall::ui
