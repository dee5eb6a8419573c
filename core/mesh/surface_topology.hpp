// A navigation mesh as a surface to move on: which sides can be crossed, and what hangs together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Side i of a triangle goes from its corner i to its corner i + 1 (modulo 3), with the triangle on its left.
///
/// A side can be crossed when exactly one other triangle has the same two vertices in the other direction; so obstacle
/// edges, whose sides have vertices of their own, cannot, and neither can an edge with three triangles, which no
/// product has. Two triangles that share nothing but a vertex do not hang together: an agent does not fit through a
/// point, and the area filter counts them as two regions as well. Therefore corners are grouped into *fans*: corners
/// at the same vertex that are connected over sides that can be crossed. A vertex where two parts touch has two fans.
///
/// A step can be crossed, too: in the plan its two sides are one edge. Where an agent could step from one side to
/// several, it is the first of them; where rounding moved the two apart in the plan, to none.
///
/// Triangles that do not face up (exactly), which no product has either, take no part: no side, component kNone.
struct SurfaceTopology {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::vector<std::array<std::uint32_t, 3>> neighbours;  ///< across each side, or kNone
  std::vector<std::array<std::uint32_t, 3>> fans;        ///< fan of each corner
  std::vector<std::uint32_t> fanVertices;  ///< the mesh vertex of each fan; at a step one of those over each other
  std::vector<char> isOpen;                ///< the fan ends at borders: its vertex lies on the border of the surface
  std::vector<std::uint32_t> components;   ///< component of each triangle, numbered from 0 in the order of their first
                                           ///< triangles
  std::uint32_t componentCount = 0;
  /// The number of each side in the neighbour, with kStep where a step leads there.
  std::vector<std::array<std::uint8_t, 3>> across;
  static constexpr std::uint8_t kStep = 4;

  /// The side of `neighbours[triangle][side]` that is this one.
  [[nodiscard]] int sideBehind(std::uint32_t triangle, int side) const {
    const auto& other = fans[neighbours[triangle][side]];
    const std::uint32_t end = fans[triangle][(side + 1) % 3];
    return other[0] == end ? 0 : other[1] == end ? 1 : 2;
  }
};

/// The number that stands for no triangle, side, fan or component, for code outside of the class.
inline constexpr std::uint32_t kNoElement = SurfaceTopology::kNone;

/// Finds neighbours, fans and components in the time of findEdges(). `poll` is called now and then and may throw.
SurfaceTopology makeSurfaceTopology(const NavigationMesh& mesh, Poll poll = {});

struct SurfaceRelation;

/// The topology of `mesh`, as makeSurfaceTopology() gives it, from that of an earlier mesh: neighbours are looked for
/// only around triangles that both do not have.
SurfaceTopology followSurfaceTopology(const NavigationMesh& mesh, const SurfaceTopology& before,
                                      const NavigationMesh& meshBefore, const SurfaceRelation& relation,
                                      Poll poll = {});

}  // namespace footfall::detail
