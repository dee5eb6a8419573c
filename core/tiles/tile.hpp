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

/// To be raised with each change of the bytes, or of what a local filter finds; others are refused.
inline constexpr std::uint64_t kTileVersion = 2;
inline constexpr std::string_view kTileExtension = "fftile";

/// What is left of one triangle of the environment.
struct TileFace {
  std::uint32_t source = 0;     ///< the triangle's number in the environment
  std::uint32_t triangles = 0;  ///< so many of the tile's, behind those of the faces before; 0 where it is a plane only
  std::array<Vec3, 3> corners;  ///< of the whole triangle, from its smallest on: the order of all faces goes by them
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
  Vec3 place;  ///< with `face` and `exact` its name, as in TileBorder
  std::uint32_t face = 0;
  std::string exact;
  bool operator==(const TileOutside&) const = default;
};

/// A link over which one steps between two edges, as in MeshLink; of one of them at least the tile has a triangle.
/// Vertices from the number of the tile's vertices on are those of Tile::outside. Where a link lies between tiles, all
/// tiles that have a triangle of either edge have it, in the same direction.
struct TileLink {
  std::array<Index, 2> from{}, to{};
  /// Of all triangles with that edge, in that direction, the first one is of this tile.
  bool hasFrom = false, hasTo = false;
  bool isGap = false;
  bool operator==(const TileLink&) const = default;
};

/// Where a triangle stands among all of its face, of which others may be in other tiles, and in whose plane it lies
/// once triangles may span several faces.
struct TilePiece {
  std::uint32_t number = 0;  ///< ascending within a face, over all tiles
  Index plane = -1;          ///< an index into `faces`
  bool operator==(const TilePiece&) const = default;
};

/// A triangle of the environment over other corners.
struct TileSource {
  std::array<Index, 3> corners{};
  std::uint32_t number = 0;  ///< in the environment
  bool operator==(const TileSource&) const = default;
};

/// What vertices were made of: while a run still has to decide about them exactly.
struct TileGeometry {
  std::vector<double> heights;        ///< PlanKernel::heights()
  std::vector<Vec3> corners;          ///< of the environment
  std::vector<TileSource> triangles;  ///< `corners` are indices into the list above
  /// One for each vertex of the tile. Their numbers (of plan ids, vertices and triangles) are places in these lists.
  std::vector<MeshVertex> vertices;
};

struct Tile {
  std::vector<TileFace> faces;          ///< in the order of SourceMesh::triangles
  std::vector<MeshTriangle> triangles;  ///< `face` is an index into `faces`; ascending
  std::vector<Vec3> places;             ///< of the vertices, in the order of their first use; the nearest doubles
  std::vector<char> exact;              ///< for each vertex, 1 where nothing was lost
  std::vector<TileBorder> borders;      ///< ascending by vertex
  std::vector<TileOutside> outside;     ///< in the order of their first use
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
