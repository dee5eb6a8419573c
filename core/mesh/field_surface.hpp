// A walkable mesh in the plan, with its sides numbered as edges: what the clearance field spreads over.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A place or a direction in the plan, in doubles.
struct FieldVector {
  double x = 0, y = 0;
};
inline FieldVector operator+(FieldVector a, FieldVector b) { return {a.x + b.x, a.y + b.y}; }
inline FieldVector operator-(FieldVector a, FieldVector b) { return {a.x - b.x, a.y - b.y}; }
inline FieldVector operator*(FieldVector a, double s) { return {a.x * s, a.y * s}; }
inline double dot(FieldVector a, FieldVector b) { return a.x * b.x + a.y * b.y; }
inline double cross(FieldVector a, FieldVector b) { return a.x * b.y - a.y * b.x; }
inline double lengthOf(FieldVector a) { return std::sqrt(dot(a, a)); }
inline FieldVector leftOf(FieldVector a) { return {-a.y, a.x}; }

/// The sides of two faces that can be crossed are one edge, which runs as the side of its first face does.
struct FieldEdge {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  FieldVector begin, along;  ///< `along` has the length 1
  double length = 0;
  std::array<std::uint32_t, 2> faces{kNone,
                                     kNone};  ///< the first has the edge on its left; the second is none at a border
  std::array<std::uint8_t, 2> sides{};

  [[nodiscard]] bool isBorder() const { return faces[1] == kNone; }
  [[nodiscard]] FieldVector at(double s) const { return begin + along * s; }
};

/// Where two faces meet over a step, their sides lie over each other in the plan: there is one edge. Gaps are faces, by
/// withBridges(). Faces that do not face up are left out: all their edges are FieldEdge::kNone.
struct FieldSurface {
  FieldVector origin;  ///< what `places` are relative to: the middle of the mesh
  double scale = 1;    ///< no two places are farther apart in x or in y
  std::vector<FieldVector> places;
  std::vector<Triangle> faces;
  SurfaceTopology topology;
  std::vector<FieldEdge> edges;
  /// The half-edges of each side of a face: twice its edge, and one more where the face is the edge's second one.
  std::vector<std::array<std::uint32_t, 3>> halves;

  [[nodiscard]] FieldVector corner(std::uint32_t face, int i) const { return places[faces[face][i % 3]]; }
  [[nodiscard]] bool takesPart(std::uint32_t face) const { return halves[face][0] != FieldEdge::kNone; }
  [[nodiscard]] const FieldEdge& edgeOf(std::uint32_t face, int side) const { return edges[halves[face][side] >> 1]; }
};

/// A corner of a face.
struct FieldCorner {
  std::uint32_t face = 0;
  int corner = 0;
};

/// The faces around the corner at which a side of the border begins, counter-clockwise from that side to the other one.
std::vector<FieldCorner> fanFrom(const FieldSurface& surface, std::uint32_t face, int side);

/// `bridged` has its gaps as faces. Takes time in proportion to the mesh.
FieldSurface makeFieldSurface(const NavigationMesh& bridged, Poll poll = {});

}  // namespace footfall::detail
