// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/triangle_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace footfall {
namespace {

constexpr std::int32_t kLeafSize = 6;
constexpr std::int32_t kPolledSize = 4096;

}  // namespace

void TriangleTree::build(std::vector<Box> boxes, std::vector<std::int32_t> ids, const std::function<void()>& poll) {
  nodes_.clear();
  boxes_.clear();
  ids_.clear();
  const auto count = static_cast<std::int32_t>(boxes.size());
  if (count == 0) return;
  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(boxes.size() / 2 + 1);
  buildNode(0, count, order, boxes, poll);
  boxes_.reserve(boxes.size());
  ids_.reserve(boxes.size());
  for (const std::int32_t i : order) {
    boxes_.push_back(boxes[i]);
    ids_.push_back(ids[i]);
  }
}

void TriangleTree::buildNode(std::int32_t first, std::int32_t last, std::vector<std::int32_t>& order,
                             const std::vector<Box>& boxes, const std::function<void()>& poll) {
  if (last - first > kPolledSize) poll();
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  Node node;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  node.box.lower.fill(kInfinity);
  node.box.upper.fill(-kInfinity);
  for (std::int32_t i = first; i < last; ++i) {
    for (int k = 0; k < 3; ++k) {
      node.box.lower[k] = std::min(node.box.lower[k], boxes[order[i]].lower[k]);
      node.box.upper[k] = std::max(node.box.upper[k], boxes[order[i]].upper[k]);
    }
  }
  node.first = first;
  node.count = last - first;
  if (node.count > kLeafSize) {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (node.box.upper[k] - node.box.lower[k] > node.box.upper[axis] - node.box.lower[axis]) axis = k;
    const std::int32_t middle = first + node.count / 2;
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                     [&](std::int32_t a, std::int32_t b) {
                       const double ca = boxes[a].lower[axis] * 0.5 + boxes[a].upper[axis] * 0.5;
                       const double cb = boxes[b].lower[axis] * 0.5 + boxes[b].upper[axis] * 0.5;
                       return ca != cb ? ca < cb : a < b;
                     });
    buildNode(first, middle, order, boxes, poll);
    node.right = static_cast<std::int32_t>(nodes_.size());
    buildNode(middle, last, order, boxes, poll);
  }
  nodes_[self] = node;
}

}  // namespace footfall
