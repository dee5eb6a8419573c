// Inserts the points of a floor triangle into facets, which stay nearly Delaunay.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lawson's incremental method: a point is found by walking from the one before (so points should come along a curve),
// splits what it lies in, and edges around it are flipped. Where a point lies, and that flips keep all facets the right
// way round, is decided exactly; circles by rounded coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/face_geometry.hpp"
#include "core/exact/triangle_facets.hpp"

namespace footfall::detail {

class DelaunayInserter {
 public:
  /// `facets` has the geometry's face as its first facet, whose corners are the vertices 0, 1, 2. `poll` is called now
  /// and then and may throw to cancel.
  DelaunayInserter(FaceGeometry& geometry, TriangleFacets& facets, Poll poll)
      : geometry_(geometry), facets_(facets), poll_(poll) {}

  /// Forgets where the last point was.
  void start();
  /// Inserts a point that lies in the closed face; returns the vertex at its position (another one when there was one).
  Index insert(Index point);
  /// Returns whether all edges of the facets are Delaunay, as far as rounded coordinates decide it.
  [[nodiscard]] bool isDelaunay() const { return isDelaunay_; }

 private:
  /// A corner relative to the new point, and its distance squared.
  struct Corner {
    double x, y, squared;
  };
  /// Edge k of a facet, from a to b with the new point on its left, to be looked at.
  struct Suspect {
    Index facet;
    int k;
    Corner a, b;
  };
  /// The facet that holds the new point in its closure.
  struct Location {
    Index facet = -1;
    int zeros = 0;  ///< 0 inside, 1 on edge k, 2 on corner k
    int k = 0;
  };

  Location locate();
  int nextRandom() {
    random_ = random_ * 1664525U + 1013904223U;
    return static_cast<int>((random_ >> 16) % 3);
  }
  [[nodiscard]] Corner cornerAt(Index vertex) const {
    const ApproximatePoint& p = geometry_.approximate(vertex);
    const double x = p.x - place_.x, y = p.y - place_.y;
    return {x, y, x * x + y * y};
  }
  /// Flips what the new point makes worse.
  void legalize();
  void poll() {
    if ((++polls_ & 127) == 0) poll_();  // A step on a wide grid can take a tenth of a millisecond.
  }

  FaceGeometry& geometry_;
  TriangleFacets& facets_;
  Poll poll_;
  Index point_ = -1;
  ApproximatePoint place_;  ///< the new point
  std::vector<Suspect> suspects_;
  bool isDelaunay_ = true;
  Index hint_ = 0;
  std::uint32_t random_ = 1;
  std::uint32_t polls_ = 0;
};

}  // namespace footfall::detail
