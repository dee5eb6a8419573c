// The body that walks: a capsule of the agent's size, drawn over the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/overlays/view_overlay.hpp"

namespace footfall::ui {

/// Metres from the eyes to the pivot of their camera: walls as near as 0.05 m are not cut away.
inline constexpr double kEyeReach = 2.5;

/// In the environment's units.
struct WalkBody {
  double height = 0, radius = 0;
  bool operator==(const WalkBody&) const = default;
  /// Where its eyes are, above its feet.
  [[nodiscard]] double eyeHeight() const { return 0.93 * height; }
};

/// A body of that height and radius; without a radius (0), as wide as a person of that height. None is wider than high.
WalkBody walkBodyFor(double height, double radius);

/// The side of a capsule that is seen from a camera, shaded, with dark eyes on the side to which it turns (degrees from
/// X towards Y).
ViewOverlay drawFigure(const WalkBody& body, const Vec3& feet, double turn, const CameraPose& camera);

}  // namespace footfall::ui
