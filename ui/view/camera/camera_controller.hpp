// Moves the camera: steps, views of the whole level, and bringing places into view.
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

#include "ui/view/camera/camera_glide.hpp"
#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

/// Moves the camera of a viewer, whose scene is an environment around its centre. libQGLViewer handles dragging, and
/// CameraGlide animates jumps.
class CameraController : public QObject {
  Q_OBJECT

 public:
  /// The surface along a line of sight, both in the scene's coordinates.
  using Seen = std::function<std::optional<Vec3>(const Ray&)>;

  CameraController(QGLViewer& viewer, Seen seen);

  /// Sets another environment, or none. The camera moves only with `fit`: as viewOblique(). Each change of the view's
  /// size and of what covers it then fits the environment again, until endFraming() or until somebody moves the camera.
  void setScene(std::shared_ptr<const EnvironmentGeometry> scene, bool fit);
  /// Sets an edit of the environment, with the same centre; the camera stays.
  void replaceScene(std::shared_ptr<const EnvironmentGeometry> scene);

  /// The pose of the camera, or the target of its glide.
  [[nodiscard]] CameraPose pose() const { return glide_.target(); }
  /// Places the camera without a glide, and without moved().
  void setPose(const CameraPose& pose);
  /// Places the camera; with setAnimated(), it glides there.
  void glideTo(const CameraPose& pose);
  /// Sets whether jumps of the camera are animated; off at first.
  void setAnimated(bool on) { glide_.setAnimated(on); }
  /// Ends a glide at its target.
  void endGlide() { glide_.end(); }

  /// Views straight down in parallel projection, with all detail in view.
  void viewFromTop();
  /// Views from above at an angle in perspective, with all detail in view.
  void viewOblique();
  /// Views along an axis in parallel projection, with all detail in view.
  void viewFrom(ViewSide side);
  /// Brings everything into view without turning the camera.
  void fit();
  /// Called when an environment that was opened is shown as a whole: from here on, the picture stays where it is.
  void endFraming();
  void setOrthographic(bool on);
  [[nodiscard]] bool orthographic() const;

  void zoomBy(double factor);
  /// Zooms; the surface at `place` stays where it is in the view.
  void zoomAt(double factor, const QPointF& place);
  /// Turns about the pivot, in degrees: to the right, and upwards (never over the top).
  void turnBy(double sideways, double up);
  /// Makes the surface at a place of the view the pivot, where there is one; the picture stays.
  void turnAbout(const QPoint& place);
  /// Turns the camera about the eye, in degrees.
  void lookBy(double sideways, double up);
  /// Moves the picture by pixels.
  void panBy(const QPointF& pixels);
  /// Moves by shares of the distance to the pivot, to the right and upwards in the picture.
  void shiftBy(double right, double up);
  /// Moves without turning, in units to the right, up and forwards; `up` moves along Z.
  void walkBy(double right, double up, double ahead);

  /// Brings a box (environment coordinates) into view without turning the camera. A box with hardly any extent is shown
  /// with its surroundings.
  void frame(const Vec3& lower, const Vec3& upper);
  /// Moves sideways until a place (environment coordinates) is in the middle; it becomes the pivot.
  void lookAt(const Vec3& place);
  /// Sets the box that frameSelection() shows; the last box of any `owner` counts. Empty removes the owner's box.
  void setSelectionBounds(const QString& owner, const std::optional<SceneBox>& bounds);
  /// Brings the selection into view, or the surface under the mouse, or everything.
  void frameSelection();

  /// Sets the rectangles that cover the view; fitted objects lie beside them.
  void setCovered(std::vector<QRect> rects);
  /// Sets whether the viewer has the size of a picture: nothing covers it then, jumps do not glide, and resized() has
  /// no effect.
  void setForPicture(bool on);
  /// Called when the viewer has another size. Where its window has not, every place of the screen keeps its content.
  void resized();

 signals:
  void moved();
  /// Emitted when a jump has ended.
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
  /// Fits an environment that is being opened to the view as it is now. Returns false when the framing is over.
  bool frameAgain();
  /// The surface under the mouse, where the view lies at `view` (viewer coordinates).
  [[nodiscard]] std::optional<qglviewer::Vec> pointedAt(const QRect& view) const;
  void keepPicture(const Placed& before, const Placed& now);

  QGLViewer& viewer_;
  Seen seen_;
  std::shared_ptr<const EnvironmentGeometry> scene_;
  std::vector<std::pair<QString, SceneBox>> selections_;  ///< by owner, the latest last
  std::vector<QRect> covered_;
  std::optional<Placed> placed_;      ///< place of the view on the screen
  std::optional<CameraPose> framed_;  ///< pose that opening an environment has set; null once its framing is over
  bool forPicture_ = false;
  CameraGlide glide_;
};

}  // namespace footfall::ui
