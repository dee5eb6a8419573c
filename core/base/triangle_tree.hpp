// A bounding-volume tree that finds the boxes that may overlap a query box. It is built once for an environment and
// read by all threads.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes have four children, whose boxes are floats that are compared all at once. Coordinates come into the tree, and
// queries to it, through one function of each axis that never decreases: subtract the middle of the whole, multiply
// with a power of two, cut off what lies far outside and convert to float, where each of the four steps rounds
// monotonically. So lower <= upper stays true whatever is lost, and no overlap is missed; boxes that are apart by less
// than about 2^-23 of the whole may be reported besides.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/float4.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/base/unfilled_array.hpp"

namespace footfall::detail {

/// A box in the frame of a tree, with its number, before it is stored in a node: two halves of 16 bytes.
struct alignas(16) TreeItem {
  std::array<float, 3> lower;
  std::int32_t id;
  std::array<float, 3> upper;
  std::int32_t unused;
};

/// Closed boxes: touching counts as overlapping.
class TriangleTree {
 public:
  /// `ids[i]`, which must not be negative, is reported for `boxes[i]`, which must not hold NaN. O(n log n), in
  /// parallel; the tree depends on nothing but its input. `poll` is called now and then, by any thread, and may throw.
  void build(std::span<const Box> boxes, std::span<const std::int32_t> ids, Poll poll = {});

  /// Builds the tree without a list of boxes: `boxOf(i)` returns the i-th box and may be called by any thread. All
  /// boxes must lie inside `bounds`.
  template <class BoxOf>
  void build(const Box& bounds, std::span<const std::int32_t> ids, const BoxOf& boxOf, Poll poll = {}) {
    setFrame(bounds);
    const auto items = std::make_unique_for_overwrite<TreeItem[]>(ids.size());
    forRanges(ids.size(), kParallelSize, [&](std::size_t first, std::size_t last) {
      poll();
      for (std::size_t i = first; i < last; ++i) {
        const Box box = boxOf(i);
        for (int k = 0; k < 3; ++k) {
          items[i].lower[k] = inFrame(box.lower[k], k);
          items[i].upper[k] = inFrame(box.upper[k], k);
        }
        items[i].id = ids[i];
        items[i].unused = 0;
      }
    });
    grow({items.get(), ids.size()}, poll);
  }

  /// Calls visit(id) for every box that overlaps `query`, and perhaps for some that nearly do, in an order that depends
  /// on the tree alone. visit returns false to stop. `stack` is working memory that the next call can use again.
  template <class Visit>
  void visitOverlapping(const Box& query, std::vector<std::int32_t>& stack, Visit visit) const {
    visitNodes(query, stack, [&](const Node& node, const Range&, unsigned leaves) {
      for (; leaves != 0; leaves &= leaves - 1)
        if (!visit(~node.children[std::countr_zero(leaves)])) return false;
      return true;
    });
  }

  /// Calls visit(id, crosses) like visitOverlapping(). `crosses` is true where the plans of the boxes (the first two
  /// axes) overlap in more than their borders. A false `crosses` is reliable only where isExactOn() the grid of both.
  template <class Visit>
  void visitCrossing(const Box& query, std::vector<std::int32_t>& stack, Visit visit) const {
    visitNodes(query, stack, [&](const Node& node, const Range& range, unsigned leaves) {
      const unsigned crossing = maskOf((node.lower[0] < range.upper[0]) & (node.upper[0] > range.lower[0]) &
                                       (node.lower[1] < range.upper[1]) & (node.upper[1] > range.lower[1]));
      for (; leaves != 0; leaves &= leaves - 1) {
        const int lane = std::countr_zero(leaves);
        if (!visit(~node.children[lane], (crossing >> lane & 1U) != 0)) return false;
      }
      return true;
    });
  }

  /// Returns whether different coordinates stay different in the tree, when the coordinates of its boxes and of queries
  /// are multiples of 2^low below 2^top in size.
  [[nodiscard]] bool isExactOn(int low, int top) const {
    // One monotone function converts all coordinates, so equal ones stay equal. Different ones are 2^low apart, and
    // within the boxes doubles and floats lie closer than that; the origin need be no such multiple (it may be that of
    // an environment before edits). Query coordinates beyond the boxes only stay beyond.
    return top - low <= kDoubleDigits && exponent_ - (low - 1) <= kFloatDigits;
  }

  [[nodiscard]] bool empty() const { return nodes_.size() == 0; }

 private:
  friend class TriangleTreeBuilder;

  struct Node {
    std::array<Float4, 3> lower;  ///< by axis, then child; above every upper bound where there is no child
    std::array<Float4, 3> upper;
    std::array<std::int32_t, 4> children;  ///< a node's index, or ~id of a box
  };

  static constexpr int kFloatDigits = 24, kDoubleDigits = 50;

  /// A query in the tree's frame, each bound in all lanes.
  struct Range {
    std::array<Float4, 3> lower, upper;
  };

  /// Calls visit(node, range, leaves) for each node with boxes that overlap the query; `leaves` has a bit for each of
  /// them.
  template <class Visit>
  void visitNodes(const Box& query, std::vector<std::int32_t>& stack, const Visit& visit) const {
    if (empty()) return;
    if (stack.size() < kStackSize) stack.resize(kStackSize);
    Range range;
    for (int k = 0; k < 3; ++k) {
      range.lower[k] = Float4{} + inFrame(query.lower[k], k);
      range.upper[k] = Float4{} + inFrame(query.upper[k], k);
    }
    const Node* const nodes = &nodes_[0];
    std::int32_t* const bottom = stack.data();
    std::int32_t* top = bottom;
    *top++ = 0;
    while (top != bottom) {
      const Node& node = nodes[*--top];
      const unsigned hits = maskOf((node.lower[0] <= range.upper[0]) & (node.upper[0] >= range.lower[0]) &
                                   (node.lower[1] <= range.upper[1]) & (node.upper[1] >= range.lower[1]) &
                                   (node.lower[2] <= range.upper[2]) & (node.upper[2] >= range.lower[2]));
      const unsigned leaves = hits & maskOf(std::bit_cast<Int4>(node.children));
      for (unsigned inner = hits ^ leaves; inner != 0; inner &= inner - 1)
        *top++ = node.children[std::countr_zero(inner)];
      if (leaves != 0 && !visit(node, range, leaves)) return;
    }
  }

  static constexpr std::size_t kParallelSize = 8192;  ///< fewer boxes are not worth a second thread
  static constexpr float kFar = 4;                    ///< all boxes lie within 2 in the frame
  static constexpr std::size_t kStackSize = 192;      ///< more than the builder's depth can need

  [[nodiscard]] float inFrame(double x, int axis) const {
    return static_cast<float>(std::clamp<double>((x - origin_[axis]) * scale_, -kFar, kFar));
  }

  void setFrame(const Box& bounds);
  void grow(std::span<TreeItem> items, Poll poll);

  std::array<double, 3> origin_{};
  int exponent_ = 0;  ///< all differences to the origin are below 2^exponent
  double scale_ = 1;
  UnfilledArray<Node> nodes_;
};

}  // namespace footfall::detail
