// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/steering/fly_tool.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::ui {
namespace {

constexpr double kFaster = 4;
constexpr double kSpeedFactor = 1.25;
constexpr double kMostChange = 1000;  // of the speed that suits the level, by the wheel

}  // namespace

FlyTool::FlyTool(LevelView& view, QObject* parent)
    : QObject(parent),
      view_(view),
      camera_(view.cameraController()),
      input_(view, {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E}, nullptr) {
  connect(&input_, &SteeringInput::advanced, this, &FlyTool::advance);
  connect(&input_, &SteeringInput::looked, &camera_, &CameraController::lookBy);
  connect(&input_, &SteeringInput::wheelTurned, this, [this](double notches) {
    speed_ = std::clamp(speed_ * std::pow(kSpeedFactor, notches), usual_ / kMostChange, usual_ * kMostChange);
    emit speedChanged(speed_);
  });
  connect(&view_, &LevelView::toolChanged, this, [this] {
    if (view_.tool() == this) begin();
  });
}

QString FlyTool::hint() const {
  return tr("Fly: W A S D move, Q and E down and up, the mouse looks, Shift faster, the wheel changes the speed (%1 "
            "units a second), Esc ends")
      .arg(speed_, 0, 'g', 3);
}

void FlyTool::begin() {
  if (input_.isActive()) return;
  if (camera_.orthographic()) camera_.setOrthographic(false);
  input_.begin();
}

void FlyTool::ended() { input_.end(); }

void FlyTool::advance(double seconds) {
  const double way = seconds * speed_ * (input_.isFast() ? kFaster : 1);
  camera_.walkBy(way * input_.sign(Qt::Key_D, Qt::Key_A), way * input_.sign(Qt::Key_E, Qt::Key_Q),
                 way * input_.sign(Qt::Key_W, Qt::Key_S));
}

}  // namespace footfall::ui
