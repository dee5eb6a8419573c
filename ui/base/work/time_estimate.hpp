// Estimates how much longer a run takes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace footfall::ui {

struct StepTime {
  std::optional<double> expectedMs;  ///< time of an earlier run of the step, with these or other values
  double elapsedMs = 0;              ///< since it began; 0 before
  double fraction = 0;               ///< last reported progress
  bool finished = false;
};

/// Milliseconds until the last step has finished; empty while there is no basis. A step that has reported enough
/// progress is extrapolated; any other step is expected to take as long as before. Steps that have never run are
/// expected to take the average of the others. Infinite when a step has far exceeded this without reporting progress.
std::optional<double> remainingMs(const std::vector<StepTime>& steps);

/// The expected time of all steps that have not begun; steps that have never run count as 0.
double expectedMs(const std::vector<StepTime>& steps);

/// The announced end of some work, from its estimates and the time since. Times are in seconds on any monotonic clock.
class EndEstimate {
 public:
  enum class Kind {
    Nothing,  ///< it is too early
    Left,     ///< seconds are left
    Late,     ///< it takes longer than estimated, by an unknown time
    Unknown   ///< it takes a while, and there is no basis for an estimate
  };
  struct Told {
    Kind kind = Kind::Nothing;
    double seconds = 0;
  };

  void begin(double now);
  /// `fraction` is the share of the work that is done; below 0: unknown. `secondsLeft` is an estimate; infinite:
  /// unknown.
  void update(double now, double fraction, std::optional<double> secondsLeft);
  /// After a promised end has passed, no estimate is used until another tenth of the whole work is done.
  [[nodiscard]] Told at(double now) const;

 private:
  [[nodiscard]] bool isLate(double now) const;

  double begun_ = 0;
  double fraction_ = -1;
  double updated_ = 0;  ///< time of the update that set `left_`
  std::optional<double> left_;
  std::optional<double> promised_;  ///< the end, as first estimated
  double promisedAt_ = 0;
  std::optional<double> lateSince_;  ///< fraction at which the promise was broken
};

}  // namespace footfall::ui
