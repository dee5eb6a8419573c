// A set of pairs of triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {

/// A set of pairs (s, t) with s > t, by open addressing. Several threads may look up pairs at a time.
class PairSet {
 public:
  [[nodiscard]] bool contains(const std::array<Index, 2>& pair) const { return slots_[slotOf(keyOf(pair))] != 0; }
  /// Fetches what contains() will read: a large set is in no cache, and several pairs are fetched as fast as one.
  void prefetch(const std::array<Index, 2>& pair) const { __builtin_prefetch(&slots_[startOf(keyOf(pair))]); }
  /// Returns whether the pair was not in the set.
  bool insert(const std::array<Index, 2>& pair) {
    if (2 * ++count_ > slots_.size()) grow();
    std::uint64_t& slot = slots_[slotOf(keyOf(pair))];
    if (slot != 0) --count_;
    return std::exchange(slot, keyOf(pair)) == 0;
  }

 private:
  static std::uint64_t keyOf(const std::array<Index, 2>& pair) {
    return static_cast<std::uint64_t>(pair[0]) << 32 | static_cast<std::uint64_t>(pair[1]);
  }
  [[nodiscard]] std::size_t startOf(std::uint64_t key) const {
    return (key ^ key >> 29) * 0x9E3779B97F4A7C15ULL >> 20 & (slots_.size() - 1);
  }
  [[nodiscard]] std::size_t slotOf(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = startOf(key);
    while (slots_[slot] != 0 && slots_[slot] != key) slot = (slot + 1) & mask;
    return slot;
  }
  void grow() {
    const std::vector<std::uint64_t> before = std::exchange(slots_, std::vector<std::uint64_t>(2 * slots_.size(), 0));
    for (const std::uint64_t key : before)
      if (key != 0) slots_[slotOf(key)] = key;
  }

  std::size_t count_ = 0;
  std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(1024, 0);
};

}  // namespace footfall::detail
