// How long a run may still take.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace footfall::ui {

struct StepTime {
  std::optional<double> expectedMs;  ///< what the step took before, with these or other values
  double elapsedMs = 0;              ///< since it began; 0 before
  double fraction = 0;               ///< how much of it is done, as it last said
  bool finished = false;
};

/// Milliseconds until the last step has finished; nothing while there is nothing to go by. A step that has told enough
/// of its progress is taken at its word; one that has not is expected to take what it took before. Steps that have
/// never run are as long as what is known of the others on average. Infinite when a step has outlived all that without
/// telling of its progress: its work is not known to its end.
std::optional<double> remainingMs(const std::vector<StepTime>& steps);

/// What steps that have not begun take in all; those that have never run count as nothing.
double expectedMs(const std::vector<StepTime>& steps);

/// What can be said of the end of some work, from what was told of it and from the time that has passed since. Times
/// are in seconds on any clock that does not go back.
class EndEstimate {
 public:
  enum class Kind {
    Nothing,  ///< it is too early
    Left,     ///< so many seconds are left
    Late,     ///< it takes longer than was estimated; how much is unknown
    Unknown   ///< it takes a while, and there is nothing to go by
  };
  struct Told {
    Kind kind = Kind::Nothing;
    double seconds = 0;
  };

  void begin(double now);
  /// `fraction` of the work is done; below 0: unknown. `secondsLeft` are estimated; infinite: nobody knows.
  void update(double now, double fraction, std::optional<double> secondsLeft);
  /// A promised end that has passed makes no other one believed until a tenth of the whole work has been done since.
  [[nodiscard]] Told at(double now) const;

 private:
  [[nodiscard]] bool isLate(double now) const;

  double begun_ = 0;
  double fraction_ = -1;
  double updated_ = 0;  ///< when update() gave `left_`
  std::optional<double> left_;
  std::optional<double> promised_;  ///< the end, as it was first estimated
  double promisedAt_ = 0;
  std::optional<double> lateSince_;  ///< the fraction at which the promise was broken
};

}  // namespace footfall::ui
