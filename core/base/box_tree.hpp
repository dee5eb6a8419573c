// A tree that finds the boxes that may overlap a query box. It is built in almost linear time, for one pass of queries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/float4.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"

namespace footfall::detail {

/// Boxes of D dimensions in the order of a space-filling curve (Morton's), four of them under each node.
///
/// Boxes are kept as floats relative to a common centre. All steps, the difference, cutting off what no float holds,
/// and the conversion, round monotonically: a <= b stays true of the rounded numbers. So boxes that overlap (touching
/// counts) still do. Boxes may be infinite, as those of vertices are that doubles cannot place, but must not hold NaN.
template <int D>
class BoxTree {
 public:
  struct Bounds {
    std::array<double, D> lower{};
    std::array<double, D> upper{};
  };

  /// `boundsOf(id)` gives the box of each of `ids`; it may be called from any thread. `poll` is called now and then,
  /// from any thread, and may throw.
  template <class BoundsOf>
  void build(const std::vector<Index>& ids, BoundsOf boundsOf, Poll poll) {
    const auto count = static_cast<Index>(ids.size());
    levels_.clear();
    ids_.resize(count);
    if (count == 0) return;
    Bounds all = parallelReduce(
        count, kPerTask, nothing(),
        [&](const auto& range, Bounds sum) {
          poll();
          for (Index i = range.begin(); i != range.end(); ++i) add(sum, boundsOf(ids[i]));
          return sum;
        },
        [](Bounds sum, const Bounds& other) {
          add(sum, other);
          return sum;
        });
    double extent = 0;  // halves, because the whole may overflow
    for (int k = 0; k < D; ++k) {
      if (all.lower[k] > all.upper[k]) all.lower[k] = all.upper[k] = 0;
      centre_[k] = all.lower[k] / 2 + all.upper[k] / 2;
      extent = std::max(extent, all.upper[k] / 2 - all.lower[k] / 2);
    }
    std::vector<std::pair<std::uint32_t, Index>> order(count);
    const double scale = extent > kSteps * std::numeric_limits<double>::min() ? kSteps / extent : 0;
    forBlocks(count, poll, [&](Index i) {
      const Bounds b = boundsOf(ids[i]);
      std::uint32_t key = 0;
      for (int k = 0; k < D; ++k) {
        const double low = std::clamp(b.lower[k], all.lower[k], all.upper[k]);
        const double high = std::clamp(b.upper[k], all.lower[k], all.upper[k]);
        const double place = ((low / 2 + high / 2) / 2 - all.lower[k] / 2) * scale;
        key |= spread(static_cast<std::uint32_t>(std::clamp(place, 0.0, kSteps - 1))) << k;
      }
      order[i] = {key, ids[i]};
    });
    sortByKey(order, poll);

    levels_.emplace_back((count + kFan - 1) / kFan);
    forBlocks(static_cast<Index>(levels_[0].size()), poll, [&](Index g) {
      const Index first = g * kFan, last = std::min(first + kFan, count);
      for (Index i = first; i < last; ++i) {
        ids_[i] = order[i].second;
        levels_[0][g].set(i - first, rounded(boundsOf(ids_[i])));
      }
    });
    while (levels_.back().size() > 1) {
      const std::vector<Group>& below = levels_.back();
      std::vector<Group> level((below.size() + kFan - 1) / kFan);
      const auto nodes = static_cast<Index>(below.size());
      forBlocks(static_cast<Index>(level.size()), poll, [&](Index g) {
        for (Index i = g * kFan; i < std::min((g + 1) * kFan, nodes); ++i) level[g].set(i - g * kFan, below[i].whole());
      });
      levels_.push_back(std::move(level));
    }
  }

  /// Places number the boxes along the curve.
  [[nodiscard]] Index size() const { return static_cast<Index>(ids_.size()); }
  [[nodiscard]] Index idAt(Index place) const { return ids_[place]; }

