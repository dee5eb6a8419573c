// The places too near the border of the walkable area (model, Margins).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// D(p) is the least length, in the plan, of a walk from p to a border of one kind, a wall or a ledge, and r what is to
// stay free of that kind. With one distance that walk is straight where it is shorter than r. One walks over joined
// edges, over steps, and over gaps where they have a bridge; what that surface ends at is border. So nothing with D(p)
// < r is left, and nothing with D(p) > (1 + tolerance) r is lost. The nearest border point of p is inside a border
// edge, then p lies in the rectangle of height r over that edge; or it is the end of an edge, then p lies in a sector
// around it. Where the border goes on with the same r, that is the sector between the normals of both edges, and there
// is one only if it turns by more than half a turn on the walkable side. So the area with D(p) < r is within the union
// of these rectangles and sectors, taken on the surface: on those triangles that a straight walk of at most r from the
// edge or corner reaches. With two distances, walks may bend where an edge of the larger one is near one of the smaller
// one: core/filters/radius/bent_margins.hpp has what follows then.
//
// Each shape is a convex polygon with double corners. The outer edges of a rectangle and the tangents that stand for
// the arc of a sector are drawn at the distance R = r (1 + 2^-46) + m, where m is 32 units of the scaled coordinates
// and what the places of the vertices and of the ends of walls may be off. A corner is computed with an error below
// r 2^-48 + 3 units, and borders that go on straight to within 8 units are one edge: so no outer edge comes nearer to
// its edge or corner than r, and nothing that is nearer than r is left. The tangents meet at R / cos(d / 2), d being
// the angle between neighbours, which is chosen such that this is below (1 + tolerance) r: nothing that is farther is
// lost.
//
// A rectangle and the parts of the sectors at its ends are one polygon where that is convex: up to a quarter of a turn
// on either side. Where the border turns the other way, the rectangles of two long edges overlap, and each ends at
// the bisector: what it would have had beyond is before the other edge, and not farther from that. Both edges must
// reach the same triangles there.
//
// A gap that is stepped over is surface, too, as wide as it is: two triangles of no face between its edges
// (core/mesh/gap_bridges.hpp). Where no other bridge joins their sides, those are borders, as long as the gap is wide:
// a post in a slit may touch nothing else of the surface. So are edges of a gap that have no bridge, as another one
// took its place. Beside the area's own border that is more than the definition requires, at corners of gaps
// (docs/explanation/model.md, Gaps).
//
// A place in a shape, on a reached triangle, that is not reached itself is behind another border, which is nearer
// still: otherwise the straight walk from there to the nearest place of the edge would get there. Reached triangles are
// found in doubles, and in doubt count as reached: this may remove too much only where one triangle is above itself, as
// on a spiral about a post thinner than the radius, and never too little.
//
// The end of a wall on an edge is known to within 2^-38 of the largest coordinate. Doubtful parts count as the kind
// with the larger distance, and parts shorter than twice that count as a point.
#pragma once

#include <array>
#include <vector>

#include "core/filters/radius/margin_surface.hpp"

namespace footfall::detail {

/// A convex polygon of the plan, counter-clockwise; scaled.
struct Margin {
  static constexpr std::size_t kMostCorners = 12;
  std::vector<PlanVector> corners;
  std::vector<Index> faces;  ///< faces that it reaches; ascending
};

/// The distances that stay free from walls and from ledges, at least 0 and not both 0, scaled; and the part of these by
/// which more may be removed, above 0 and at most a tenth.
struct MarginDistances {
  double walls = 0, ledges = 0;
  double tolerance = 0.01;
};

/// All margins of a state that has a mesh, in an order that depends on it alone. If the distances differ, the state's
/// kernel has the levels of its step and its clearance. Throws InputError where a distance is too small beside the
/// coordinates.
std::vector<Margin> findMargins(const WalkableState& state, const MarginDistances& distances, RunContext& context,
                                ExactFallbacks& fallbacks);

}  // namespace footfall::detail
