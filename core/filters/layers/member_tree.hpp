// A set of boxes of which some are members, with the question which members a box touches.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/base/float4.hpp"
#include "core/base/poll.hpp"

namespace footfall::detail {

/// A tree over all boxes whose shape does not change. A node's box is that around its members only, so a look-up costs
/// no more than in a tree of the members, and a box becomes a member in a few steps. Boxes are rounded as in BoxTree.
class MemberTree {
 public:
  using Bounds = BoxTree<2>::Bounds;

  /// `bounds` are those of the boxes, by number. There are no members at first.
  void build(const std::vector<Bounds>& bounds, const Poll& poll);
  void insert(Index box);
  void clear();
  [[nodiscard]] bool isEmpty() const { return nodes_.empty(); }  ///< there are no boxes

  /// Calls visit(box) for each member that may touch the query, until it returns true. Returns whether it did.
  template <class Visit>
  bool visitUntil(const Bounds& query, const Visit& visit) const {
    return !levels_.empty() && visitGroup(rounded(query), static_cast<int>(levels_.size()) - 1, 0, visit);
  }

 private:
  static constexpr int kFanBits = 2;
  static constexpr Index kFan = 1 << kFanBits;
  struct Node {
    std::array<float, 2> lower{}, upper{};
  };
  struct Group {
    std::array<Float4, 2> lower, upper;
    Group() {
      lower.fill(Float4{} + std::numeric_limits<float>::infinity());
      upper.fill(Float4{} - std::numeric_limits<float>::infinity());
    }
  };

  [[nodiscard]] Node rounded(const Bounds& bounds) const;

  template <class Visit>
  bool visitGroup(const Node& query, int level, Index group, const Visit& visit) const {
    const Group& g = levels_[level][group];
    Int4 touching = ~Int4{};
    for (int k = 0; k < 2; ++k) touching &= (g.lower[k] <= query.upper[k]) & (g.upper[k] >= query.lower[k]);
    for (unsigned hits = maskOf(touching); hits != 0; hits &= hits - 1) {
      const Index child = group * kFan + std::countr_zero(hits);
      if (level == 0 ? visit(boxAt_[child]) : visitGroup(query, level - 1, child, visit)) return true;
    }
    return false;
  }

  std::array<double, 2> centre_{};
  std::vector<Node> nodes_;                 ///< of all boxes, along a space-filling curve
  std::vector<Index> boxAt_, placeOf_;      ///< the box at each place along the curve, and the reverse
  std::vector<std::vector<Group>> levels_;  ///< members, then the wholes of groups, up to one group
  std::vector<Index> members_;              ///< their places
};

}  // namespace footfall::detail
