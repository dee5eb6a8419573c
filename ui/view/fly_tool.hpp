// Flying through the level: keys move, and the mouse turns the camera.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPoint>
#include <QTimer>
#include <optional>
#include <set>

#include "ui/view/level_view.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// W, A, S and D move along the view, Q and E down and up, Shift four times as fast; the mouse turns, the wheel changes
/// the speed. The distance depends on the time, not on the number of frames.
class FlyTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  explicit FlyTool(LevelView& view, QObject* parent = nullptr);

  /// Units a second.
  void setSpeed(double speed) { speed_ = speed; }
  [[nodiscard]] double speed() const { return speed_; }

  [[nodiscard]] QCursor cursor() const override { return Qt::BlankCursor; }
  [[nodiscard]] QString hint() const override;
  void ended() override;

 signals:
  void speedChanged(double speed);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void begin();
  void look(const QPoint& place);
  void step();

  LevelView& view_;
  CameraController& camera_;
  bool flying_ = false;
  double speed_ = 5;
  std::set<int> held_;  ///< keys
  bool fast_ = false;
  QTimer timer_;
  QElapsedTimer sinceStep_;
  std::optional<QPoint> last_;  ///< place of the mouse
};

}  // namespace footfall::ui
