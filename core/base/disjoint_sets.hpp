// Union-find over numbered elements. The smallest number of a set represents it, so results do not depend on the order
// of the unions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Merges the sets of two elements. Returns whether they were two sets.
  bool unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }
  /// Returns the set number of each element; sets are numbered from 0 in the order of their smallest elements.
  std::vector<Index> numbers(Index& setCount) {
    std::vector<Index> numbers(parent_.size());
    setCount = 0;
    for (Index i = 0; i < static_cast<Index>(numbers.size()); ++i) {
      const Index first = find(i);
      numbers[i] = first == i ? setCount++ : numbers[first];
    }
    return numbers;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace footfall::detail
