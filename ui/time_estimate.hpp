// How long a run may still take.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace footfall {

struct StepTime {
  std::optional<double> expectedMs;  ///< what the step took before, with these or other values
  double elapsedMs = 0;              ///< since it began; 0 before
  double fraction = 0;               ///< told of its progress
  bool finished = false;
};

/// Milliseconds until the last step has finished; nothing while there is nothing to go by. A step that has told enough
/// of its progress is taken at its word; one that has not is expected to take what it took before. Steps that have
/// never run are as long as what is known of the others on average.
std::optional<double> remainingMs(const std::vector<StepTime>& steps);

/// What steps that have not begun take in all; those that have never run count as nothing.
double expectedMs(const std::vector<StepTime>& steps);

}  // namespace footfall