  /// Calls visit(id) for every box at place `first` or later that may overlap the query.
  template <class Visit>
  void visitOverlapping(const Bounds& query, Visit visit, Index first = 0) const {
    if (levels_.empty()) return;
    const int top = static_cast<int>(levels_.size()) - 1;
    visitGroup(rounded(query), top, 0, first, visit);
  }

  [[nodiscard]] const std::array<double, D>& centre() const { return centre_; }

  /// Boxes in a row along the curve whose neighbours are found together: that takes a fraction of the work.
  static constexpr Index kRow = 4;
  /// Calls visit(place, id) for every box that may overlap the query of an earlier place in the row that begins at
  /// `first`. `queries` has one query for each place of the row, kRow at most.
  template <class Visit>
  void visitOverlapping(Index first, const std::vector<Bounds>& queries, Visit visit) const {
    if (levels_.empty() || queries.empty()) return;
    Row row{first, 0, {}, rounded(queries[0])};
    for (const Bounds& query : queries) {
      const Node node = row.nodes[row.count++] = rounded(query);
      for (int k = 0; k < D; ++k) {
        row.whole.lower[k] = std::min(row.whole.lower[k], node.lower[k]);
        row.whole.upper[k] = std::max(row.whole.upper[k], node.upper[k]);
      }
    }
    visitGroup(row, static_cast<int>(levels_.size()) - 1, 0, visit);
  }

 private:
  static constexpr int kFanBits = 2;
  static constexpr Index kFan = 1 << kFanBits;
  struct Node {
    std::array<float, D> lower{}, upper{};
  };
  /// Four boxes, stored coordinate by coordinate so that one instruction compares all four. Unused boxes overlap
  /// nothing.
  struct Group {
    std::array<Float4, D> lower, upper;
    Group() {
      for (int k = 0; k < D; ++k) {
        lower[k] = Float4{} + std::numeric_limits<float>::infinity();
        upper[k] = Float4{} - std::numeric_limits<float>::infinity();
      }
    }
    void set(Index i, const Node& node) {
      for (int k = 0; k < D; ++k) {
        lower[k][i] = node.lower[k];
        upper[k][i] = node.upper[k];
      }
    }
    [[nodiscard]] Node whole() const {
      Node node;
      for (int k = 0; k < D; ++k) {
        node.lower[k] = std::min({lower[k][0], lower[k][1], lower[k][2], lower[k][3]});
        node.upper[k] = std::max({upper[k][0], upper[k][1], upper[k][2], upper[k][3]});
      }
      return node;
    }
  };
  static constexpr int kBits = 30 / D;
  static constexpr double kSteps = 1 << kBits;
  static constexpr Index kPerTask = 2048;
  static constexpr std::ptrdiff_t kSorted = 1 << 13;  ///< keys in a block

  template <class Work>
  static void forBlocks(Index count, Poll poll, Work work) {
    if (count <= kPerTask) {
      for (Index i = 0; i < count; ++i) work(i);
      return;
    }
    parallelRanges(count, kPerTask, [&](const auto& range) {
      poll();
      for (Index i = range.begin(); i != range.end(); ++i) work(i);
    });
  }

  static Bounds nothing() {
    constexpr double kLargest = std::numeric_limits<double>::max();
    Bounds none;
    none.lower.fill(kLargest);
    none.upper.fill(-kLargest);
    return none;
  }
  /// Extends the bounds to the finite coordinates of others.
  static void add(Bounds& all, const Bounds& b) {
    for (int k = 0; k < D; ++k) {
      if (std::isfinite(b.lower[k])) all.lower[k] = std::min(all.lower[k], b.lower[k]);
      if (std::isfinite(b.upper[k])) all.upper[k] = std::max(all.upper[k], b.upper[k]);
    }
  }

  /// Puts D - 1 zeros between the bits.
  static std::uint32_t spread(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < kBits; ++bit) result |= (x >> bit & 1U) << (bit * D);
    return result;
  }

