// Triangles that share edges and vertices: splitting them, and flipping their edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {

/// A triangle; edge k runs from corner k to corner k + 1.
struct TriangleFacet {
  std::array<Index, 3> corners{};
  std::array<Index, 3> neighbors{};  ///< beyond the first facet's edges negative: ~v, v being where such an edge starts
};

inline int cornerOf(const TriangleFacet& facet, Index vertex) {
  return facet.corners[0] == vertex ? 0 : facet.corners[1] == vertex ? 1 : 2;
}

inline int neighborSlot(const TriangleFacet& facet, Index neighbor) {
  return facet.neighbors[0] == neighbor ? 0 : facet.neighbors[1] == neighbor ? 1 : 2;
}

/// Facets that tile the first one. They are small, because triangulating is mostly flipping; other facts about edges
/// are stored elsewhere (FaceTriangulation).
class TriangleFacets {
 public:
  /// Makes the first facet the only one. Its corners are the vertices 0, 1, 2 in some order.
  void start(const std::array<Index, 3>& corners);
  /// Makes room for vertices with numbers below `count`.
  void growVertices(std::size_t count) {
    if (facetOf_.size() < count) facetOf_.resize(count, -1);
  }

  [[nodiscard]] const std::vector<TriangleFacet>& all() const { return facets_; }
  [[nodiscard]] std::size_t size() const { return facets_.size(); }
  const TriangleFacet& operator[](Index facet) const { return facets_[facet]; }
  /// A facet at a vertex.
  [[nodiscard]] Index facetOf(Index vertex) const { return facetOf_[vertex]; }

  /// Splits a facet at a point inside, which becomes corner 2 of all parts; part i has the edge i of the facet. Part 0
  /// takes the place of the facet, the others are new.
  void splitFacet(Index facet, Index point);
  /// Splits a facet and its neighbor at a point on edge k. Either facet keeps the part at its edge's start (the point
  /// is corner 1); the parts at the ends are new, that of the facet first (the point is corner 0).
  void splitEdge(Index facet, int k, Index point);
  /// Flips edge k of a facet, which has a neighbor there. Edge 1 of the facet and edge 2 of the neighbor are the new
  /// one; edge 0 of both was the neighbor's, the others the facet's.
  void flip(Index facet, int k) {
    TriangleFacet& x = facets_[facet];
    const Index other = x.neighbors[k];
    TriangleFacet& y = facets_[other];
    const int j = neighborSlot(y, facet), beforeK = previous(k), afterK = next(k), beforeJ = previous(j);
    const Index a = x.corners[k], b = x.corners[afterK], c = x.corners[beforeK], d = y.corners[beforeJ];
    const Index ad = y.neighbors[next(j)], db = y.neighbors[beforeJ], bc = x.neighbors[afterK],
                ca = x.neighbors[beforeK];
    x = {{a, d, c}, {ad, other, ca}};
    y = {{d, b, c}, {db, bc, facet}};
    replaceNeighbor(ad, other, facet);
    replaceNeighbor(bc, facet, other);
    facetOf_[c] = facetOf_[a] = facetOf_[d] = facet;
    facetOf_[b] = other;
  }

 private:
  void replaceNeighbor(Index facet, Index from, Index to) {
    if (facet >= 0) facets_[facet].neighbors[neighborSlot(facets_[facet], from)] = to;
  }
  Index splitHalf(Index facet, int k, Index point);

  std::vector<TriangleFacet> facets_;
  std::vector<Index> facetOf_;
};

}  // namespace footfall::detail
