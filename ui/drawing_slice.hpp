// Divides the drawing of one picture over several goes, so that none of them takes long.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace footfall {

/// Every go calls the same drawing functions in the same order; they ask for each batch which of its primitives this go
/// draws. Together the goes draw every primitive once, in the order in which one go would.
class DrawingSlice {
 public:
  struct Range {
    int first = 0, count = 0;
  };

  /// Another picture.
  void restart() { done_ = 0; }
  /// A go that draws at most so many primitives.
  void begin(std::int64_t most) {
    passed_ = drawn_ = 0;
    most_ = most;
    complete_ = true;
  }
  /// A picture that is drawn in one go.
  void beginWhole() {
    restart();
    begin(std::numeric_limits<std::int64_t>::max());
  }
  /// Of a batch of `count` primitives: those that this go draws.
  Range take(int count) {
    const auto first = static_cast<int>(std::clamp<std::int64_t>(done_ - passed_, 0, count));
    const auto taken = static_cast<int>(std::min<std::int64_t>(count - first, most_ - drawn_));
    passed_ += count;
    drawn_ += taken;
    if (first + taken < count) complete_ = false;
    return {first, taken};
  }
  /// Returns whether the picture is complete with this go.
  bool end() {
    done_ += drawn_;
    return complete_;
  }
  /// In the go that has ended last.
  [[nodiscard]] std::int64_t drawn() const { return drawn_; }

 private:
  std::int64_t done_ = 0, passed_ = 0, drawn_ = 0, most_ = 0;
  bool complete_ = true;
};

}  // namespace footfall
