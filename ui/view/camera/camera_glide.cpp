// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/camera_glide.hpp"

namespace footfall::ui {
namespace {

constexpr int kGlideMs = 180;
constexpr int kFrameMs = 15;

}  // namespace

CameraGlide::CameraGlide(QGLViewer& viewer) : viewer_(viewer) {
  connect(&timer_, &QTimer::timeout, this, &CameraGlide::advance);
}

CameraPose CameraGlide::now() const { return poseOf(*viewer_.camera(), origin_); }

void CameraGlide::place(const CameraPose& pose) { setPose(*viewer_.camera(), pose, origin_); }

void CameraGlide::glideFrom(const CameraPose& from) {
  if (!animated_ || still_ || !viewer_.isVisible()) {
    emit moved();
    emit arrived();
    return;
  }
  way_ = Way{from, now(), {}};
  way_->since.start();
  timer_.start(kFrameMs);
  place(from);
}

void CameraGlide::advance() {
  if (!way_) return;
  const double time = static_cast<double>(way_->since.elapsed()) / kGlideMs;
  if (time >= 1) return end();
  place(between(way_->from, way_->to, time * time * (3 - 2 * time)));
  emit moved();
}

void CameraGlide::end() {
  if (!way_) return;
  timer_.stop();
  const CameraPose to = way_->to;
  way_.reset();
  place(to);
  emit moved();
  emit arrived();
}

}  // namespace footfall::ui
