// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/work/time_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall::ui {
namespace {

// share of a step's work after which its own pace is more reliable than an earlier run
constexpr double kTelling = 0.05;
constexpr double kFarBeyond = 2;  // factor on the expected time of a step
constexpr double kPatienceMs = 2000;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A step that reports no progress has taken so much longer than expected that the expectation is useless.
bool isBeyond(const StepTime& step, double expectedMs) {
  return step.fraction <= kTelling && step.elapsedMs > kFarBeyond * expectedMs && step.elapsedMs > kPatienceMs;
}

// The time left of a step that has begun.
std::optional<double> restOf(const StepTime& step) {
  const bool telling = step.fraction > kTelling && step.elapsedMs > 0;
  const double byPace = telling ? step.elapsedMs * (1 - step.fraction) / step.fraction : 0;
  if (telling && step.expectedMs) {
    // The step's own pace counts more the further it is.
    const double byBefore = std::max(0.0, *step.expectedMs - step.elapsedMs);
    return step.fraction * byPace + (1 - step.fraction) * byBefore;
  }
  if (telling) return byPace;
  if (step.expectedMs) return std::max(0.0, *step.expectedMs - step.elapsedMs);
  return std::nullopt;
}

constexpr double kGrace = 1;            // seconds that an end may be late
constexpr double kGraceShare = 0.5;     // plus this share of the promised time
constexpr double kMuchLonger = 2;       // factor on the promised time
constexpr double kUnknownAfter = 5;     // seconds without a basis for an estimate
constexpr double kBelievedAgain = 0.1;  // share of the work after a broken promise

}  // namespace

std::optional<double> remainingMs(const std::vector<StepTime>& steps) {
  double rest = 0;
  double known = 0;
  int knownSteps = 0;
  int unknownSteps = 0;
  for (const StepTime& step : steps) {
    if (step.finished) {
      known += step.elapsedMs;
      ++knownSteps;
    } else if (const auto left = restOf(step)) {
      rest += *left;
      known += step.elapsedMs + *left;
      ++knownSteps;
    } else {
      ++unknownSteps;
    }
  }
  if (knownSteps == 0 || (unknownSteps > 0 && known <= 0)) return std::nullopt;
  const double average = known / knownSteps;
  for (const StepTime& step : steps)
    if (!step.finished && isBeyond(step, step.expectedMs.value_or(average))) return kInfinite;
  return rest + unknownSteps * average;
}

double expectedMs(const std::vector<StepTime>& steps) {
  double sum = 0;
  for (const StepTime& step : steps) sum += step.expectedMs.value_or(0);
  return sum;
}

void EndEstimate::begin(double now) {
  *this = {};
  begun_ = now;
}

void EndEstimate::update(double now, double fraction, std::optional<double> secondsLeft) {
  if (isLate(now) && !lateSince_) lateSince_ = std::max(fraction_, 0.0);
  fraction_ = fraction;
  left_ = secondsLeft;
  updated_ = now;
  if (lateSince_ && fraction >= *lateSince_ + kBelievedAgain) {
    lateSince_.reset();
    promised_.reset();
  }
  const bool isFinite = left_ && std::isfinite(*left_);
  // A much later end that is announced in time is no broken promise.
  const bool isMuchLater =
      isFinite && promised_ && !lateSince_ && *left_ >= kMuchLonger * (*promised_ - promisedAt_) && *left_ > kGrace;
  if (isFinite && (!promised_ || isMuchLater)) {
    promised_ = now + *left_;
    promisedAt_ = now;
  }
}

bool EndEstimate::isLate(double now) const {
  return promised_ && now > *promised_ + kGrace + kGraceShare * (*promised_ - promisedAt_);
}

EndEstimate::Told EndEstimate::at(double now) const {
  const bool isUnknown = left_ && !std::isfinite(*left_);
  if (lateSince_ || isLate(now) || (isUnknown && promised_)) return {Kind::Late, 0};
  if (isUnknown || (!left_ && now - begun_ > kUnknownAfter)) return {Kind::Unknown, 0};
  if (!left_) return {Kind::Nothing, 0};
  return {Kind::Left, std::max(0.0, *left_ - (now - updated_))};
}

}  // namespace footfall::ui
