// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/triangle_facets.hpp"

namespace footfall::detail {

void TriangleFacets::start(const std::array<Index, 3>& corners) {
  facets_.assign(1, {corners, {~corners[0], ~corners[1], ~corners[2]}});
  facetOf_.assign(3, 0);
}

void TriangleFacets::splitFacet(Index facet, Index point) {
  const TriangleFacet old = facets_[facet];
  const auto second = static_cast<Index>(facets_.size()), third = second + 1;
  const auto& [a, b, c] = old.corners;
  const auto& [ab, bc, ca] = old.neighbors;
  facets_[facet] = {{a, b, point}, {ab, second, third}};
  facets_.push_back({{b, c, point}, {bc, third, facet}});
  facets_.push_back({{c, a, point}, {ca, facet, second}});
  replaceNeighbor(bc, facet, second);
  replaceNeighbor(ca, facet, third);
  facetOf_[a] = facetOf_[point] = facet;
  facetOf_[b] = second;
  facetOf_[c] = third;
}

Index TriangleFacets::splitHalf(Index facet, int k, Index point) {
  const TriangleFacet old = facets_[facet];
  const auto second = static_cast<Index>(facets_.size());
  const Index a = old.corners[k], b = old.corners[next(k)], c = old.corners[previous(k)];
  const Index bc = old.neighbors[next(k)], ca = old.neighbors[previous(k)];
  facets_[facet] = {{a, point, c}, {old.neighbors[k], second, ca}};
  facets_.push_back({{point, b, c}, {old.neighbors[k], bc, facet}});
  replaceNeighbor(bc, facet, second);
  facetOf_[a] = facetOf_[c] = facetOf_[point] = facet;
  facetOf_[b] = second;
  return second;
}

void TriangleFacets::splitEdge(Index facet, int k, Index point) {
  const Index other = facets_[facet].neighbors[k];
  const int j = other >= 0 ? neighborSlot(facets_[other], facet) : 0;
  const Index facetEnd = splitHalf(facet, k, point);
  if (other < 0) return;
  const Index otherEnd = splitHalf(other, j, point);
  // both halves were split from their own start, which is the other one's end
  facets_[facet].neighbors[0] = otherEnd;
  facets_[otherEnd].neighbors[0] = facet;
  facets_[facetEnd].neighbors[0] = other;
  facets_[other].neighbors[0] = facetEnd;
}

}  // namespace footfall::detail
