// Flying through the level: keys move, and the mouse turns the camera.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/view/level_view.hpp"
#include "ui/view/steering/steering_input.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// W, A, S and D move along the view, Q and E down and up, Shift four times as fast; the mouse turns, the wheel changes
/// the speed. The distance depends on the time, not on the number of frames.
class FlyTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  explicit FlyTool(LevelView& view, QObject* parent = nullptr);

  /// Units a second.
  void setSpeed(double speed) { speed_ = usual_ = speed; }
  [[nodiscard]] double speed() const { return speed_; }

  [[nodiscard]] QCursor cursor() const override { return Qt::BlankCursor; }
  [[nodiscard]] QString hint() const override;
  void ended() override;

 signals:
  void speedChanged(double speed);

 private:
  void begin();
  void advance(double seconds);

  LevelView& view_;
  CameraController& camera_;
  SteeringInput input_;
  double usual_ = 5;  ///< the last one that was set
  double speed_ = usual_;
};

}  // namespace footfall::ui
