// The order of many triples of numbers by their first, second and third number, in almost linear time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"

namespace footfall::detail {

/// Sorts by radix on keys of 32 bits. A key is the place of a number between the least and the greatest, and never
/// decreases with the number. Numbers with equal keys are sorted again between their least and greatest; equal numbers
/// are sorted by the next number of the triple.
template <class ValueOf>
class LexicographicOrder {
 public:
  LexicographicOrder(std::size_t count, const ValueOf& valueOf, Poll poll)
      : valueOf_(valueOf), poll_(poll), entries_(count), scratch_(count) {}

  std::vector<std::uint32_t> order() {
    const std::size_t count = entries_.size();
    for (std::size_t i = 0; i < count; ++i) entries_[i] = i;
    sort(0, count, 0, true);
    std::vector<std::uint32_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = indexOf(entries_[i]);
    return order;
  }

 private:
  using Entry = std::uint64_t;  // key, then index
  static constexpr std::size_t kSmallSize = 96;
  static constexpr std::size_t kPolledSize = 4096;
  static constexpr std::size_t kRunsPerTask = 64;
  static constexpr int kDigits = 3, kDigitBits = 11;
  static constexpr std::size_t kBuckets = std::size_t{1} << kDigitBits;

  static std::uint32_t indexOf(Entry e) { return static_cast<std::uint32_t>(e); }
  static std::uint32_t keyOf(Entry e) { return static_cast<std::uint32_t>(e >> 32); }
  static std::size_t bucketOf(Entry e, int digit) { return e >> (32 + digit * kDigitBits) & (kBuckets - 1); }

  void sort(std::size_t first, std::size_t last, int axis, bool inParallel) {
    const std::span<Entry> entries(entries_.data() + first, last - first);
    if (entries.size() <= kSmallSize) return sortByComparing(entries, axis);
    if (entries.size() > kPolledSize) poll_();
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const Entry e : entries) {
      const double x = valueOf_(indexOf(e), axis);
      least = std::min(least, x);
      greatest = std::max(greatest, x);
    }
    if (least == greatest) {
      // Entries that are equal in all three numbers are already in the order of their indices.
      if (axis < 2) sort(first, last, axis + 1, inParallel);
      return;
    }
    // Halves are subtracted, because the difference may overflow; rounding and conversion keep the order.
    const double scale = std::numeric_limits<std::uint32_t>::max() / (greatest * 0.5 - least * 0.5);
    if (!std::isfinite(scale)) return sortByComparing(entries, axis);
    for (Entry& e : entries) {
      const double place = (valueOf_(indexOf(e), axis) * 0.5 - least * 0.5) * scale;
      e = static_cast<Entry>(std::min<double>(place, std::numeric_limits<std::uint32_t>::max())) << 32 | indexOf(e);
    }
    sortByKeys(entries, {scratch_.data() + first, entries.size()});
    std::vector<std::pair<std::size_t, std::size_t>> later;
    for (std::size_t begin = first, end = first; begin < last; begin = end) {
      const std::uint32_t key = keyOf(entries_[begin]);
      for (++end; end < last && keyOf(entries_[end]) == key;) ++end;
      if (end - begin == 1) continue;
      if (inParallel)
        later.emplace_back(begin, end);
      else
        sort(begin, end, axis, false);
    }
    forRanges(later.size(), kRunsPerTask, [&](std::size_t begin, std::size_t end) {
      poll_();
      for (std::size_t i = begin; i < end; ++i) sort(later[i].first, later[i].second, axis, false);
    });
  }

  /// Stable radix sort from the last digit of the keys to the first; digits that are equal in all keys cost nothing.
  void sortByKeys(std::span<Entry> entries, std::span<Entry> scratch) {
    std::array<std::array<std::uint32_t, kBuckets>, kDigits> counts{};
    for (const Entry e : entries)
      for (int digit = 0; digit < kDigits; ++digit) ++counts[digit][bucketOf(e, digit)];
    std::span<Entry> from = entries, to = scratch;
    for (int digit = 0; digit < kDigits; ++digit) {
      auto& places = counts[digit];
      if (places[bucketOf(from[0], digit)] == from.size()) continue;
      if (entries.size() > kPolledSize) poll_();
      std::uint32_t next = 0;
      for (std::uint32_t& place : places) place = std::exchange(next, next + place);
      for (const Entry e : from) to[places[bucketOf(e, digit)]++] = e;
      std::swap(from, to);
    }
    if (from.data() != entries.data()) std::copy(from.begin(), from.end(), entries.begin());
  }

  void sortByComparing(std::span<Entry> entries, int axis) {
    std::sort(entries.begin(), entries.end(), [this, axis](Entry a, Entry b) {
      const std::uint32_t i = indexOf(a), j = indexOf(b);
      for (int k = axis; k < 3; ++k) {
        const double x = valueOf_(i, k), y = valueOf_(j, k);
        if (x != y) return x < y;
      }
      return i < j;
    });
  }

  const ValueOf& valueOf_;
  Poll poll_;
  std::vector<Entry> entries_, scratch_;
};

/// The numbers from 0 to count - 1 in the order of valueOf(i, 0), then valueOf(i, 1), then valueOf(i, 2), then i; the
/// values are finite doubles. `valueOf` and `poll`, which may throw, are called by any thread.
template <class ValueOf>
std::vector<std::uint32_t> lexicographicOrder(std::size_t count, const ValueOf& valueOf, Poll poll) {
  return LexicographicOrder<ValueOf>(count, valueOf, poll).order();
}

}  // namespace footfall::detail
