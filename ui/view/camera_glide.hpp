// Jumps of the camera that take a moment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/qglviewer.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/view/camera_pose.hpp"

namespace footfall::ui {

/// Moves the camera of a viewer from a pose to another one, so that one sees where it goes. Poses are in the
/// environment's coordinates.
class CameraGlide : public QObject {
  Q_OBJECT

 public:
  explicit CameraGlide(QGLViewer& viewer);

  /// Where the viewer's own coordinates begin.
  void setOrigin(const Vec3& origin) { origin_ = origin; }
  /// Off, as at first: jumps take no time.
  void setAnimated(bool on) { animated_ = on; }
  /// For a while, jumps take no time.
  void setStill(bool on) { still_ = on; }

  [[nodiscard]] CameraPose now() const;
  /// Where the camera is, or where it is going.
  [[nodiscard]] CameraPose target() const { return way_ ? way_->to : now(); }
  [[nodiscard]] bool isGliding() const { return way_.has_value(); }
  /// Puts the camera there, at once and without a signal.
  void place(const CameraPose& pose);
  /// The camera has been placed where it is to go, and comes there from `from`.
  void glideFrom(const CameraPose& from);
  /// A camera on its way is where it is going.
  void end();

 signals:
  void moved();
  /// Nothing moves any more.
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
