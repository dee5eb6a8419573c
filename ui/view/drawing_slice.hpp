// Divides the drawing of one picture over several goes, so that none of them takes long.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace footfall::ui {

/// Every go calls the same drawing functions in the same order; they ask for each batch which of its primitives this go
/// draws. Together the goes draw every primitive once, in the order in which one go would.
class DrawingSlice {
 public:
  struct Range {
    int first = 0, count = 0;
  };

  /// Begins another picture.
  void restart() { done_ = 0; }
  /// Begins a go of so much work: primitives, and kBatch for each batch that one is drawn of.
  void begin(std::int64_t most) {
    passed_ = drawn_ = spent_ = 0;
    most_ = most;
    complete_ = true;
  }
  /// Begins a picture that is drawn in one go.
  void beginWhole() {
    restart();
    begin(std::numeric_limits<std::int64_t>::max());
  }
  /// Which primitives of a batch of `count` this go draws.
  Range take(int count) {
    const auto first = static_cast<int>(std::clamp<std::int64_t>(done_ - passed_, 0, count));
    const auto taken = static_cast<int>(std::clamp<std::int64_t>(most_ - spent_, 0, count - first));
    passed_ += count;
    drawn_ += taken;
    if (taken > 0) spent_ += taken + kBatch;
    if (first + taken < count) complete_ = false;
    return {first, taken};
  }
  /// Returns whether the picture is complete with this go.
  bool end() {
    done_ += drawn_;
    return complete_;
  }
  /// The work in the go that has ended last.
  [[nodiscard]] std::int64_t spent() const { return spent_; }

  static constexpr std::int64_t kBatch = 100;

 private:
  std::int64_t done_ = 0, passed_ = 0, drawn_ = 0, spent_ = 0, most_ = 0;
  bool complete_ = true;
};

}  // namespace footfall::ui
