// Divides the drawing of one picture into several passes, each of which is short.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace footfall::ui {

/// Every pass calls the same drawing functions in the same order, and take() returns the primitives of each batch that
/// the pass draws. Together the passes draw every primitive once, in the order of a single pass.
class DrawingSlice {
 public:
  struct Range {
    int first = 0, count = 0;
  };

  /// Begins another picture.
  void restart() { done_ = 0; }
  /// Begins a pass of this much work: primitives, and kBatch for each batch with a drawn primitive.
  void begin(std::int64_t most) {
    passed_ = drawn_ = spent_ = 0;
    most_ = most;
    complete_ = true;
  }
  /// Begins a picture that is drawn in one pass.
  void beginWhole() {
    restart();
    begin(std::numeric_limits<std::int64_t>::max());
  }
  /// The primitives of a batch of `count` that this pass draws.
  Range take(int count) {
    const auto first = static_cast<int>(std::clamp<std::int64_t>(done_ - passed_, 0, count));
    const auto taken = static_cast<int>(std::clamp<std::int64_t>(most_ - spent_, 0, count - first));
    passed_ += count;
    drawn_ += taken;
    if (taken > 0) spent_ += taken + kBatch;
    if (first + taken < count) complete_ = false;
    return {first, taken};
  }
  /// Returns whether the picture is complete after this pass.
  bool end() {
    done_ += drawn_;
    return complete_;
  }
  /// The work of the last pass.
  [[nodiscard]] std::int64_t spent() const { return spent_; }

  static constexpr std::int64_t kBatch = 100;

 private:
  std::int64_t done_ = 0, passed_ = 0, drawn_ = 0, spent_ = 0, most_ = 0;
  bool complete_ = true;
};

}  // namespace footfall::ui