  /// Stable radix sort. Each pass counts the digits of blocks and then moves the blocks' entries; the order is that of
  /// sorting all entries as one block.
  static void sortByKey(std::vector<std::pair<std::uint32_t, Index>>& order, Poll poll) {
    if (order.size() < 256) {
      std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      return;
    }
    constexpr int kDigit = 10;
    using Starts = std::array<Index, 1 << kDigit>;
    std::vector<std::pair<std::uint32_t, Index>> other(order.size());
    std::vector<Starts> starts((static_cast<std::ptrdiff_t>(order.size()) + kSorted - 1) / kSorted);
    const auto forBlocksOfOrder = [&](auto work) {
      parallelFor(starts.size(), [&](std::size_t block) {
        poll();
        const auto first = order.begin() + static_cast<std::ptrdiff_t>(block) * kSorted;
        const auto last = block + 1 < starts.size() ? first + kSorted : order.end();
        work(starts[block], first, last);
      });
    };
    for (int shift = 0; shift < kBits * D; shift += kDigit) {
      const auto digitOf = [shift](std::uint32_t key) { return key >> shift & ((1U << kDigit) - 1); };
      forBlocksOfOrder([&](Starts& own, auto first, auto last) {
        own.fill(0);
        for (; first != last; ++first) ++own[digitOf(first->first)];
      });
      Index before = 0;
      for (std::size_t digit = 0; digit < Starts().size(); ++digit)
        for (Starts& own : starts) before += std::exchange(own[digit], before);
      forBlocksOfOrder([&](Starts& own, auto first, auto last) {
        for (; first != last; ++first) other[own[digitOf(first->first)]++] = *first;
      });
      order.swap(other);
    }
  }

  /// Converts a coordinate in the tree's frame to float. The result is never infinite, so that no query overlaps an
  /// unused box.
  static float inFloats(double x) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -kLargest, kLargest));
  }

  Node rounded(const Bounds& b) const {
    Node node;
    for (int k = 0; k < D; ++k) {
      node.lower[k] = inFloats(b.lower[k] - centre_[k]);
      node.upper[k] = inFloats(b.upper[k] - centre_[k]);
    }
    return node;
  }

  /// Bit i: box i of the group overlaps the query.
  static unsigned findHits(const Group& g, const Node& query) {
    Int4 hits = ~Int4{};
    for (int k = 0; k < D; ++k) hits &= (g.lower[k] <= query.upper[k]) & (g.upper[k] >= query.lower[k]);
    return maskOf(hits);
  }

  /// Queries in a row along the curve, and the box around all of them.
  struct Row {
    Index first = 0, count = 0;
    std::array<Node, kRow> nodes;
    Node whole;
  };

  template <class Visit>
  void visitGroup(const Row& row, int level, Index group, Visit& visit) const {
    const Group& g = levels_[level][group];
    unsigned hits = findHits(g, row.whole);
    if (hits == 0) return;
    if (level > 0) {
      for (; hits != 0; hits &= hits - 1) {
        const Index child = group * kFan + std::countr_zero(hits);
        if (lastPlace(child, level) > row.first) visitGroup(row, level - 1, child, visit);
      }
      return;
    }
    for (Index k = 0; k < row.count; ++k)
      for (unsigned own = findHits(g, row.nodes[k]); own != 0; own &= own - 1)
        if (const Index place = group * kFan + std::countr_zero(own); place > row.first + k)
          visit(row.first + k, ids_[place]);
  }

  template <class Visit>
  void visitGroup(const Node& query, int level, Index group, Index first, Visit& visit) const {
    for (unsigned hits = findHits(levels_[level][group], query); hits != 0; hits &= hits - 1) {
      const Index child = group * kFan + std::countr_zero(hits);
      if (lastPlace(child, level) < first) continue;
      if (level == 0)
        visit(ids_[child]);
      else
        visitGroup(query, level - 1, child, first, visit);
    }
  }

  /// The last place below a box of a level.
  static std::int64_t lastPlace(Index box, int level) {
    return ((static_cast<std::int64_t>(box) + 1) << (kFanBits * level)) - 1;
  }

  std::array<double, D> centre_{};
  std::vector<Index> ids_;                  ///< in the order of the curve
  std::vector<std::vector<Group>> levels_;  ///< boxes, then the wholes of groups, up to one group
};

}  // namespace footfall::detail
