// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/member_tree.hpp"

#include <numeric>

namespace footfall::detail {

void MemberTree::build(const std::vector<Bounds>& bounds, const Poll& poll) {
  std::vector<Index> all(bounds.size());
  std::iota(all.begin(), all.end(), Index{0});
  BoxTree<2> curve;
  curve.build(
      all, [&](Index box) { return bounds[box]; }, poll);
  centre_ = curve.centre();
  boxAt_.resize(bounds.size());
  placeOf_.resize(bounds.size());
  nodes_.resize(bounds.size());
  for (Index place = 0; place < curve.size(); ++place) {
    const Index box = curve.idAt(place);
    boxAt_[place] = box;
    placeOf_[box] = place;
    nodes_[place] = rounded(bounds[box]);
  }
  members_.clear();
  levels_.clear();
  for (std::size_t count = bounds.size(); count > 0;) {
    count = (count + kFan - 1) / kFan;
    levels_.emplace_back(count);
    if (count == 1) break;
  }
}

MemberTree::Node MemberTree::rounded(const Bounds& bounds) const {
  constexpr double kLargest = std::numeric_limits<float>::max();
  Node node;
  for (std::size_t k = 0; k < 2; ++k) {
    node.lower[k] = static_cast<float>(std::clamp(bounds.lower[k] - centre_[k], -kLargest, kLargest));
    node.upper[k] = static_cast<float>(std::clamp(bounds.upper[k] - centre_[k], -kLargest, kLargest));
  }
  return node;
}

void MemberTree::insert(Index box) {
  const Index place = placeOf_[box];
  const Node& node = nodes_[place];
  members_.push_back(place);
  Index child = place;
  for (std::vector<Group>& level : levels_) {
    Group& group = level[child / kFan];
    const auto lane = child % kFan;
    bool changed = false;
    for (std::size_t k = 0; k < 2; ++k) {
      if (node.lower[k] < group.lower[k][lane]) group.lower[k][lane] = node.lower[k], changed = true;
      if (node.upper[k] > group.upper[k][lane]) group.upper[k][lane] = node.upper[k], changed = true;
    }
    if (!changed) return;
    child /= kFan;
  }
}

void MemberTree::clear() {
  for (const Index place : members_) {
    Index child = place / kFan;
    for (std::vector<Group>& level : levels_) {
      level[child] = Group();
      child /= kFan;
    }
  }
  members_.clear();
}

}  // namespace footfall::detail
