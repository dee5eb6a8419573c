// What moves the camera: steps, views of the whole, and things to have in sight.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/qglviewer.h>

#include <QObject>
#include <QPointF>
#include <QRect>
#include <QSize>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/view/camera_glide.hpp"
#include "ui/view/camera_pose.hpp"
#include "ui/view/render_geometry.hpp"
#include "ui/view/scene_picker.hpp"

namespace footfall::ui {

/// Moves the camera of a viewer, whose scene is an environment around its centre. Dragging is left to libQGLViewer, the
/// time that jumps take to CameraGlide.
class CameraController : public QObject {
  Q_OBJECT

 public:
  /// The surface that is seen along a line of sight, both in the scene's coordinates.
  using Seen = std::function<std::optional<Vec3>(const Ray&)>;

  CameraController(QGLViewer& viewer, Seen seen);

  /// Sets another environment, or none; the camera moves only when `fit`: as viewOblique(), and again when the view
  /// gets its size.
  void setScene(std::shared_ptr<const EnvironmentGeometry> scene, bool fit);
  /// Sets an edit of the environment, with the same centre; the camera stays.
  void replaceScene(std::shared_ptr<const EnvironmentGeometry> scene);

  /// Where the camera is, or where it is going.
  [[nodiscard]] CameraPose pose() const { return glide_.target(); }
  /// Places the camera without a glide, and without moved().
  void setPose(const CameraPose& pose);
  /// Places the camera; with setAnimated(), it glides there.
  void glideTo(const CameraPose& pose);
  /// Jumps of the camera take a moment in which one sees where it goes. At first they do not.
  void setAnimated(bool on) { glide_.setAnimated(on); }
  /// A camera on its way is where it is going.
  void endGlide() { glide_.end(); }

  /// Straight down, parallel projection, all detail in sight.
  void viewFromTop();
  /// From above at an angle, perspective, all detail in sight.
  void viewOblique();
  /// Along an axis, parallel projection, all detail in sight.
  void viewFrom(ViewSide side);
  /// Everything in sight from where one looks now.
  void fit();
  /// The same as when the environment was opened, if the camera still is where it was put then: something else may lie
  /// over the view by now.
  void refit();
  void setOrthographic(bool on);
  [[nodiscard]] bool orthographic() const;

  void zoomBy(double factor);
  /// The place that is seen there stays where it is in the view.
  void zoomAt(double factor, const QPointF& place);
  /// About the pivot, in degrees: to the right, and upwards (never over the head).
  void turnBy(double sideways, double up);
  /// Turns the head, in degrees.
  void lookBy(double sideways, double up);
  /// Moves the picture by pixels.
  void panBy(const QPointF& pixels);
  /// The same by shares of the distance to the pivot, to the right and upwards in the picture.
  void shiftBy(double right, double up);
  /// Moves without turning, in units to the right, up and ahead of the eye; heights stay heights (Z) for `up`.
  void walkBy(double right, double up, double ahead);

  /// Brings a box (environment coordinates) into sight, from where one looks now. A box with hardly any extent is shown
  /// with its surroundings.
  void frame(const Vec3& lower, const Vec3& upper);
  /// Moves sideways until a place (environment coordinates) is in the middle; it becomes the pivot.
  void lookAt(const Vec3& place);
  /// What frameSelection() shows: what has been selected last, by any `owner`. Nothing: that owner's selection is gone.
  void setSelectionBounds(const QString& owner, const std::optional<SceneBox>& bounds);
  /// Brings the selection into sight, or what the mouse points at, or everything.
  void frameSelection();

  /// What lies over the view; cameras that are to have something in sight have it beside that.
  void setCovered(std::vector<QRect> rects) { covered_ = std::move(rects); }
  /// The viewer has the size of a picture for a while: nothing covers it, jumps do not glide, and resized() does
  /// nothing.
  void setForPicture(bool on);
  /// The viewer has another size. Where its window has not, what was at a place of the screen stays there.
  void resized();

 signals:
  void moved();
  /// That was a jump: nothing moves any more.
  void arrived();

 private:
  struct Placed {
    QRect inWindow;
    QSize window;
  };

  [[nodiscard]] qglviewer::Camera& camera() const { return *viewer_.camera(); }
  [[nodiscard]] Vec3 origin() const;
  void shift(const qglviewer::Vec& way);
  void step();
  void jump();
  void standBefore(const std::vector<Vec3>& points);
  void lookAlong(const qglviewer::Vec& direction, const qglviewer::Vec& up, bool orthographic);
  void fitTo(const std::vector<Vec3>& points);
  void frameInScene(const qglviewer::Vec& lower, const qglviewer::Vec& upper);
  /// What the mouse points at in the scene, where the view lies at `view` (viewer coordinates).
  [[nodiscard]] std::optional<qglviewer::Vec> pointedAt(const QRect& view) const;
  void keepPicture(const Placed& before, const Placed& now);

  QGLViewer& viewer_;
  Seen seen_;
  std::shared_ptr<const EnvironmentGeometry> scene_;
  std::vector<std::pair<QString, SceneBox>> selections_;  ///< by owner, the last one last
  std::vector<QRect> covered_;
  std::optional<Placed> placed_;      ///< where the view was on the screen
  std::optional<CameraPose> opened_;  ///< the camera, as opening an environment has put it
  bool fitWhenSized_ = false;
  bool forPicture_ = false;
  CameraGlide glide_;
};

}  // namespace footfall::ui
