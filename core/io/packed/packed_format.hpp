// The bytes of a packed environment (.ffenv).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All numbers are little endian; a double is the eight bytes of IEEE 754. Offsets count from the start of the file.
//
// - 128 bytes: PackedHeader.
// - Blocks, each from a multiple of 64 on: coordinates (three doubles for each vertex), numbers of the vertices (32
//   bits), numbers of the faces (32 bits), parts of the faces (32 bits; not there when the environment has no parts),
//   corners (three numbers of 16 bits for each face, into the block's own vertices).
// - From a multiple of 64 on, the coarse faces of all blocks, one block after the other (coarseFaces()): 18 bytes, a
//   PackedCoarseFace, for each. Not in version 1.
// - The description, encodeDescription(): what an environment says of itself apart from its geometry. Its grid is not
//   in versions 1 and 2.
// - From a multiple of 64 on, the table of blocks: 96 bytes, a PackedBlock, for each, and behind them 32 bytes, a
//   PackedCoarse (not in version 1).
//
// A block has the faces that follow each other along a Hilbert curve through the middles of all faces, kBlockFaces of
// them but for the last, and all vertices that they need. Coordinates are those that importing the file gives, in the
// file's own frame. Numbers are those of Environment::vertices and Environment::triangles, so that what is read from
// all blocks is the environment that was packed, to the last bit. A vertex that faces of several blocks need stands in
// each; it belongs to the first of them, where it is among the first `ownVertices`. Vertices of no face come last, in
// blocks without faces.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {

static_assert(std::endian::native == std::endian::little, "packed environments are read as they are");

/// The line ends detect transfers that change them.
inline constexpr std::string_view kPackedMagic{"FFENV\r\n\x1a", 8};
/// The version is raised with each change of the bytes; readers refuse later versions.
inline constexpr std::uint32_t kPackedVersion = 3;
inline constexpr std::string_view kPackedExtension = "ffenv";
/// Indices of corners fit into 16 bits.
inline constexpr std::uint32_t kBlockFaces = 16384, kBlockVertices = 3 * kBlockFaces;
inline constexpr std::uint64_t kBlockAlignment = 64;

using CheckSum = std::array<std::uint64_t, 2>;

/// Check sums are Digest().add(bytes).
struct PackedHeader {
  std::array<char, 8> magic{};
  std::uint32_t version = kPackedVersion;
  std::uint32_t reserved = 0;
  std::uint64_t fileSize = 0;
  std::uint64_t vertices = 0, faces = 0;
  std::uint64_t blocks = 0;
  std::uint64_t tableOffset = 0;
  std::uint64_t descriptionOffset = 0, descriptionSize = 0;
  CheckSum descriptionSum{}, tableSum{};
  CheckSum ownSum{};  ///< sum of the bytes before it
  std::uint64_t unused = 0;
};
static_assert(sizeof(PackedHeader) == 128);
inline constexpr std::size_t kSummedHeader = 104;

/// An entry of the table of blocks.
struct PackedBlock {
  Box box;  ///< box of all its vertices, in the file's frame
  std::uint64_t offset = 0, size = 0;
  std::uint32_t vertices = 0, ownVertices = 0, faces = 0;
  std::uint32_t coarse = 0;  ///< number of coarse faces; 0 in version 1
  CheckSum sum{};
};
static_assert(sizeof(PackedBlock) == 96);

/// The place of all coarse faces. Its check sum covers the bytes of one block after the other.
struct PackedCoarse {
  std::uint64_t offset = 0, size = 0;
  CheckSum sum{};
};
static_assert(sizeof(PackedCoarse) == 32);

/// A step among 65535 from the lower to the upper side of the block's box, for each corner and axis.
using PackedCoarseFace = std::array<std::array<std::uint16_t, 3>, 3>;
static_assert(sizeof(PackedCoarseFace) == 18);

/// The bytes of the table and of everything behind it.
constexpr std::uint64_t tableSize(std::uint64_t blocks, std::uint32_t version) {
  return blocks * sizeof(PackedBlock) + (version > 1 ? sizeof(PackedCoarse) : 0);
}

/// The bytes of a block's arrays.
constexpr std::uint64_t blockSize(std::uint64_t vertices, std::uint64_t faces, bool hasParts) {
  return vertices * (3 * sizeof(double) + sizeof(std::uint32_t)) +
         faces * ((hasParts ? 2 : 1) * sizeof(std::uint32_t) + 3 * sizeof(std::uint16_t));
}

/// The next offset at which a block may begin.
constexpr std::uint64_t alignedOffset(std::uint64_t offset) {
  return (offset + kBlockAlignment - 1) / kBlockAlignment * kBlockAlignment;
}

}  // namespace footfall::detail
