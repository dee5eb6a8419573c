// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_bar.hpp"

#include <algorithm>
#include <cstdio>

namespace footfall::app {

void ProgressBar::begin(const std::string& task, std::size_t steps) {
  const std::lock_guard lock(mutex_);
  label_ = task;
  steps_ = steps;
  finished_ = 0;
  fraction_ = 0;
  draw(true);
}

void ProgressBar::show(const RunEvent& event) {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  switch (event.kind) {
    case RunEvent::Kind::StepStarted:
      label_ = event.text;
      finished_ = event.step;
      fraction_ = 0;
      draw(true);
      break;
    case RunEvent::Kind::StepFinished:
      finished_ = event.step + 1;
      fraction_ = 0;
      if (finished_ == steps_) label_ = "navigation mesh";
      draw(finished_ == steps_);
      break;
    case RunEvent::Kind::Progress:
      // Threads may report out of order; a bar that steps back looks broken.
      fraction_ = std::clamp(event.fraction, fraction_, 1.0);
      draw(false);
      break;
    case RunEvent::Kind::PartReady:
    case RunEvent::Kind::CellsMade:
    case RunEvent::Kind::CellFinished:
      break;
  }
}

void ProgressBar::clear() {
  const std::lock_guard lock(mutex_);
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void ProgressBar::draw(bool atOnce) {
  using namespace std::chrono_literals;
  constexpr int kWidth = 30;
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || (!atOnce && now - lastDrawn_ < 50ms)) return;
  const double done = (static_cast<double>(finished_) + fraction_) / static_cast<double>(steps_ + 1);
  const int filled = static_cast<int>(std::clamp(done, 0.0, 1.0) * kWidth);
  const std::string bar = std::string(filled, '=') + std::string(kWidth - filled, ' ');
  std::fprintf(stderr, "\r\033[K[%s] %3.0f %%  %s", bar.c_str(), 100 * done, label_.c_str());
  std::fflush(stderr);
  lastDrawn_ = now;
  drawn_ = true;
}

}  // namespace footfall::app
