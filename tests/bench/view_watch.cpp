// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/view_watch.hpp"

#include <QOpenGLFunctions>
#include <algorithm>
#include <string_view>
#include <vector>

#include "core/base/process_usage.hpp"

namespace footfall::bench {
using namespace detail;

ViewWatch::ViewWatch(EditorWindow& window) : window_(window) {
  connect(&window.view(), &LevelView::frameSwapped, this, &ViewWatch::frameShown);
  connect(&window.controller(), &RunController::finished, this, [this] { resultReady_ = watching_; });
  pulse_.setTimerType(Qt::PreciseTimer);
  pulse_.setInterval(1);
  connect(&pulse_, &QTimer::timeout, this, &ViewWatch::tick);
}

void ViewWatch::begin() {
  before_ = pixels();
  times_ = {};
  resultReady_ = done_ = false;
  watching_ = true;
  cpuBefore_ = processCpuMs();
  begun_ = std::chrono::steady_clock::now();
  sinceTick_.start();
  pulse_.start();
}

// A person who types or drags has to wait as long as two ticks of the fastest timer are apart.
void ViewWatch::tick() {
  times_.longestPause = std::max(times_.longestPause, static_cast<double>(sinceTick_.nsecsElapsed()) * 1e-6);
  sinceTick_.start();
}

void ViewWatch::frameShown() {
  if (!watching_) return;
  const double now = msUntil(std::chrono::steady_clock::now());
  const double cpu = processCpuMs() - cpuBefore_;
  times_.slowestFrame = std::max(times_.slowestFrame, window_.view().lastFrameMs());
  tick();
  if (!times_.visible && pixels() != before_) {
    times_.visible = now;
    times_.begun = msUntil(window_.view().lastFrameBegun());
    times_.visibleCpu = cpu;
  }
  sinceTick_.start();  // reading the pixels is the measurement's own pause
  if (!resultReady_) return;
  times_.finished = now;
  watching_ = false;
  done_ = true;
  pulse_.stop();
}

std::size_t ViewWatch::pixels() {
  LevelView& view = window_.view();
  const QSize size = view.size() * view.devicePixelRatioF();
  std::vector<char> picture(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()) * 4);
  view.makeCurrent();
  view.context()->functions()->glReadPixels(0, 0, size.width(), size.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                                            picture.data());
  view.doneCurrent();
  return std::hash<std::string_view>()({picture.data(), picture.size()});
}

}  // namespace footfall::bench
