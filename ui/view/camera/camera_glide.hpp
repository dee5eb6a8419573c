// Animates jumps of the camera.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/qglviewer.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/view/camera/camera_pose.hpp"

namespace footfall::ui {

/// Moves the camera of a viewer between poses, so that the user sees the direction of the jump. Poses are in the
/// environment's coordinates.
class CameraGlide : public QObject {
  Q_OBJECT

 public:
  explicit CameraGlide(QGLViewer& viewer);

  /// Sets the origin of the viewer's coordinates.
  void setOrigin(const Vec3& origin) { origin_ = origin; }
  /// Sets whether jumps take time; off at first.
  void setAnimated(bool on) { animated_ = on; }
  /// Suspends the animation temporarily.
  void setStill(bool on) { still_ = on; }

  [[nodiscard]] CameraPose now() const;
  /// The pose of the camera, or the target of its glide.
  [[nodiscard]] CameraPose target() const { return way_ ? way_->to : now(); }
  [[nodiscard]] bool isGliding() const { return way_.has_value(); }
  /// Places the camera at once and without a signal.
  void place(const CameraPose& pose);
  /// Glides from `from` to the pose in which the camera has been placed.
  void glideFrom(const CameraPose& from);
  /// Ends the glide at its target.
  void end();

 signals:
  void moved();
  /// Emitted when nothing moves any more.
  void arrived();

 private:
  struct Way {
    CameraPose from, to;
    QElapsedTimer since;
  };
  void advance();

  QGLViewer& viewer_;
  Vec3 origin_;
  bool animated_ = false;
  bool still_ = false;
  std::optional<Way> way_;
  QTimer timer_;
};

}  // namespace footfall::ui
