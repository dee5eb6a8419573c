// The content of a Detour tile set, as the lists that Detour's builder takes. Detour itself is not needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/io/formats/engine_mesh.hpp"

namespace footfall::detail {

inline constexpr std::size_t kDetourCorners = 6;

/// Areas and flags of polygons. They have the values of the Recast demo where it has a matching kind.
inline constexpr std::uint8_t kGroundArea = 0, kJumpArea = 5;
inline constexpr std::uint8_t kFirstLayerArea = 6, kLastArea = 63;
inline constexpr std::uint16_t kWalkFlag = 1, kJumpFlag = 8;

/// Coordinates are x, height, z, in metres. Indices of vertices and neighbours count within the tile.
struct DetourTile {
  int column = 0, row = 0;
  std::array<float, 3> low{}, high{};
  std::vector<float> vertices;
  /// Counter-clockwise from above. Each polygon has 6 corners (0xFFFF: none) and 6 neighbours beyond the edges from
  /// them: a polygon, 0x800F for none, or 0x8000 + direction (0 to 3: -x, +z, +x, -z) for the next tile.
  std::vector<std::uint16_t> polygons;
  std::vector<std::uint8_t> areas;
  std::vector<std::uint16_t> flags;
  /// The triangles of each polygon, so that heights are those of the mesh: first vertex, number of vertices (corners
  /// first), first triangle, number of triangles. Triangles are three indices into its vertices, and which edges are
  /// its border.
  std::vector<unsigned> detailMeshes;
  std::vector<float> detailVertices;
  std::vector<std::uint8_t> detailTriangles;
  /// Off-mesh connections, two places each.
  std::vector<float> jumpPlaces;
  std::vector<std::uint8_t> jumpAreas, jumpBothWays;
  std::vector<std::uint16_t> jumpFlags;

  [[nodiscard]] std::size_t polygonCount() const { return areas.size(); }
  [[nodiscard]] std::size_t jumpCount() const { return jumpAreas.size(); }
  [[nodiscard]] std::size_t vertexCount() const { return vertices.size() / 3; }
};

/// The capacity of a tile. Detour counts in 16 bits, and uses one of them itself in the numbers of polygons.
struct DetourLimits {
  std::size_t polygons = 32'766;  ///< includes jumps
  std::size_t vertices = 65'534;
};

struct DetourTiles {
  std::array<float, 3> origin{};
  float width = 1, height = 1;  ///< size of a tile along x and along z
  std::vector<DetourTile> tiles;
};

/// Makes convex polygons of at most 6 corners in as few tiles as the limits allow (a power of two and the next). A link
/// becomes a neighbour, as if both edges were one; Detour then crosses it on the edge of the polygon that it comes
/// from. A link becomes a jump only where an edge has two links, or where tiles separate its edges. Tiles are cut where
/// no vertex is. A common edge on the border of two tiles that is shorter than Detour joins (2 cm) gets a jump as well.
///
/// Throws InputError where 32 bits cannot number the polygons (above some 2 million), and what `poll` throws.
DetourTiles detourTiles(const EngineMesh& mesh, const DetourLimits& limits = {}, Poll poll = {});

}  // namespace footfall::detail
