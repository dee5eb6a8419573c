// Convex polygons out of the triangles of a navigation mesh, for engines that walk on polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/geometry.hpp"

namespace footfall::detail {

inline constexpr std::uint32_t kNoPolygon = std::numeric_limits<std::uint32_t>::max();

struct MergeRules {
  std::size_t maxCorners = 6;                                            ///< at least 3
  std::size_t maxTriangles = std::numeric_limits<std::uint32_t>::max();  ///< that one polygon is made of
  /// In the mesh's units: no corner of a polygon is farther from the plane of its largest triangle. Empty: any.
  std::optional<double> maxHeight = std::nullopt;
};

/// Polygons over the vertices of a mesh, convex seen from above, counter-clockwise. Two of them share whole edges.
struct ConvexPolygons {
  std::vector<std::uint32_t> first{0};    ///< for each polygon its first corner; one more at the end
  std::vector<std::uint32_t> corners;     ///< vertex numbers
  std::vector<std::uint32_t> neighbours;  ///< of each corner: the polygon beyond the edge from it to the next one
  std::vector<std::uint32_t> polygonOf;   ///< of each triangle

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> cornersOf(std::size_t polygon) const {
    return std::span(corners).subspan(first[polygon], first[polygon + 1] - first[polygon]);
  }
};

/// The triangle edge, as 3 * triangle + corner that it starts from, beyond each edge of `triangles`; kNoPolygon where
/// there is none, or more than one.
std::vector<std::uint32_t> oppositeEdges(std::span<const Triangle> triangles);

/// Merges triangles (counter-clockwise from above, over `vertices`, Z up) over their common edges, the longest edge in
/// the plan first, wherever the union is convex and keeps the rules, and again until nothing changes (greedy; after
/// Hertel and Mehlhorn 1983, whose result has at most four times as many polygons as the least; with a limit of corners
/// that bound is lost). A vertex that lies straight between its neighbours and is a corner of two polygons only, on
/// their common side, is left out of both.
///
/// "Convex" and "straight" are said to within 2^-23 of the largest coordinate in the plan: what a float can tell. So it
/// is for formats with floats. `groups` (may be empty) has a number for each triangle: different ones never merge.
/// Borders stay edge by edge, so that an edge of a link is an edge of a polygon. Same input, same result. Throws what
/// `poll` throws.
ConvexPolygons mergeTriangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> groups, const MergeRules& rules, Poll poll = {});

}  // namespace footfall::detail
