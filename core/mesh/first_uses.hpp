// Numbering vertices in the order in which a list of triangles uses them first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/base/poll.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

struct FirstUses {
  std::vector<Index> numbers;  ///< number of each vertex, or -1 when nothing uses it
  std::vector<Index> order;    ///< the vertices, by number
};

/// `cornersOf(i)` has the vertices of the i-th of `count` triangles, numbered below `vertexCount`; it may be empty. It
/// is as short as a loop can be that no two threads can share; whatever else there is to do with the vertices comes
/// behind it.
template <class CornersOf>
FirstUses findFirstUses(std::size_t count, std::size_t vertexCount, CornersOf cornersOf, Poll poll) {
  constexpr std::size_t kPolled = 1 << 16;
  FirstUses uses;
  uses.numbers.assign(vertexCount, -1);
  uses.order.resize(vertexCount);
  Index next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kPolled == 0) poll();
    for (const Index v : cornersOf(i)) {
      if (uses.numbers[v] >= 0) continue;
      uses.order[next] = v;
      uses.numbers[v] = next++;
    }
  }
  uses.order.resize(next);
  return uses;
}

/// Gives the corners of all triangles those numbers.
void renumber(std::vector<MeshTriangle>& triangles, const FirstUses& uses, Poll poll);

}  // namespace footfall::detail
