// The walker in the view, and a camera that goes along.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/path/walk/walk_figure.hpp"
#include "ui/path/walk/walker.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

enum class WalkCamera {
  Free,     ///< stays where it is
  Follows,  ///< goes along, and can be turned about the walker
  Eyes      ///< looks out of the walker's eyes
};

class WalkerView : public QObject {
  Q_OBJECT

 public:
  WalkerView(Walker& walker, LevelView& view, QObject* parent = nullptr);

  void setBody(const WalkBody& body);
  [[nodiscard]] const WalkBody& body() const { return body_; }
  /// The length of a metre in the units of the environment: how near the camera comes follows from it.
  void setMetre(double units) { metre_ = units; }
  /// Draws the walker, while there is a track.
  void setShown(bool shown);
  /// Following brings the walker into sight. A camera that has looked through its eyes goes back to where it was.
  void setCamera(WalkCamera camera);
  [[nodiscard]] WalkCamera camera() const { return camera_; }

 private:
  [[nodiscard]] bool isShown() const { return shown_ && !walker_.track().isEmpty(); }
  void update();
  void draw();
  void moveCamera();
  void leaveEyes();

  Walker& walker_;
  LevelView& view_;
  WalkBody body_;
  double metre_ = 1;
  bool shown_ = false;
  WalkCamera camera_ = WalkCamera::Free;
  std::optional<Vec3> followed_;          ///< the feet at which the camera was moved last
  std::optional<CameraPose> beforeEyes_;  ///< to go back to
  bool isMoving_ = false;                 ///< the camera is being moved from here
};

}  // namespace footfall::ui
