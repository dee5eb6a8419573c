// Which margins a face needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/filters/radius/margins.hpp"

namespace footfall::detail {

/// Leaves out margins of which another one has all that lies on the face, and margins that do not meet it: cutting them
/// out as well would change nothing. Found in doubles, and in doubt they stay. Not for sharing between threads.
class MarginChoice {
 public:
  /// Must outlive it.
  explicit MarginChoice(const std::vector<Margin>& margins) : margins_(margins) {}

  /// `numbers`: ascending, of margins; `corners`: the face's, scaled, counter-clockwise. Returns those that are needed,
  /// ascending, good until the next call.
  std::span<const Index> neededOn(const std::array<PlanVector, 3>& corners, std::span<const Index> numbers);

 private:
  struct Part {
    Index margin = -1;
    bool isNeeded = true;
    std::vector<PlanVector> corners;  ///< of its part on the face, which is a little larger than that
    PlanVector low, high;             ///< of the box around these
    PlanVector marginLow, marginHigh;
  };
  void clip(const std::array<PlanVector, 3>& corners, Part& part);
  [[nodiscard]] bool holds(const Part& outer, const Part& inner) const;

  const std::vector<Margin>& margins_;
  std::vector<Part> parts_;
  std::vector<PlanVector> clipped_;
  std::vector<Index> needed_;
};

}  // namespace footfall::detail
