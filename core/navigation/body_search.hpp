// The search for the shortest way of a disc through the corridor map.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every way of a disc of radius r that stays in the area, whose places are r or more from the border, can be pushed to
// the axis without leaving the area: going away from the border it only gets freer. So it passes the ways of the
// network in some order, and on them, gates: from a place on the axis to its nearest border on the left and on the
// right, less e on both sides, where e is larger than r by 1 / cos(1/20); or the place itself, where the border is
// nearer than e. Among all ways with the same order, the shortest is the taut one (core/navigation/taut_string.hpp).
// Gates turn round a corner of the border by at most a tenth between each other. A gate is taken as the
// straight line between its ends, which lies in the empty disc about its place on the axis, so that this changes no
// way's length.
//
// How far a way stays from the border. Between two gates of a way it goes through the quadrilateral of their ends. The
// left side of that has its ends at r or more from the border on the left. Where that is an edge, the whole side is as
// far. Where it is a corner, both ends are seen from there less than a tenth apart, so that the side, and all places
// behind it, are at r cos(1/20) or more. The right side is the same. Between the last gate of a way and the first one
// of the next it goes through the disc about a vertex. So a way keeps r cos(1/20), 0.99875 r, everywhere, up to the
// errors of the axis. Where the passage is wider than 2 e it keeps r, because the ends are at e then.
//
// Why gates follow each other. About a vertex, the ends of all gates are on one circle, in the order of the borders; so
// the ends of the next gate are ahead of a gate's line. Along a way, an end at an edge moves along the tangent of that
// circle; one at a corner turns round the corner by less than the angle between both borders that lies behind it, which
// is all that is left to turn up to infinity. So it stays ahead, too. Roundings can put it behind, above all where
// edges of the border are nearly one line. keepAhead() (core/navigation/body_gates.hpp) takes such ends back, by exact
// decisions: the triangles between gates turn to the left then, and the funnel is exact for the rounded ends. So the
// way is the shortest one up to how far the ends are rounded.
//
// The search grows orders, and takes first what may be part of the shortest way (A*): up to the last place where every
// way with this order bends, and from there through the last gate to the target, which is mirrored where it lies before
// the gate. An order is dropped only where the shortest way cannot begin with it:
// - its taut way bends at a place that another order has reached on a shorter way;
// - it comes to a vertex v, and another order has come there on a way that is shorter even with the straight line to
//   any place of this order's gate: both are in the empty disc about v, of which D(v) - r is free, and it is convex;
// - it passes a vertex twice (the disc again), or goes into a part of the axis without cycles that has no target.
// There may be very many orders, as between rows of equal containers. After 50,000 orders the search goes on from a
// vertex only with the four that came there first, and the way may not be the shortest. Lengths are sums of rounded
// numbers; an order that is longer by less than 2^-31 of the length stays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/navigation/corridor_network.hpp"
#include "core/navigation/taut_string.hpp"

namespace footfall::detail {

/// A place and where its way to the axis ends.
struct BodyEnd {
  FieldVector place;
  CorridorFoot foot;
};

struct BodyWay {
  std::vector<FieldVector> corners;  ///< from the start to the target
  CorridorNeck neck;                 ///< the narrowest place that it passes
  std::size_t expanded = 0;          ///< orders that were looked at
};

/// Ends of gates are at this multiple of the radius: the corners of polygons around circles.
double polygonFactor();

/// The shortest way for a disc that passes no place narrower than `distance`, its radius or more, to the border on
/// either side. Nothing where there is none.
std::optional<BodyWay> findBodyWay(const CorridorNetwork& network, const BodyEnd& from, const BodyEnd& to,
                                   double radius, double distance, Poll poll);

/// The narrowest place on the way whose narrowest place is widest. Nothing where the network does not lead from one to
/// the other.
std::optional<CorridorNeck> widestNeck(const CorridorNetwork& network, const BodyEnd& from, const BodyEnd& to);

}  // namespace footfall::detail
