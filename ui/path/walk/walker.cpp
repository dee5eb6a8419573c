// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walker.hpp"

#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

constexpr double kLongestStep = 0.25;  // seconds: a frame that took longer makes nobody jump

}  // namespace

Walker::Walker(QObject* parent) : QObject(parent) {
  timer_.setInterval(15);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double seconds = static_cast<double>(sinceStep_.nsecsElapsed()) * 1e-9;
    sinceStep_.restart();
    advance(std::min(seconds, kLongestStep));
  });
}

void Walker::setTrack(WalkTrack track) {
  const double share = track_.seconds() > 0 ? time_ / track_.seconds() : 0;
  track_ = std::move(track);
  time_ = share * track_.seconds();
  if (track_.isEmpty()) timer_.stop();
  emit changed();
}

void Walker::setTime(double seconds) {
  time_ = std::clamp(seconds, 0.0, track_.seconds());
  emit changed();
}

void Walker::setPlaying(bool on) {
  if (on == isPlaying() || (on && track_.isEmpty())) return;
  if (on) {
    if (time_ >= track_.seconds()) time_ = 0;
    sinceStep_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  emit changed();
}

void Walker::advance(double seconds) {
  time_ = std::min(time_ + seconds * pace_, track_.seconds());
  if (time_ >= track_.seconds()) timer_.stop();
  emit changed();
}

}  // namespace footfall::ui
