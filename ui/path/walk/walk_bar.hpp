// The controls of the walker in the panel "Try it".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "ui/path/walk/walker.hpp"
#include "ui/path/walk/walker_view.hpp"

namespace footfall::ui {

/// Play and pause, a slider over the time, the pace, and where the camera is. Enabled while there is a path.
class WalkBar : public QWidget {
  Q_OBJECT

 public:
  WalkBar(Walker& walker, WalkerView& view, QWidget* parent = nullptr);

  [[nodiscard]] QToolButton* playButton() const { return play_; }
  [[nodiscard]] QSlider* slider() const { return slider_; }
  [[nodiscard]] QComboBox* paceBox() const { return pace_; }
  [[nodiscard]] QComboBox* cameraBox() const { return camera_; }
  [[nodiscard]] QString timeText() const { return time_->text(); }

  /// Makes the choices of a session; a pace or a camera that is not offered changes nothing.
  void choose(double pace, WalkCamera camera);

 signals:
  /// The pace or the camera is another.
  void chosen();

 private:
  void showTime();

  Walker& walker_;
  WalkerView& view_;
  QToolButton* play_;
  QSlider* slider_;
  QLabel* time_;
  QComboBox *pace_, *camera_;
};

}  // namespace footfall::ui
