// A bounding-volume tree over boxes: which ones may overlap a query box? Built once for an environment, read by all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace footfall {

struct Box {
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
};

inline bool overlaps(const Box& a, const Box& b) {
  return a.lower[0] <= b.upper[0] && a.upper[0] >= b.lower[0] && a.lower[1] <= b.upper[1] && a.upper[1] >= b.lower[1] &&
         a.lower[2] <= b.upper[2] && a.upper[2] >= b.lower[2];
}

/// Median-split tree with closed boxes in doubles. Touching counts as overlapping, so nothing is missed.
class TriangleTree {
 public:
  TriangleTree() = default;
  /// `ids[i]` is reported for `boxes[i]`. O(n log n), deterministic. `poll` is called now and then and may throw.
  void build(
      std::vector<Box> boxes, std::vector<std::int32_t> ids, const std::function<void()>& poll = [] {});

  /// Calls visit(id) for every box that overlaps `query`. visit returns false to stop.
  template <class Visit>
  void visitOverlapping(const Box& query, std::vector<std::int32_t>& stack, Visit visit) const {
    if (nodes_.empty()) return;
    stack.assign(1, 0);
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!overlaps(node.box, query)) continue;
      if (node.right >= 0) {
        stack.push_back(node.right);
        stack.push_back(static_cast<std::int32_t>(&node - nodes_.data()) + 1);
        continue;
      }
      for (std::int32_t i = node.first; i < node.first + node.count; ++i)
        if (overlaps(boxes_[i], query) && !visit(ids_[i])) return;
    }
  }

  [[nodiscard]] bool empty() const { return nodes_.empty(); }

 private:
  struct Node {
    Box box;
    std::int32_t right = -1;  ///< the left child follows its parent; -1 in a leaf
    std::int32_t first = 0;
    std::int32_t count = 0;
  };
  void buildNode(std::int32_t first, std::int32_t last, std::vector<std::int32_t>& order, const std::vector<Box>& boxes,
                 const std::function<void()>& poll);

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;         ///< in leaf order
  std::vector<std::int32_t> ids_;  ///< in leaf order
};

}  // namespace footfall
