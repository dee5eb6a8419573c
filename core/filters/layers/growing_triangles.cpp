// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/growing_triangles.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kMostFew = 64;

}  // namespace

BoxTree<2>::Bounds planBoundsOf(const PlanTriangle& p) {
  return {{std::min({p.x[0], p.x[1], p.x[2]}) - p.error, std::min({p.y[0], p.y[1], p.y[2]}) - p.error},
          {std::max({p.x[0], p.x[1], p.x[2]}) + p.error, std::max({p.y[0], p.y[1], p.y[2]}) + p.error}};
}

GrowingTriangles::Tree::Bounds GrowingTriangles::boundsOf(Index triangle) const {
  return planBoundsOf(planTriangleOf(mesh_->vertices, mesh_->triangles[static_cast<std::size_t>(triangle)]));
}

void GrowingTriangles::add(std::span<const Index> triangles, RunContext& context) {
  size_ += triangles.size();
  for (const Index t : triangles) few_.push_back({t, boundsOf(t)});
  if (few_.size() <= kMostFew) return;
  std::vector<Index> together;
  for (const Few& other : few_) together.push_back(other.triangle);
  few_.clear();
  while (!trees_.empty() && static_cast<std::size_t>(trees_.back().size()) <= 2 * together.size()) {
    for (Index place = 0; place < trees_.back().size(); ++place) together.push_back(trees_.back().idAt(place));
    trees_.pop_back();
  }
  trees_.emplace_back();
  trees_.back().build(
      together, [this](Index t) { return boundsOf(t); }, context);
}

}  // namespace footfall::detail
