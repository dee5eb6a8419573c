// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/growing_triangles.hpp"

#include <algorithm>

namespace footfall::detail {

BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& p) {
  return {{std::min({p.x[0], p.x[1], p.x[2]}) - p.error, std::min({p.y[0], p.y[1], p.y[2]}) - p.error},
          {std::max({p.x[0], p.x[1], p.x[2]}) + p.error, std::max({p.y[0], p.y[1], p.y[2]}) + p.error}};
}

void GrowingTriangles::add(std::span<const Index> triangles, RunContext& context) {
  size_ += triangles.size();
  for (const Index t : triangles)
    boxes_.add(t, planBoundsOf(planTriangleOf(mesh_->vertices, mesh_->triangles[static_cast<std::size_t>(t)])));
  boxes_.settle(context);
}

}  // namespace footfall::detail
