// Margins of the larger of two distances, by shortest walks, which bend round corners (model, Margins).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// With different distances to walls and ledges, the border that hides another one may keep less away than that one, and
// does not remove the places behind it. There D(p) is the least length of any walk from p, not only of a straight one:
// a straight walk is one of them, so that all goes that a definition by straight ones takes, and with one distance both
// take the same, since a walk that bends at a corner is longer than its part as far as that.
//
// A shortest walk is straight but for corners of the border at which the area reaches round by more than half a turn,
// and it bends towards the border there. Its last leg meets an edge at a right angle, or ends in an end of edges and
// leads away from each of these. So with larger distance r and smaller one s, the places with D(p) < r are those on
// - beams at a right angle to an edge of the larger distance, as far as r and the next border;
// - rays from an end of such edges, as far as r and the next border, in directions that lead away from each;
// - rays from a corner v between edges of the smaller distance as far as r - D(v) and the next border. They matter
//   where that is more than s, as these edges themselves keep s away, and only on the side that the walk to v bends to.
// D(v) follows from corner to corner in ascending order (E. W. Dijkstra, 1959); J. S. B. Mitchell, D. M. Mount and
// C. H. Papadimitriou, "The discrete geodesic problem" (1987), has the same on surfaces that are not flat in the plan.
//
// The polygons are those of core/filters/radius/margins.hpp. On a triangle that beams reach only in part, a polygon
// is cut off at the last beam, two slacks m beyond it. What is taken beyond is within these of a place that a beam
// reaches, so that its D is at most as much more. The length of a leg is taken as 4 units less than doubles have it,
// which is more than rounding makes of the places of its ends: r - D(v) is never too small.
//
// All this is done for edges near which there is one of the smaller distance; others stay as they are.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/filters/radius/beam_windows.hpp"
#include "core/filters/radius/border_chains.hpp"
#include "core/filters/radius/margins.hpp"
#include "core/filters/radius/plan_polygon.hpp"

namespace footfall::detail {

/// The angle between neighbouring tangents of an arc, and how many of them one polygon has.
struct ArcSteps {
  double cosine = 0, sine = 0;
  std::size_t perMargin = 1;
  /// The unit vector that follows clockwise.
  [[nodiscard]] PlanVector next(const PlanVector& d) const {
    return unitOf({cosine * d.x + sine * d.y, cosine * d.y - sine * d.x});
  }
};

class BentMargins {
 public:
  /// `asked` has the distance that each chain keeps, one of two. All arguments must outlive this object.
  BentMargins(const MarginSurface& surface, const ClipBox& box, const std::vector<BorderChain>& chains,
              const std::vector<double>& asked, const ArcSteps& arcs, RunContext& context);

  /// True when the margins of a chain and of its ends are among those that find() returns.
  [[nodiscard]] bool has(Index chain) const { return isBent_[chain] != 0; }
  /// The margins, in an order that depends on the surface alone.
  [[nodiscard]] std::vector<Margin> find() const;

 private:
  /// Directions in which no shortest walk leads on from a place: on the positive side of both unit vectors.
  struct Needless {
    PlanVector one, other;
    double doubt = 0;
  };
  /// A place from which rays start.
  struct Source {
    PlanVector apex;
    std::vector<Index> fan;
    double passed = 0, reach = 0, slack = 0;
    std::vector<Needless> needless;
    PlanVector first;  ///< the direction in which its first arc begins; the others follow clockwise
  };
  /// A walk that comes to a corner.
  struct Arrival {
    Index corner = -1;
    double passed = 0;
    PlanVector along;
    double doubt = 0;  ///< doubt of the direction
  };
  struct Found {
    std::vector<Margin> margins;
    std::vector<Arrival> arrivals;
  };
  struct Polygon;

  void findBent();
  void findCorners();
  [[nodiscard]] bool isLarger(Index chain) const { return chain >= 0 && asked_[chain] == larger_; }
  [[nodiscard]] std::optional<double> turnOf(const std::vector<Index>& fan) const;
  [[nodiscard]] double slackAt(Index corner) const;
  [[nodiscard]] Source sourceAtEnd(Index corner) const;
  [[nodiscard]] Source sourceAtBend(const Arrival& arrival) const;
  void addBeams(const BorderChain& chain, BeamTracer& tracer, Found& found) const;
  void addSectors(const Source& source, BeamTracer& tracer, Found& found) const;
  void addSector(const Source& source, std::span<const PlanVector> directions, BeamTracer& tracer, Found& found) const;
  template <class View>
  void addPieces(const Polygon& polygon, const View& view, BeamTracer& tracer, Found& found) const;
  template <class View>
  void addArrivals(const Polygon& polygon, const View& view, const BeamWindow& window, Found& found) const;
  void addMargin(std::vector<PlanVector> corners, std::vector<Index> faces, Found& found) const;

  const MarginSurface& surface_;
  const ClipBox& box_;
  const std::vector<BorderChain>& chains_;
  const std::vector<double>& asked_;
  ArcSteps arcs_;
  RunContext& context_;
  std::size_t arcCount_ = 0;  ///< number of arcs of a whole turn
  double larger_ = 0, smaller_ = 0;
  std::vector<char> isBent_;
  std::vector<Index> cornerOf_;  ///< chain that ends at the corner, for each side that begins where walks bend
};

}  // namespace footfall::detail
