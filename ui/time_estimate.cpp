// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/time_estimate.hpp"

#include <algorithm>

namespace footfall {
namespace {

constexpr double kTelling = 0.05;  // of a step's work, before its own pace says more than an earlier run

// Of a step that has begun.
std::optional<double> restOf(const StepTime& step) {
  const bool telling = step.fraction > kTelling && step.elapsedMs > 0;
  const double byPace = telling ? step.elapsedMs * (1 - step.fraction) / step.fraction : 0;
  if (telling && step.expectedMs) {
    // The further it is, the more its own pace counts.
    const double byBefore = std::max(0.0, *step.expectedMs - step.elapsedMs);
    return step.fraction * byPace + (1 - step.fraction) * byBefore;
  }
  if (telling) return byPace;
  if (step.expectedMs) return std::max(0.0, *step.expectedMs - step.elapsedMs);
  return std::nullopt;
}

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
  return rest + unknownSteps * known / knownSteps;
}

double expectedMs(const std::vector<StepTime>& steps) {
  double sum = 0;
  for (const StepTime& step : steps) sum += step.expectedMs.value_or(0);
  return sum;
}

}  // namespace footfall
