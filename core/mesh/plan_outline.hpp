// The outlines of a walkable area seen from above, as simple rings: what plans draw and polygon formats hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Vertices in order, each once, the first not repeated. Outer rings are counter-clockwise seen from above.
using PlanRing = std::vector<std::uint32_t>;

/// Triangles that hang together over whole edges.
struct PlanPart {
  PlanRing outer;
  std::vector<PlanRing> holes;           ///< clockwise, by their first vertices
  std::vector<std::uint32_t> triangles;  ///< ascending
};

struct PlanOutline {
  std::vector<PlanPart> parts;  ///< sorted by their first triangles
  /// Edges inside a part that an agent cannot cross: thin walls and ledges. Each once.
  std::vector<std::array<std::uint32_t, 2>> barriers;
};

/// The rule that decides which sides of two triangles are one edge.
enum class EdgeRule {
  Joined,  ///< the same two vertices: an agent crosses it; a thin wall is a hole without an area
  /// The same two places in the plan, whatever the heights: treads of stairs and both sides of a thin wall grow
  /// together, and what cannot be crossed is in PlanOutline::barriers. For formats whose polygons have no slits.
  SamePlace
};

/// `triangles` are numbers of triangles of the mesh, ascending, which for EdgeRule::SamePlace do not overlap in the
/// plan. Each ring passes a place at most once: an outline that touches itself becomes an outer ring and holes that
/// touch it, and parts that touch in one point are two. The continuation of a ring where several meet is decided
/// exactly; features below rounding (2^-40 of the extent, times its length) is left out. By SamePlace, places that lie
/// on a side of the border (within that) cut it, as surfaces that are not joined share no vertices. With `groups`, one
/// for each triangle of the mesh, only triangles of the same group grow together. `poll` may throw.
PlanOutline outlineInPlan(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles, EdgeRule rule,
                          Poll poll = {}, std::span<const std::uint32_t> groups = {});

/// Twice the area inside a ring in the plan, negative for a clockwise one; rounded.
double doubleAreaOf(const NavigationMesh& mesh, const PlanRing& ring);

/// The connected part that each triangle belongs to, over edges and links, numbered as findComponents() does
/// (footfall/inspect.hpp): largest area first, then by their first triangles.
struct NumberedParts {
  std::vector<std::uint32_t> ofTriangle;
  std::vector<double> areas;  ///< surface areas, rounded
};
NumberedParts numberParts(const NavigationMesh& mesh, Poll poll = {});

}  // namespace footfall::detail
