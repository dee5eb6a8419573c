// Any bytes as a tile: numbers in range that are written and read as the same and can be joined, or one line of error.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A check sum would turn all that a fuzzer changes away, so that the one in the bytes is put right first, unless the
// first byte is not that of the magic word.
#include <cstring>
#include <string>

#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"
#include "core/tiles/tile_regions.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

constexpr std::size_t kHead = 40, kSizeAt = 16;

void putCheckSum(std::string& bytes) {
  ByteWriter out;
  out.fixed(bytes.size() - kHead);
  for (const std::uint64_t word : Digest().add(std::string_view(bytes).substr(kHead)).value()) out.fixed(word);
  bytes.replace(kSizeAt, kHead - kSizeAt, out.bytes);
}

void requireInRange(const Tile& tile) {
  require(tile.exact.size() == tile.places.size(), "a vertex does not say whether it is exact");
  for (const MeshTriangle& triangle : tile.triangles) {
    require(static_cast<std::size_t>(triangle.face) < tile.faces.size(), "a face is out of range");
    for (const Index corner : triangle.corners)
      require(corner >= 0 && static_cast<std::size_t>(corner) < tile.places.size(), "a corner is out of range");
  }
  for (const TileBorder& border : tile.borders)
    require(border.vertex >= 0 && static_cast<std::size_t>(border.vertex) < tile.places.size(),
            "a border is out of range");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(textOf(data, size));
  if (bytes.size() >= kHead && bytes[0] == 'F') putCheckSum(bytes);
  try {
    const Tile tile = decodeTile(bytes);
    requireInRange(tile);
    const std::string again = encodeTile(tile);
    require(encodeTile(decodeTile(again)) == again, "a tile changes when it is written and read");
    const TileRegions regions = findTileRegions(tile, {}, {});
    require(regions.regionOf.size() == tile.triangles.size(), "a triangle is in no region");
    const Tile less = withoutRegions(tile, regions.regionOf, std::vector<char>(regions.areas.size(), 0));
    require(less.triangles.empty() && less.places.empty(), "something is left of nothing");
  } catch (const BadBytes& error) {
    require(std::string_view(error.what()).starts_with("is "), "the message is no end of a sentence");
  }
  return 0;
}
