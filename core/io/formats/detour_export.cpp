// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/detour_export.hpp"

#include <DetourCommon.h>
#include <DetourNavMesh.h>
#include <DetourNavMeshBuilder.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

static_assert(sizeof(dtTileRef) == 4, "files have references of 32 bits");
static_assert(DT_VERTS_PER_POLYGON == kDetourCorners && DT_NAVMESH_VERSION == 7);

struct DetourFree {
  void operator()(dtNavMesh* mesh) const { dtFreeNavMesh(mesh); }
  void operator()(unsigned char* data) const { dtFree(data); }
};

/// The structures that the Recast demo writes at the beginning of a file and before each tile.
struct SetHeader {
  int magic = 'M' << 24 | 'S' << 16 | 'E' << 8 | 'T';
  int version = 1;
  int tileCount = 0;
  dtNavMeshParams parameters{};
};
struct TileHeader {
  dtTileRef reference = 0;
  int size = 0;
};

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

[[noreturn]] void failBuilding() {
  throw RunError(FOOTFALL_TEXT("Detour does not take the mesh; export as .obj or .glb, and report it, please"));
}

struct AgentSize {
  float height = 0, radius = 0, climb = 0;
};

AgentSize agentSize(const AgentNumbers& numbers, double scale, bool hasSeveralTiles) {
  double climb = std::max(numbers.step * scale, 0.01);
  if (hasSeveralTiles && numbers.height) climb = std::min(climb, 0.49 * *numbers.height * scale);
  return {static_cast<float>(numbers.height.value_or(0) * scale), static_cast<float>(numbers.radius * scale),
          static_cast<float>(climb)};
}

struct TileData {
  std::unique_ptr<unsigned char, DetourFree> bytes;
  int size = 0;
};

TileData buildTile(const DetourTile& tile, const AgentSize& agent) {
  const auto count = [](std::size_t n) { return static_cast<int>(n); };
  // Detour would round these places to 16 bits; see below.
  const std::vector<unsigned short> places(tile.vertices.size());
  const std::vector<float> radii(tile.jumpCount(), std::max(agent.radius, 0.05f));
  dtNavMeshCreateParams params{};
  params.verts = places.data();
  params.vertCount = count(tile.vertexCount());
  params.polys = tile.polygons.data();
  params.polyFlags = tile.flags.data();
  params.polyAreas = tile.areas.data();
  params.polyCount = count(tile.polygonCount());
  params.nvp = count(kDetourCorners);
  params.detailMeshes = tile.detailMeshes.data();
  params.detailVerts = tile.detailVertices.data();
  params.detailVertsCount = count(tile.detailVertices.size() / 3);
  params.detailTris = tile.detailTriangles.data();
  params.detailTriCount = count(tile.detailTriangles.size() / 4);
  params.offMeshConVerts = tile.jumpPlaces.data();
  params.offMeshConRad = radii.data();
  params.offMeshConFlags = tile.jumpFlags.data();
  params.offMeshConAreas = tile.jumpAreas.data();
  params.offMeshConDir = tile.jumpBothWays.data();
  params.offMeshConCount = count(tile.jumpCount());
  params.tileX = tile.column;
  params.tileY = tile.row;
  std::copy(tile.low.begin(), tile.low.end(), params.bmin);
  std::copy(tile.high.begin(), tile.high.end(), params.bmax);
  params.walkableHeight = agent.height;
  params.walkableRadius = agent.radius;
  params.walkableClimb = agent.climb;
  // The unit of the tree's boxes, which have 16 bits along each axis.
  float size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, tile.high[k] - tile.low[k]);
  params.cs = size / 65'000.0f;
  params.ch = params.cs;
  params.buildBvTree = true;

  unsigned char* bytes = nullptr;
  TileData data;
  if (!dtCreateNavMeshData(&params, &bytes, &data.size)) failBuilding();
  data.bytes.reset(bytes);
  std::memcpy(bytes + dtAlign4(sizeof(dtMeshHeader)), tile.vertices.data(), tile.vertices.size() * sizeof(float));
  return data;
}

}  // namespace

bool hasDetour() { return true; }

DetourFile formatDetour(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options,
                        const DetourLimits& limits, Poll poll) {
  const EngineMesh engine = engineMesh(mesh, options);
  const DetourTiles set = detourTiles(engine, limits, poll);
  const AgentSize agent = agentSize(header.numbers, mesh.frame.metresPerUnit * options.scale, set.tiles.size() > 1);
  SetHeader setHeader;
  setHeader.tileCount = static_cast<int>(set.tiles.size());
  dtNavMeshParams& parameters = setHeader.parameters;
  std::copy(set.origin.begin(), set.origin.end(), parameters.orig);
  parameters.tileWidth = set.width;
  parameters.tileHeight = set.height;
  parameters.maxTiles = std::max(setHeader.tileCount, 1);
  parameters.maxPolys = 1;

  DetourFile file;
  file.largestError = engine.largestError;
  file.tiles = set.tiles.size();
  for (const DetourTile& tile : set.tiles) {
    file.polygons += tile.polygonCount();
    file.jumps += tile.jumpCount();
    parameters.maxPolys = std::max(parameters.maxPolys, static_cast<int>(tile.polygonCount() + tile.jumpCount()));
  }
  append(file.bytes, setHeader);
  const std::unique_ptr<dtNavMesh, DetourFree> built(dtAllocNavMesh());
  if (!built || dtStatusFailed(built->init(&parameters))) failBuilding();
  for (const DetourTile& tile : set.tiles) {
    poll();
    TileData data = buildTile(tile, agent);
    TileHeader tileHeader{0, data.size};
    // Adding a tile changes its bytes, so they are written first; the reference is filled in afterwards.
    const std::size_t place = file.bytes.size();
    append(file.bytes, tileHeader);
    file.bytes.append(reinterpret_cast<const char*>(data.bytes.get()), static_cast<std::size_t>(data.size));
    if (dtStatusFailed(built->addTile(data.bytes.get(), data.size, DT_TILE_FREE_DATA, 0, &tileHeader.reference)))
      failBuilding();
    static_cast<void>(data.bytes.release());
    std::memcpy(file.bytes.data() + place, &tileHeader, sizeof tileHeader);
  }
  return file;
}

}  // namespace footfall::detail
