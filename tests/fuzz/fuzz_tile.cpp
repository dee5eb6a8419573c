// Any bytes as a tile: numbers in range that are written and read as the same and can be joined, or one line of error.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A check sum would turn all that a fuzzer changes away, so that the one in the bytes is put right first, unless the
// first byte is not that of the magic word.
#include <cstring>
#include <string>

#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"
#include "core/tiles/tile_gathering.hpp"
#include "core/tiles/tile_geometry.hpp"
#include "core/tiles/tile_join.hpp"
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
  require(tile.pieces.empty() || tile.pieces.size() == tile.triangles.size(), "a triangle has no place");
  for (const TilePiece& piece : tile.pieces)
    require(piece.plane >= 0 && static_cast<std::size_t>(piece.plane) < tile.faces.size(), "a plane is out of range");
  require(tile.layers.empty() || tile.layers.size() == tile.triangles.size(), "a triangle is in no layer");
  const TileGeometry& geometry = tile.geometry;
  require(geometry.vertices.empty() || geometry.vertices.size() == tile.places.size(), "a vertex is made of nothing");
  const auto isBelow = [](Index number, std::size_t count) {
    require(number >= 0 && static_cast<std::size_t>(number) < count, "a point is of nothing that is there");
    return number;
  };
  const auto corner = [&](Index c) { return isBelow(c, geometry.corners.size()); };
  const auto triangle = [&](Index t) { return isBelow(t, geometry.triangles.size()); };
  for (const MeshVertex& vertex : geometry.vertices) renumbered(vertex.point, corner, corner, triangle);
  for (const TileBorder& border : tile.borders)
    require(border.vertex >= 0 && static_cast<std::size_t>(border.vertex) < tile.places.size(),
            "a border is out of range");
  const std::size_t vertices = tile.places.size() + tile.outside.size();
  for (const TileLink& link : tile.links)
    for (const Index v : {link.from[0], link.from[1], link.to[0], link.to[1]})
      require(v >= 0 && static_cast<std::size_t>(v) < vertices, "a link leads out of range");
}

// Joins the tile by itself and with itself, all of it or some.
void joinSome(const Tile& tile, const TileRegions& regions) {
  std::vector<char> keeps(regions.areas.size(), 1);
  for (std::size_t r = 0; r < keeps.size(); r += 2) keeps[r] = 0;
  const Tile less = withoutRegions(tile, regions.regionOf, keeps);
  requireInRange(less);
  RegionSums sums({});
  sums.add(tile, regions);
  sums.add(less, findTileRegions(less, {}, {}));
  RunContext context;
  TileJoiner joiner;
  joiner.add(less);
  joiner.add(tile);
  const auto mesh = joiner.join(context);
  for (const StepLink& link : mesh->links)
    require(link.fromTriangle < mesh->triangles.size() && link.toTriangle < mesh->triangles.size(),
            "a link has no triangle");
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
    const Tile all = chosenTriangles(tile, std::vector<char>(tile.triangles.size(), 1));
    require(all.triangles.size() == tile.triangles.size(), "a copy is none");
    TileGathering gathering;
    gathering.add(tile, {});
    RunContext context;
    const TileGathering::Whole whole = gathering.take(context);
    require(whole.addedAs.size() == tile.triangles.size(), "a triangle is lost");
    const Tile less = withoutRegions(tile, regions.regionOf, std::vector<char>(regions.areas.size(), 0));
    require(less.triangles.empty() && less.places.empty() && less.links.empty(), "something is left of nothing");
    joinSome(tile, regions);
  } catch (const BadBytes& error) {
    require(std::string_view(error.what()).starts_with("is "), "the message is no end of a sentence");
  }
  return 0;
}
