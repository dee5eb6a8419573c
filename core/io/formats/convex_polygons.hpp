// Merging the triangles of a navigation mesh into convex polygons, for engines that walk on polygons.
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
  std::size_t maxTriangles = std::numeric_limits<std::uint32_t>::max();  ///< number that one polygon is made of
  /// The largest distance, in the mesh's units, of a polygon's corners from the plane of its largest triangle. Empty:
  /// unlimited.
  std::optional<double> maxHeight = std::nullopt;
};

/// Polygons over the vertices of a mesh, convex and counter-clockwise seen from above. Two neighbours share whole
/// edges.
struct ConvexPolygons {
  std::vector<std::uint32_t> first{0};    ///< the first corner of each polygon; one more entry at the end
  std::vector<std::uint32_t> corners;     ///< vertex numbers
  std::vector<std::uint32_t> neighbours;  ///< for each corner, the polygon beyond the edge to the next corner
  std::vector<std::uint32_t> polygonOf;   ///< for each triangle

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> cornersOf(std::size_t polygon) const {
    return std::span(corners).subspan(first[polygon], first[polygon + 1] - first[polygon]);
  }
};

/// The triangle edge beyond each edge of `triangles`, as 3 * triangle + the corner that it starts from; kNoPolygon
/// where there is no edge or more than one.
std::vector<std::uint32_t> oppositeEdges(std::span<const Triangle> triangles);

/// Merges triangles (counter-clockwise from above, over `vertices`, Z up) over their common edges, the longest edge in
/// the plan first, wherever the union is convex and keeps the rules, and repeats this until nothing changes. The method
/// is greedy, after Hertel and Mehlhorn 1983, whose result has at most four times the least number of polygons; with a
/// limit of corners that bound is lost. A vertex that lies straight between its neighbours, and is a corner of two
/// polygons only on their common side, is left out of both.
///
/// "Convex" and "straight" hold to within 2^-23 of the largest coordinate in the plan, which is the resolution of
/// floats; the result therefore suits formats with floats. `groups` (may be empty) has a number for each triangle;
/// triangles with different numbers never merge. Borders keep their edges, so that an edge of a link is an edge of a
/// polygon. The same input gives the same result. Throws what `poll` throws.
ConvexPolygons mergeTriangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> groups, const MergeRules& rules, Poll poll = {});

}  // namespace footfall::detail
