// The triangles around chosen vertices of a mesh, kept up to date while triangles change their corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// Doubly linked lists through the corners (3 * triangle + k). Threads may change lists of different vertices at the
/// same time as long as no triangle is in two threads' hands.
class CornerLists {
 public:
  /// Lists the triangles around every vertex with `chosen[v] != 0`.
  void build(const std::vector<MeshTriangle>& triangles, const std::vector<char>& chosen) {
    head_.assign(chosen.size(), kNotChosen);
    for (std::size_t v = 0; v < chosen.size(); ++v)
      if (chosen[v] != 0) head_[v] = kEnd;
    next_.assign(triangles.size() * 3, kEnd);
    previous_.assign(triangles.size() * 3, kEnd);
    for (Index c = 0; c < static_cast<Index>(next_.size()); ++c) insert(triangles[c / 3].corners[c % 3], c);
  }

  void insert(Index vertex, Index corner) {
    Index& head = head_[vertex];
    if (head == kNotChosen) return;
    next_[corner] = head;
    previous_[corner] = kEnd;
    if (head != kEnd) previous_[head] = corner;
    head = corner;
  }

  void erase(Index vertex, Index corner) {
    if (head_[vertex] == kNotChosen) return;
    if (previous_[corner] == kEnd)
      head_[vertex] = next_[corner];
    else
      next_[previous_[corner]] = next_[corner];
    if (next_[corner] != kEnd) previous_[next_[corner]] = previous_[corner];
  }

  /// Calls visit(triangle) for every triangle around a chosen vertex, in no particular order.
  template <class Visit>
  void visit(Index vertex, Visit visit) const {
    for (Index c = head_[vertex]; c >= 0; c = next_[c]) visit(c / 3);
  }

 private:
  static constexpr Index kEnd = -1, kNotChosen = -2;
  std::vector<Index> head_, next_, previous_;
};

}  // namespace footfall::detail
