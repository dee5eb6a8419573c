// A growing set of boxes in the plan, with the question which of them a box touches.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/box_tree.hpp"
#include "core/base/poll.hpp"

namespace footfall::detail {

/// True when two boxes have no inside in common: nor have two triangles within them.
[[nodiscard]] inline bool haveApartInsides(const BoxTree<2>::Bounds& a, const BoxTree<2>::Bounds& b) {
  return a.lower[0] >= b.upper[0] || b.lower[0] >= a.upper[0] || a.lower[1] >= b.upper[1] || b.lower[1] >= a.upper[1];
}

[[nodiscard]] inline bool areApart(const BoxTree<2>::Bounds& a, const BoxTree<2>::Bounds& b) {
  return a.lower[0] > b.upper[0] || b.lower[0] > a.upper[0] || a.lower[1] > b.upper[1] || b.lower[1] > a.upper[1];
}

/// Boxes in trees, each more than twice as large as the next, and the last few in none: adding n boxes one by one takes
/// O(n log^2 n) steps.
class GrowingBoxes {
 public:
  using Bounds = BoxTree<2>::Bounds;
  struct Entry {
    Index id = -1;
    Bounds bounds;
  };

  /// Call settle() behind one call or several.
  void add(Index id, const Bounds& bounds) { few_.push_back({id, bounds}); }
  /// Puts boxes into trees where there are many.
  void settle(const Poll& poll);

  /// Calls visit(id) for each box that touches `bounds`, until it returns true. Returns whether it did.
  template <class Visit>
  bool visitUntil(const Bounds& bounds, const Visit& visit) const {
    bool found = false;
    for (const Part& part : parts_)
      if (!found) part.tree.visitOverlapping(bounds, [&](Index i) { found = found || visit(part.entries[i].id); });
    for (const Entry& other : few_) {
      if (found) break;
      if (!areApart(other.bounds, bounds)) found = visit(other.id);
    }
    return found;
  }

 private:
  struct Part {
    BoxTree<2> tree;  ///< of the numbers of `entries`
    std::vector<Entry> entries;
  };
  std::vector<Part> parts_;
  std::vector<Entry> few_;
};

}  // namespace footfall::detail
