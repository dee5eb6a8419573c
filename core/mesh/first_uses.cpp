// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/first_uses.hpp"

#include "core/base/parallel.hpp"

namespace footfall::detail {

void renumber(std::vector<MeshTriangle>& triangles, const FirstUses& uses, Poll poll) {
  constexpr std::size_t kTrianglesPerTask = 2048;
  forRanges(triangles.size(), kTrianglesPerTask, [&](std::size_t first, std::size_t last) {
    poll();
    for (std::size_t t = first; t < last; ++t)
      for (Index& v : triangles[t].corners) v = uses.numbers[v];
  });
}

}  // namespace footfall::detail
