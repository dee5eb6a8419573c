// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/frame_pacing.hpp"

#include <limits>

namespace footfall::ui {
namespace {

constexpr double kSlowMs = 30;  // time of a slow frame
constexpr double kFirstMs = 8;  // time for a picture in the first frame that lacks it; enough with a graphics card
constexpr int kRestMs = 200;    // time without movement
// The number of slices from which a picture counts as slow, and the pause between its slices during a run: without
// graphics hardware, the processors that compute also draw.
constexpr int kEagerSlices = 10;
constexpr int kAsideMs = 200;

}  // namespace

FramePacing::FramePacing() {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &FramePacing::frameDue);
  slices_.setSingleShot(true);
  slices_.setInterval(0);
  connect(&slices_, &QTimer::timeout, this, [this] {
    if (!isMoving()) emit sliceDue();
  });
}

SceneRenderer::Haste FramePacing::begin() {
  begun_ = std::chrono::steady_clock::now();
  SceneRenderer::Haste haste;
  haste.moving = isMoving();
  // An unknown time may be long.
  haste.hurried = wholeMs_ == 0 || wholeMs_ > kSlowMs;
  haste.ms = unhurried_ ? std::numeric_limits<double>::infinity() : kFirstMs;
  return haste;
}

void FramePacing::end(const SceneRenderer::Haste& haste, bool whole, double wholeMs) {
  whole_ = whole;
  lastMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun_).count();
  if (!haste.moving && whole) wholeMs_ = wholeMs;
  if (haste.moving && !haste.hurried) wholeMs_ = lastMs_;
  if (whole) {
    slices_.stop();
    slicesDrawn_ = 0;
  } else if (!slices_.isActive()) {
    startSlices();
  }
}

void FramePacing::startSlices() { slices_.start(computing_ && slicesDrawn_ > kEagerSlices ? kAsideMs : 0); }

void FramePacing::setComputing(bool on) {
  computing_ = on;
  if (!on && slices_.isActive()) startSlices();
}

void FramePacing::endSlice(bool complete) {
  ++slicesDrawn_;
  if (complete) {
    emit frameDue();
  } else {
    startSlices();
  }
}

}  // namespace footfall::ui
