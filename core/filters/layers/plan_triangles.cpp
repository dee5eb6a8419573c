// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/plan_triangles.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPerTask = 2048;

}  // namespace

BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& p) {
  return {{std::min({p.x[0], p.x[1], p.x[2]}) - p.error, std::min({p.y[0], p.y[1], p.y[2]}) - p.error},
          {std::max({p.x[0], p.x[1], p.x[2]}) + p.error, std::max({p.y[0], p.y[1], p.y[2]}) + p.error}};
}

PlanTriangles::PlanTriangles(const WalkableMesh& mesh, RunContext& context)
    : mesh_(mesh), places_(mesh.vertices.size()), bounds_(mesh.triangles.size()) {
  parallelRanges(places_.size(), kPerTask, [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t v = range.begin(); v != range.end(); ++v) places_[v] = planPlaceOf(mesh.vertices[v]);
  });
  parallelRanges(bounds_.size(), kPerTask, [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t t = range.begin(); t != range.end(); ++t) bounds_[t] = planBoundsOf(planOf(static_cast<Index>(t)));
  });
}

}  // namespace footfall::detail
