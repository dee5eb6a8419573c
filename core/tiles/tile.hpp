// A part of an exact walkable area in a file: what local filters leave of some floors, before anything is repaired.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floors belong to one tile as a whole; they are never cut. Where floors of two tiles meet, both have the same vertices
// there, under the same names and with the same doubles, so that tiles can be joined without a tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// Raise this with each change of the bytes, or of the result of a local filter; tiles of other versions are refused.
inline constexpr std::uint64_t kTileVersion = 2;
inline constexpr std::string_view kTileExtension = "fftile";

/// The remainder of one triangle of the environment.
struct TileFace {
  std::uint32_t source = 0;     ///< the triangle's number in the environment
  std::uint32_t triangles = 0;  ///< so many of the tile's, behind those of the faces before; 0 where it is a plane only
  std::array<Vec3, 3> corners;  ///< corners of the whole triangle, the smallest first: all faces are ordered by them
  bool operator==(const TileFace&) const = default;
};

/// The order of SourceMesh::triangles: its vertices are in the order of their coordinates. Of triangles of the
/// environment the same ones alone are equal.
bool comesBefore(const TileFace& a, const TileFace& b);

/// A vertex that triangles or links of other tiles have, too. Its name is its place, `face` and `exact`.
struct TileBorder {
  Index vertex = -1;
  std::uint32_t face = 0;  ///< the first triangle of the environment of which a walkable part has the vertex
  std::string exact;       ///< coordinates "p/q p/q p/q" where doubles do not hold them, else empty
  bool operator==(const TileBorder&) const = default;
};

/// A vertex that only other tiles have, to which a link leads.
struct TileOutside {
  Vec3 place;  ///< its name, together with `face` and `exact`, as in TileBorder
  std::uint32_t face = 0;
  std::string exact;
  bool operator==(const TileOutside&) const = default;
};

/// A link over which one steps between two edges, as in MeshLink; of one of them at least the tile has a triangle.
/// Vertices from the number of the tile's vertices on are those of Tile::outside. Where a link lies between tiles, all
/// tiles that have a triangle of either edge have it, in the same direction.
struct TileLink {
  std::array<Index, 2> from{}, to{};
  /// True when the first of all triangles with that edge, in that direction, is in this tile.
  bool hasFrom = false, hasTo = false;
  bool isGap = false;
  bool operator==(const TileLink&) const = default;
};

/// The position of a triangle among all of its face, some of which may be in other tiles, and the face in whose plane
/// it lies once triangles may span several faces.
struct TilePiece {
  std::uint32_t number = 0;  ///< ascending within a face, over all tiles
  Index plane = -1;          ///< an index into `faces`
  bool operator==(const TilePiece&) const = default;
};

/// A triangle of the environment over other corners.
struct TileSource {
  std::array<Index, 3> corners{};
  std::uint32_t number = 0;  ///< number in the environment
  bool operator==(const TileSource&) const = default;
};

/// The definitions of vertices, kept while a run still has to decide exactly about them.
struct TileGeometry {
  std::vector<double> heights;        ///< PlanKernel::heights()
  std::vector<Vec3> corners;          ///< corners in the environment
  std::vector<TileSource> triangles;  ///< `corners` are indices into the list above
  /// One for each vertex of the tile. Their numbers (of plan ids, vertices and triangles) are places in these lists.
  std::vector<MeshVertex> vertices;
};

struct Tile {
  std::vector<TileFace> faces;          ///< sorted as SourceMesh::triangles
  std::vector<MeshTriangle> triangles;  ///< `face` is an index into `faces`; ascending
  std::vector<Vec3> places;             ///< places of the vertices, in the order of their first use; the nearest
                                        ///< doubles
  std::vector<char> exact;              ///< 1 for each vertex whose place is exact
  std::vector<TileBorder> borders;      ///< ascending by vertex
  std::vector<TileOutside> outside;     ///< sorted by first use
  std::vector<TileLink> links;
  std::vector<TilePiece> pieces;      ///< one for each triangle; empty: numbered from 0 on, in the plane of their face
  std::vector<std::uint32_t> layers;  ///< one for each triangle, or empty
  TileGeometry geometry;              ///< or empty
};

/// The bytes of a tile's file, with a check sum. `poll` is called now and then and may throw to cancel.
std::string encodeTile(const Tile& tile, const Poll& poll = {});
/// Throws BadBytes: no tile, of another version, cut off, damaged or out of range. The message is the end of a sentence
/// that begins with the file's name.
Tile decodeTile(std::string_view bytes, const Poll& poll = {});

}  // namespace footfall::detail
