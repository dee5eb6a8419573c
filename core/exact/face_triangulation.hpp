// A constrained triangulation of one floor triangle by the segments that obstacles leave on it.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Incremental: points come first (DelaunayInserter), then segments are inserted by flipping edges away, and where two
// segments cross their canonical crossing point becomes a vertex. All decisions are exact. That the triangles are well
// shaped (nearly Delaunay) is a nicety and is judged by rounded coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/delaunay_inserter.hpp"
#include "core/exact/face_geometry.hpp"
#include "core/exact/triangle_facets.hpp"

namespace footfall::detail {

class FaceTriangulation {
 public:
  using Facet = TriangleFacet;
  /// Facts about a facet's edges. Corners and neighbors lie apart: inserting points needs nothing else.
  struct Edges {
    std::array<Index, 3> lines{-1, -1, -1};  ///< supporting line of a constrained edge, else -1
    std::array<int, 3> windings{};           ///< change of the winding number when the edge is entered from outside
    std::array<std::uint8_t, 3> walls{};
  };

  /// `poll` is called now and then and may throw to cancel.
  FaceTriangulation(FaceGeometry& geometry, Poll poll)
      : geometry_(geometry), inserter_(geometry, facets_, poll), poll_(poll) {}
  FaceTriangulation(const FaceTriangulation&) = delete;
  FaceTriangulation& operator=(const FaceTriangulation&) = delete;

  /// Starts with the face of the geometry, and inserts points of the geometry that lie in the closed face: quickest
  /// when each lies near the one before. `edgeWalls`, bit k: the face's edge k (corner k to k + 1) is a wall.
  void start(std::span<const Index> points, unsigned edgeWalls = 0);
  /// The vertex at an inserted point (another point when there was one already).
  [[nodiscard]] Index vertexAt(Index point) const { return representative_[point]; }
  /// Inserts the segment from vertex u to vertex v on `line`; `direction` is +1 when u to v runs along the line.
  /// `winding` is added on its left side.
  void insertSegment(Index u, Index v, Index line, int direction, int winding, bool wall);
  /// Drops constraints without effect.
  void dropConstraints();
  /// Flips edges towards Delaunay between the facets marked in `isWanted`; a flip keeps both winding numbers.
  void improve(const std::vector<char>& isWanted);

  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_.all(); }
  /// One entry per facet.
  [[nodiscard]] const std::vector<Edges>& edges() const { return edges_; }
  /// The facet beside the start of the face's edge from corner 0 to 1.
  [[nodiscard]] Index startFacet() const;
  /// Winding number of each facet: how many regions cover it. `start`: that of startFacet().
  [[nodiscard]] std::vector<int> windingNumbers(int start) const;

 private:
  using Edge = std::array<Index, 2>;
  /// An edge that a segment crosses, and the facets beside it when it was last looked at.
  struct Crossed {
    Edge edge;
    Index facet = -1, other = -1;
    std::uint64_t flips = 0;  ///< flips of both facets until then
    bool isBlocked = false;   ///< it could not be flipped then
  };
  /// Edge k of a facet.
  struct Place {
    Index facet = -1;
    int k = 0;
  };
  /// The segment that is inserted, whose ends are certain to lie on its line.
  struct Segment {
    Index from, to, line;
    int direction, winding;
    bool wall;
  };

  void growTables();
  void makeEdges(unsigned edgeWalls);
  void splitEdge(Index facet, int k, Index point);
  void flip(Index facet, int k);
  /// Notes that a facet has become another one, for improve().
  void touch(Index facet);
  bool flipIfBetter(Index facet, int k);
  bool findEdge(Index a, Index b, Place& place) const;
  /// Marks an edge, which runs along the segment (sign +1) or against it (-1), on both of its sides.
  void mark(const Segment& segment, Place place, int sign);
  /// Marks the edge from a to b along the segment; false when there is none.
  bool markEdge(const Segment& segment, Index a, Index b);
  int sideOfSegment(const Segment& segment, Index vertex);
  /// One step of insertSegment: from u to the next vertex on the segment, marking the edge between, which may be new.
  Index advance(const Segment& segment, Index u);
  /// The next vertex on the segment, which enters a facet at u: a corner, or where it crosses a constrained edge. Makes
  /// the edge to it.
  Index cross(const Segment& segment, Index u, Index facet);
  /// Splits a constrained edge where the segment crosses it.
  Index splitAtCrossing(const Segment& segment, Index facet, int k);
  /// Flips the edges in crossed_ away from the segment.
  void flipAway(const Segment& segment);
  void poll();

  FaceGeometry& geometry_;
  TriangleFacets facets_;
  DelaunayInserter inserter_;
  Poll poll_;
  std::vector<Edges> edges_;           ///< one per facet
  std::vector<char> isTouched_;        ///< one per facet; all edges between other facets are Delaunay
  std::vector<Index> representative_;  ///< -1: not inserted
  std::vector<Index> sideStamp_;
  std::vector<std::int8_t> sideValue_;
  Index stamp_ = 0;
  std::uint32_t polls_ = 0;
  // Working memory, kept for the next face.
  std::vector<Crossed> crossed_;
  std::vector<std::uint64_t> flips_;  ///< of facets: how often flipAway() has changed them
  std::vector<Index> unsettled_;      ///< facets that improve() has to look at
  std::vector<char> isUnsettled_;
};

}  // namespace footfall::detail
