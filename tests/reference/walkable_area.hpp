// The walkable area straight from the definitions (docs/explanation/model.md): slow, obvious, exact. It shares nothing
// with the core but the environment's data types.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/reference/plan_geometry.hpp"

namespace footfall::reference {

/// True when the angle between the upward normal and +Z is at most `degrees`, exactly. `corners` face up.
bool isWithinSlope(const std::array<Point3, 3>& corners, double degrees);

/// The limits of an agent; empty: the filter does not run.
struct AgentLimits {
  std::optional<double> slope;      ///< degrees
  std::optional<double> clearance;  ///< height, in the environment's units
};

/// Everything that is walkable in one plane. Floors in one plane belong together, as they can overlap there.
struct Region {
  Linear plane;
  std::vector<std::uint32_t> floors;  ///< input triangles that face up, within the slope
  std::vector<Polygon> cells;         ///< the walkable part: disjoint, convex
  std::vector<Segment2> traces;       ///< traces on which walls block, not cut to the floors
};

struct WalkableArea {
  std::vector<Region> regions;
};

/// All triangles with an area are obstacles, vertical ones too; those without any contribute nothing (thesis 3.2,
/// filter 1). Without a clearance each region is
/// the union of its floors and nothing blocks.
WalkableArea computeWalkableArea(const Environment& environment, const AgentLimits& agent);

/// The area in the plan where a triangle is strictly above the plane and strictly below it raised by `height` (closure;
/// empty when it has no area).
Polygon blockedArea(const std::array<Point3, 3>& obstacle, const Linear& floor, const Rational& height);
/// The same for a vertical triangle; nothing for other ones and for those without area.
std::optional<Segment2> blockedTrace(const std::array<Point3, 3>& obstacle, const Linear& floor,
                                     const Rational& height);

/// The definition itself, for one point above which no edge of a triangle passes: is (x, y) on input triangle `floor`
/// free? Coplanar overlap is not looked at.
bool isFree(const Environment& environment, std::uint32_t floor, const Point2& place, double clearance);

/// Zero area: repeated or collinear corners.
bool isDegenerate(const std::array<Point3, 3>& corners);
std::array<Point3, 3> cornersOf(const Environment& environment, std::uint32_t triangle);
/// Returns whether the triangle has no part over or under the box.
bool isBeside(const Environment& environment, std::uint32_t triangle, const PlanBox& box);
/// Returns whether no corner is above `low`, or none is below `high`.
bool isOutOf(const std::array<Point3, 3>& corners, const Rational& low, const Rational& high);
/// The corners of a triangle as a floor: turned up when the environment takes both sides; empty when it cannot be
/// walked on.
std::optional<std::array<Point3, 3>> upwardCorners(const Environment& environment, std::uint32_t triangle);

/// A line on which two cells meet and an agent can cross (uncovered) or not (covered).
struct Meeting {
  std::size_t first = 0, second = 0;  ///< cells, numbered through all regions
  std::vector<Segment2> free;         ///< not covered by a trace
  double freeLength = 0;              ///< length in space, rounded
  double blockedLength = 0;
};

std::vector<Meeting> findMeetings(const WalkableArea& area);

/// The number of each cell's connected part, with cells numbered through all regions; parts are 0, 1, ...
std::vector<std::size_t> connectedParts(const WalkableArea& area, const std::vector<Meeting>& meetings);
std::size_t countParts(const std::vector<std::size_t>& parts);

/// Twice the plan area of a region.
Rational twiceArea(const Region& region);
/// Twice the plan area of everything.
Rational twiceArea(const WalkableArea& area);

}  // namespace footfall::reference
