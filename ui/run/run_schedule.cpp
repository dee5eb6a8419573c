// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_schedule.hpp"

#include <chrono>

namespace footfall::ui {
namespace {

// A slow run begins this long after the last of several edits; about the pause between two keys.
constexpr auto kSettle = std::chrono::milliseconds(300);
constexpr auto kFrameWait = std::chrono::milliseconds(60);

}  // namespace

RunSchedule::RunSchedule() {
  settleTimer_.setSingleShot(true);
  connect(&settleTimer_, &QTimer::timeout, this, &RunSchedule::endSettling);
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, &RunSchedule::frameShown);
}

void RunSchedule::plan(Begin when) {
  drop();
  planned_ = when;
  if (when == Begin::AtOnce) begin();
  if (when == Begin::WhenEditsStop) settleTimer_.start(kSettle);
  if (when == Begin::BehindFrame) awaitFrame();
}

void RunSchedule::drop() {
  settleTimer_.stop();
  planned_.reset();
}

void RunSchedule::begin() {
  drop();
  emit due();
}

void RunSchedule::endSettling() {
  settleTimer_.stop();
  if (settling()) begin();
}

void RunSchedule::awaitFrame() { frameTimer_.start(kFrameWait); }

void RunSchedule::frameShown() {
  frameTimer_.stop();
  if (planned_ == Begin::BehindFrame) {
    begin();
  } else {
    emit framePassed();
  }
}

}  // namespace footfall::ui
