// Keys that move and a mouse that looks, for tools that steer the eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPoint>
#include <QTimer>
#include <optional>
#include <set>

#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Takes the mouse and some keys of a view between begin() and end(). While one of the keys is down, advanced() is
/// emitted about every 15 ms with the time that has passed, so that how far one gets depends on the time and not on the
/// frames. The mouse pointer goes back to the middle of the view before it leaves it.
class SteeringInput : public QObject {
  Q_OBJECT

 public:
  SteeringInput(LevelView& view, std::set<int> keys, QObject* parent);

  void begin();
  void end();
  [[nodiscard]] bool isActive() const { return active_; }
  [[nodiscard]] bool isHeld(int key) const { return held_.contains(key); }
  /// 1 while `plus` is down, -1 while `minus` is, 0 while both or neither is.
  [[nodiscard]] double sign(int plus, int minus) const {
    return static_cast<double>(isHeld(plus)) - static_cast<double>(isHeld(minus));
  }
  /// Shift is down.
  [[nodiscard]] bool isFast() const { return fast_; }
  /// Emits advanced() without keys, too.
  void setAlwaysAdvancing(bool on);

 signals:
  void advanced(double seconds);
  /// The mouse has moved so far, in degrees to the right and upwards.
  void looked(double right, double up);
  /// The wheel has turned by so many notches, away from the user.
  void wheelTurned(double notches);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void look(const QPoint& place);
  void step();
  void updateTimer();

  LevelView& view_;
  const std::set<int> keys_;
  std::set<int> held_;
  bool active_ = false, fast_ = false, always_ = false;
  QTimer timer_;
  QElapsedTimer sinceStep_;
  std::optional<QPoint> last_;  ///< place of the mouse
};

}  // namespace footfall::ui
