// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/delaunay_inserter.hpp"

#include <cmath>
#include <stdexcept>

#include "core/exact/shape.hpp"

namespace footfall::detail {

namespace {

/// The limit for one point bounds the time; FaceTriangulation::improve() does the rest.
constexpr int kMostFlips = 500;

}  // namespace

void DelaunayInserter::start() {
  suspects_.clear();
  isDelaunay_ = true;
  hint_ = 0;
  random_ = 1;
}

Index DelaunayInserter::insert(Index point) {
  point_ = point;
  place_ = geometry_.approximate(point);
  const auto [facet, zeros, k] = locate();
  const TriangleFacet old = facets_[facet];
  if (zeros == 2) {
    const Index vertex = old.corners[k];
    geometry_.addBorder(vertex, geometry_.border(point));
    return vertex;
  }
  const Corner a = cornerAt(old.corners[k]), b = cornerAt(old.corners[next(k)]), c = cornerAt(old.corners[previous(k)]);
  const auto added = static_cast<Index>(facets_.size());
  if (zeros == 0) {  // so that k is 0
    facets_.splitFacet(facet, point);
    suspects_.push_back({facet, 0, a, b});
    suspects_.push_back({added, 0, b, c});
    suspects_.push_back({added + 1, 0, c, a});
  } else {
    facets_.splitEdge(facet, k, point);
    suspects_.push_back({facet, 2, c, a});
    suspects_.push_back({added, 1, b, c});
    if (const Index other = old.neighbors[k]; other >= 0) {
      const Corner d = cornerAt(facets_[other].corners[2]);
      suspects_.push_back({other, 2, d, b});
      suspects_.push_back({added + 1, 1, a, d});
    }
  }
  legalize();
  hint_ = facets_.facetOf(point);
  return point;
}

// Edges are tried in a random order, so that walks do not go round in circles. Two of the next facet's corners are
// known from the step before, and the point lies on the inner side of the edge between them.
DelaunayInserter::Location DelaunayInserter::locate() {
  struct Offset {
    double x, y;
  };
  const auto offsetOf = [&](Index vertex) {
    const ApproximatePoint& p = geometry_.approximate(vertex);
    return Offset{p.x - place_.x, p.y - place_.y};
  };
  const double certain = geometry_.certainTurn();
  Location at;
  // True when the point lies beyond the edge from a to b. A point on two edges is at the corner where the second
  // begins.
  const auto isBeyond = [&](const Offset& a, const Offset& b, int k) {
    const double turn = a.x * b.y - a.y * b.x;
    if (turn > certain) return false;
    if (turn < -certain) return true;
    const auto& corners = facets_[at.facet].corners;
    const int s = geometry_.orientation(corners[k], corners[next(k)], point_);
    if (s == 0 && (at.zeros++ == 0 || next(at.k) == k)) at.k = k;
    return s < 0;
  };
  poll();
  at.facet = hint_;
  const auto& corners = facets_[hint_].corners;
  const std::array<Offset, 3> around{offsetOf(corners[0]), offsetOf(corners[1]), offsetOf(corners[2])};
  int left = -1;
  for (int i = 0, k = nextRandom(); i < 3 && left < 0; ++i, k = next(k))
    if (isBeyond(around[k], around[next(k)], k)) left = k;
  if (left < 0) return at;
  Offset start = around[next(left)], end = around[left];  // the edge over which the walk enters the next facet
  for (;;) {
    poll();
    const Index from = at.facet;
    at = {facets_[from].neighbors[left], 0, 0};
    if (at.facet < 0)
      throw std::logic_error("the triangulation of a floor triangle is inconsistent: a point outside the face");
    const TriangleFacet& facet = facets_[at.facet];
    const int entered = neighborSlot(facet, from), last = previous(entered), middle = next(entered);
    const Offset apex = offsetOf(facet.corners[last]);
    const bool isLastFirst = nextRandom() == last;
    bool isLeft = isLastFirst && isBeyond(apex, start, last);
    const bool isOverMiddle = !isLeft && isBeyond(end, apex, middle);
    isLeft = isLeft || isOverMiddle || (!isLastFirst && isBeyond(apex, start, last));
    if (!isLeft) return at;
    left = isOverMiddle ? middle : last;
    (isOverMiddle ? start : end) = apex;
  }
}

// An edge is flipped when the new point p seems to lie well inside the circle through a, d, b, and a, d, b, p are
// strictly convex (exactly). isWellInsideCircle() is repeated here because its products, relative to p, decide both.
void DelaunayInserter::legalize() {
  const double certain = geometry_.certainTurn();
  int flips = 0;
  while (!suspects_.empty()) {
    Suspect& at = suspects_.back();
    const TriangleFacet& facet = facets_[at.facet];
    const Index other = facet.neighbors[at.k];
    const Corner &a = at.a, &b = at.b;
    const auto isWorse = [&](Index apex, const Corner& d) {
      const double ad = a.x * d.y, da = a.y * d.x, db = d.x * b.y, bd = d.y * b.x, ab = a.x * b.y, ba = a.y * b.x;
      const double turnAtA = ad - da, turnAtB = db - bd;
      const double inside = a.squared * turnAtB + b.squared * turnAtA - d.squared * (ab - ba);
      if (!(inside > 0)) return false;  // true of most
      const double size = a.squared * (std::fabs(db) + std::fabs(bd)) + b.squared * (std::fabs(ad) + std::fabs(da)) +
                          d.squared * (std::fabs(ab) + std::fabs(ba));
      return inside > size * kWellInside &&
             (turnAtA > certain || geometry_.orientation(point_, facet.corners[at.k], apex) > 0) &&
             (turnAtB > certain || geometry_.orientation(point_, apex, facet.corners[next(at.k)]) > 0);
    };
    if (other >= 0 && flips < kMostFlips) {
      const Index apex = facets_[other].corners[previous(neighborSlot(facets_[other], at.facet))];
      const Corner d = cornerAt(apex);
      if (isWorse(apex, d)) {
        ++flips;
        poll();
        facets_.flip(at.facet, at.k);
        const Suspect beyond{other, 0, d, b};
        at.k = 0;
        at.b = d;
        suspects_.push_back(beyond);
        continue;
      }
    }
    suspects_.pop_back();
  }
  if (flips == kMostFlips) isDelaunay_ = false;
}

}  // namespace footfall::detail
