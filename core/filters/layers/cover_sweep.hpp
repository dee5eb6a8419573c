// Decides whether triangles cover a place in the plan twice, by their outline alone.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All triangles of a walkable mesh turn counter-clockwise in the plan. The number N(p) of triangles of a set that hold
// a point p, which lies on none of their sides, is the sum of the winding numbers of their outlines around p. A side
// that two triangles run along in opposite directions adds nothing to that sum. So N(p) is the winding number around p
// of the sides that are left, the outline of the set. Two triangles of the set overlap exactly where N(p) is 2 or more.
//
// The outline divides the plan into faces on which N is constant. Beyond a side of the outline, N is one larger on its
// left than on its right. A sweep from left to right meets each face first at its leftmost point and computes N there,
// beginning with 0 at the far left. It needs no more than the order of places and the side of a line on which a place
// lies, both of which are exact, as long as no two sides cross between their ends. Where two do cross, each of them has
// its triangle on its left, and half discs on the left of two lines that cross have a sector in common: N is 2 or more
// there. So the first crossing that the sweep finds ends it, and no crossing is ever constructed.
//
// Sides that touch each other are no crossing: at an end of the one within the other, along a piece, or at ends with
// other heights. Sides through one place leave the sweep's order together and return in the order of their directions.
// No more than two sides can run through a place where N is 1 at most, because each has a triangle's half disc there.
// So a sweep of n sides takes O(n log n) steps.
#pragma once

#include <array>
#include <boost/intrusive/set.hpp>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/filters/layers/plan_order.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// Reused from set to set by one thread.
class CoverSweep {
 public:
  /// `order` has all ends of sides, and must outlive this.
  CoverSweep(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices, const PlanOrder& order)
      : geometry_(kernel, vertices), order_(order) {}

  /// A side of a triangle of the set that is no inner one, from corner to corner counter-clockwise.
  using Side = std::array<Index, 2>;

  /// True when the triangles cover some place twice. `outline` has all sides, those first whose left ends are further
  /// left; pairs of opposite ones between the same vertices may be left out.
  bool coversTwice(std::span<const Side> outline, const Poll& poll);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }
  /// The number of exact decisions so far, for tests.
  [[nodiscard]] std::size_t decisions() const { return decisions_; }

 private:
  /// A side from its left end to its right one; between ends above each other, the lower one is the left one.
  /// Places are numbered from left to right (PlanOrder).
  struct Segment : boost::intrusive::set_base_hook<boost::intrusive::optimize_size<true>> {
    Index left = -1, right = -1;
    Index leftPlace = -1, rightPlace = -1;
    int step = 0;   ///< N above the segment without N below it
    int above = 0;  ///< N above the segment
  };
  struct IsBelow;
  using Status = boost::intrusive::multiset<Segment, boost::intrusive::constant_time_size<false>>;

  void setUp(std::span<const Side> outline);
  /// Passes a place. False when that proves that a place is covered twice.
  bool pass(Index place);
  /// Puts the segments that leave the place of a vertex into the order of their directions. False when one of the
  /// faces between them is covered twice; `cover` is N below all of them.
  bool insertLeaving(Index vertex, Status::iterator before, int cover);
  /// True when a segment at the sweep line crosses the next one above it further right.
  bool crosses(const Segment& lower, const Segment& upper);
  int orientation(Index a, Index b, Index c);

  MeshGeometry geometry_;
  const PlanOrder& order_;
  std::size_t decisions_ = 0;
  std::vector<Segment> segments_;  ///< by the places of their left ends
  std::size_t next_ = 0;           ///< the first segment that the sweep has not met
  std::vector<Index> places_;      ///< places of all ends, ascending
  std::vector<Segment*> leaving_;  ///< segments that leave a place to the right
  Status status_;                  ///< segments at the sweep line, from below
};

}  // namespace footfall::detail
