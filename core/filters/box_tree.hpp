// Which of many boxes may overlap a query box? A tree that is built in almost linear time, for one pass of queries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/exact/source_mesh.hpp"

namespace footfall {

/// Boxes of D dimensions in the order of a space-filling curve (Morton's), four of them under each node.
///
/// Boxes are kept as floats relative to a common centre. Both steps, the difference and the conversion, round
/// monotonically: a <= b stays true of the rounded numbers. So boxes that overlap (touching counts) still do.
template <int D>
class BoxTree {
 public:
  struct Bounds {
    std::array<double, D> lower{};
    std::array<double, D> upper{};
  };

  /// `boundsOf(i)` gives box i of `count`; it may be called from any thread. `poll` is called now and then, from any
  /// thread, and may throw.
  template <class BoundsOf>
  void build(Index count, BoundsOf boundsOf, const std::function<void()>& poll) {
    levels_.clear();
    ids_.resize(count);
    if (count == 0) return;
    Bounds all = boundsOf(0);
    for (Index i = 1; i < count; ++i) {
      if (i % kPolled == 0) poll();
      const Bounds b = boundsOf(i);
      for (int k = 0; k < D; ++k) {
        all.lower[k] = std::min(all.lower[k], b.lower[k]);
        all.upper[k] = std::max(all.upper[k], b.upper[k]);
      }
    }
    double extent = 0;
    for (int k = 0; k < D; ++k) {
      centre_[k] = all.lower[k] / 2 + all.upper[k] / 2;
      extent = std::max(extent, all.upper[k] - all.lower[k]);
    }
    std::vector<std::pair<std::uint32_t, Index>> order(count);
    const double scale = extent > 0 ? kCells / extent : 0;
    forBlocks(count, poll, [&](Index i) {
      const Bounds b = boundsOf(i);
      std::uint32_t key = 0;
      for (int k = 0; k < D; ++k) {
        const double place = (b.lower[k] / 2 + b.upper[k] / 2 - all.lower[k]) * scale;
        key |= spread(static_cast<std::uint32_t>(std::clamp(place, 0.0, kCells - 1))) << k;
      }
      order[i] = {key, i};
    });
    sortByKey(order, poll);

    levels_.emplace_back(count);
    forBlocks(count, poll, [&](Index i) {
      ids_[i] = order[i].second;
      levels_[0][i] = rounded(boundsOf(ids_[i]));
    });
    while (levels_.back().size() > kFan) {
      const std::vector<Node>& below = levels_.back();
      std::vector<Node> level((below.size() + kFan - 1) / kFan);
      forBlocks(static_cast<Index>(level.size()), poll, [&](Index i) {
        Node node = below[i * kFan];
        for (std::size_t c = i * kFan + 1; c < std::min<std::size_t>((i + 1) * kFan, below.size()); ++c)
          for (int k = 0; k < D; ++k) {
            node.lower[k] = std::min(node.lower[k], below[c].lower[k]);
            node.upper[k] = std::max(node.upper[k], below[c].upper[k]);
          }
        level[i] = node;
      });
      levels_.push_back(std::move(level));
    }
  }

  /// Calls visit(i) for every box that may overlap the query.
  template <class Visit>
  void visitOverlapping(const Bounds& query, Visit visit) const {
    if (levels_.empty()) return;
    const int top = static_cast<int>(levels_.size()) - 1;
    visitNodes(rounded(query), top, 0, levels_[top].size(), visit);
  }

 private:
  struct Node {
    std::array<float, D> lower{}, upper{};
  };
  static constexpr std::size_t kFan = 4;
  static constexpr int kBits = 30 / D;
  static constexpr double kCells = 1 << kBits;
  static constexpr Index kPerTask = 8192;
  static constexpr Index kPolled = 1 << 16;

  template <class Work>
  static void forBlocks(Index count, const std::function<void()>& poll, Work work) {
    if (count <= kPerTask) {
      for (Index i = 0; i < count; ++i) work(i);
      return;
    }
    tbb::parallel_for(tbb::blocked_range<Index>(0, count, kPerTask), [&](const auto& range) {
      poll();
      for (Index i = range.begin(); i != range.end(); ++i) work(i);
    });
  }

  /// Puts D - 1 zeros between the bits.
  static std::uint32_t spread(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < kBits; ++bit) result |= (x >> bit & 1U) << (bit * D);
    return result;
  }

  /// Radix sort, stable.
  static void sortByKey(std::vector<std::pair<std::uint32_t, Index>>& order, const std::function<void()>& poll) {
    if (order.size() < 256) {
      std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      return;
    }
    constexpr int kDigit = 10;
    std::vector<std::pair<std::uint32_t, Index>> other(order.size());
    for (int shift = 0; shift < kBits * D; shift += kDigit) {
      poll();
      std::array<Index, (1 << kDigit) + 1> start{};
      for (const auto& entry : order) ++start[(entry.first >> shift & ((1U << kDigit) - 1)) + 1];
      for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
      for (const auto& entry : order) other[start[entry.first >> shift & ((1U << kDigit) - 1)]++] = entry;
      order.swap(other);
    }
  }

  Node rounded(const Bounds& b) const {
    Node node;
    for (int k = 0; k < D; ++k) {
      node.lower[k] = static_cast<float>(b.lower[k] - centre_[k]);
      node.upper[k] = static_cast<float>(b.upper[k] - centre_[k]);
    }
    return node;
  }

  static bool overlap(const Node& a, const Node& b) {
    bool result = true;
    for (int k = 0; k < D; ++k) result = result & (a.lower[k] <= b.upper[k]) & (b.lower[k] <= a.upper[k]);
    return result;
  }

  template <class Visit>
  void visitNodes(const Node& query, int level, std::size_t first, std::size_t last, Visit& visit) const {
    const std::vector<Node>& nodes = levels_[level];
    last = std::min(last, nodes.size());
    for (std::size_t i = first; i < last; ++i) {
      if (!overlap(nodes[i], query)) continue;
      if (level == 0)
        visit(ids_[i]);
      else
        visitNodes(query, level - 1, i * kFan, (i + 1) * kFan, visit);
    }
  }

  std::array<double, D> centre_{};
  std::vector<Index> ids_;                 ///< in the order of the curve
  std::vector<std::vector<Node>> levels_;  ///< boxes, then their groups, up to at most four
};

}  // namespace footfall
