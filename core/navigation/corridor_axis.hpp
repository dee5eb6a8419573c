// The medial axis of a walkable mesh, from its clearance field: where two features of the border are nearest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/clearance_field.hpp"

namespace footfall::detail {

struct AxisNode {
  FieldVector place;
  double distance = 0;  ///< to the border
  std::uint32_t face = 0;
};

/// A piece of the axis within a face, between the regions of two features.
struct AxisArc {
  std::uint32_t from = 0, to = 0;           ///< nodes
  std::array<std::uint32_t, 2> features{};  ///< ascending
  std::array<std::uint32_t, 2> regions{};   ///< of both features, on both sides of the arc
  bool isFirstLeft = false;                 ///< from `from` to `to`, the first feature is on the left
  std::uint32_t face = 0;
};

/// The relation of two features.
enum class AxisPair {
  Apart,   ///< their nearest places differ all along
  Convex,  ///< edges that meet at a convex corner
  Joined   ///< both have the same nearest place: a corner and its edge, or edges that go on straight
};

/// All borders between regions, those of Joined pairs as well: together they divide the mesh into the regions of
/// features.
struct CorridorAxis {
  std::vector<AxisNode> nodes;
  std::vector<AxisArc> arcs;
  /// 1 for each region that reaches its feature. Roundings can divide the places of one feature into several
  /// regions (core/navigation/axis_islands.hpp).
  std::vector<char> reachesBorder;
};

/// The nodes of each mesh edge are computed once and shared by both of its faces. Within a face, the regions of
/// features meet its border, so the axis is a forest whose leaves are those nodes. The forest is found by taking out,
/// one by one, the region that ends nearest at hand, as its labels along the border of the face say; so it hangs
/// together however places are rounded, which are in doubles.
CorridorAxis makeCorridorAxis(const ClearanceField& field, Poll poll = {});

AxisPair pairOf(const ClearanceField& field, std::uint32_t a, std::uint32_t b);

/// The area in the plan between a piece of axis and the nearest places of a feature, where the pair is not Joined.
double areaBeside(const FieldFeature& feature, const FieldFeature& other, FieldVector from, FieldVector to);

/// The area in the plan between an arc and the nearest places of both features.
double areaOf(const ClearanceField& field, const CorridorAxis& axis, const AxisArc& arc);

/// The length of a piece of axis between two features, where the pair is not Joined.
double axisLength(const FieldFeature& a, const FieldFeature& b, FieldVector from, FieldVector to);

/// The place between its ends at which a piece of axis is narrowest: halfway between two corners, or between a corner
/// and its foot on an edge. Nothing where that is an end, or where both features are edges.
std::optional<FieldVector> narrowPlaceOf(const FieldFeature& a, const FieldFeature& b, FieldVector from,
                                         FieldVector to);

/// Returns whether a piece of axis is a parabola: one of the features is an edge, and the other one a corner that is
/// not an end of it.
inline bool isParabola(const FieldFeature& a, const FieldFeature& b, AxisPair pair) {
  return a.isCorner() != b.isCorner() && pair == AxisPair::Apart;
}

}  // namespace footfall::detail
