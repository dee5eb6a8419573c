// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/drawing_note.hpp"

namespace footfall::ui {
namespace {

constexpr int kAfterMs = 200;  // nobody notices a shorter wait

}  // namespace

DrawingNote::DrawingNote(RunController& controller, LevelView& view, StatusLine& status, QObject* parent)
    : QObject(parent), view_(view), status_(status) {
  delay_.setSingleShot(true);
  delay_.setInterval(kAfterMs);
  connect(&delay_, &QTimer::timeout, this, [this] {
    if (pending()) status_.say(StatusSubject::Drawing, tr("Drawing the result"));
  });
  connect(&controller, &RunController::contentReady, this, [this] { since_ = std::chrono::steady_clock::now(); });
  connect(&controller, &RunController::finished, this, [this] {
    if (pending()) delay_.start();
  });
  connect(&view, &QOpenGLWidget::frameSwapped, this, &DrawingNote::look);
  // Another level, or none, has no result to wait for.
  connect(&view, &LevelView::environmentChanged, this, [this] {
    since_.reset();
    status_.end(StatusSubject::Drawing);
  });
}

// Only a frame that began after the content was set can show it.
void DrawingNote::look() {
  if (!since_ || view_.lastFrameBegun() < *since_ || !view_.isWhole()) return;
  since_.reset();
  delay_.stop();
  status_.end(StatusSubject::Drawing);
}

}  // namespace footfall::ui
