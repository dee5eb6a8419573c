// SPDX-License-Identifier: GPL-3.0-or-later
#include "city.hpp"

#include <ostream>
#include <string>

#include "props.hpp"
#include "shapes.hpp"

namespace footfall::samples {
namespace {

constexpr int kStreet = 16_m;
constexpr int kBlock = 56_m;
constexpr int kTile = kStreet + kBlock;
constexpr int kKerb = 0.125_m;

// Houses: two columns of three, an alley between the columns and a passage between the rows.
constexpr int kWidth = 20_m, kDepth = 16_m, kPassage = 2_m;
constexpr int kStorey = 3_m, kSlab = 0.25_m, kWall = 0.25_m;
constexpr int kStairsRun = 4.5_m, kStairsWidth = 1.25_m, kSteps = 16;

constexpr int kTunnelDepth = 4_m, kTunnelHeight = 2.75_m, kTunnelWidth = 6_m;
constexpr int kBridgeHeight = 4.5_m, kBridgeWidth = 1.5_m;

bool hasTunnel(int row) { return row % 4 == 1; }
bool hasBridge(int column, int row) { return column > 0 && (column + row) % 3 == 0; }

Random randomOf(int column, int row) {
  return Random(0x9e3779b97f4a7c15U * (static_cast<std::uint64_t>(column) + 1) ^
                0xd1342543de82ef95U * (static_cast<std::uint64_t>(row) + 1));
}

void addStreets(Mesh& mesh, Random& random) {
  mesh.group("streets");
  constexpr int kStep = 8_m;
  grid(mesh, {0, 0, 0}, kTile / kStep, kStreet / kStep, kStep, [](int, int) { return 0; });
  grid(mesh, {0, kStreet, 0}, kStreet / kStep, kBlock / kStep, kStep, [](int, int) { return 0; });
  for (int i = 0; i < 6; ++i) {
    const int along = kStreet + random.between(4_m, kBlock - 4_m);
    const bool isSouth = random.chance(50);
    const Mesh::Frame frame(mesh, isSouth ? Point{along, 3_m, 0} : Point{3_m, along, 0}, isSouth ? 0 : kQuarterTurn);
    if (random.chance(60)) car(mesh);
  }
}

std::vector<Opening> windows(int length, Random& random) {
  std::vector<Opening> openings;
  for (int left = 1.5_m; left + 2_m < length; left += 3_m)
    if (random.chance(80)) openings.push_back(window(left));
  return openings;
}

void addFurniture(Mesh& mesh, Random& random, Point lower, Point upper) {
  for (int x = lower.x + 2_m; x + 2_m <= upper.x; x += 3_m) {
    const Mesh::Frame frame(mesh, {x, random.between(lower.y + 1.5_m, upper.y - 1.5_m), lower.z},
                            random.between(0, 3) * kQuarterTurn);
    switch (random.between(0, 6)) {
      case 0:
        table(mesh, 1.5_m, 1_m);
        break;
      case 1:
        chair(mesh);
        break;
      case 2:
        bed(mesh, 1.5_m);
        break;
      case 3:
        shelf(mesh, 1_m, 4);
        break;
      case 4:
        sofa(mesh, 2_m);
        break;
      default:
        break;
    }
  }
}

// The house extends from the pavement to the roof; its origin is its south-western corner.
void addHouse(Mesh& mesh, Random& random) {
  const int storeys = random.between(1, 5);
  for (int storey = 0; storey < storeys; ++storey) {
    const int z = storey * kStorey;
    // Stairs along the south and the north wall take turns, so that none begins above another one's opening.
    const auto stairsAt = [](int level) {
      return Point{7_m, level % 2 == 0 ? kWall : kDepth - kWall - kStairsWidth, level * kStorey};
    };
    if (storey > 0) {
      const Point hole = stairsAt(storey - 1);
      slabWithHole(mesh, {0, 0, z - kSlab}, {kWidth, kDepth, z}, {hole.x, hole.y, z - kSlab},
                   {hole.x + kStairsRun, hole.y + kStairsWidth, z});
    }
    std::array<std::vector<Opening>, 4> openings{windows(kWidth, random), windows(kDepth - 2 * kWall, random),
                                                 windows(kWidth, random), windows(kDepth - 2 * kWall, random)};
    if (storey == 0) openings[1] = openings[3] = {door(7_m, 1.25_m)};
    shell(mesh, {0, 0, z}, kWidth, kDepth, kStorey - kSlab, kWall, openings);
    // A wall between two rooms, beside the stairs.
    wall(mesh, {kWall, kDepth / 2, z}, kWidth - 2 * kWall, kWall, kStorey - kSlab,
         {door(random.between(1_m, 4_m)), door(14_m, 1.25_m)});
    if (storey + 1 < storeys) {
      const Point lower = stairsAt(storey);
      stairs(mesh, lower, lower + Point{kStairsRun, kStairsWidth, kStorey}, kSteps, random.chance(50));
    }
    addFurniture(mesh, random, {12.5_m, kWall, z}, {kWidth - kWall, kDepth / 2, z});
    addFurniture(mesh, random, {12.5_m, kDepth / 2 + kWall, z}, {kWidth - kWall, kDepth - kWall, z});
  }
  const int top = storeys * kStorey;
  if (random.chance(50)) {
    box(mesh, {0, 0, top - kSlab}, {kWidth, kDepth, top});
  } else {
    gableRoof(mesh, {0, 0, top - kSlab}, kWidth, kDepth, 4_m, 0.5_m, kSlab);
    gableEnds(mesh, {0, 0, top - kSlab}, kWidth, kDepth, 4_m);
  }
}

// The pavement with its houses, and trees in the alley.
void addBlock(Mesh& mesh, Random& random, bool isOverTunnel, Point hole, Point holeEnd) {
  mesh.group("pavement");
  if (isOverTunnel)
    slabWithHole(mesh, {0, 0, 0}, {kBlock, kBlock, kKerb}, hole, holeEnd);
  else
    box(mesh, {0, 0, 0}, {kBlock, kBlock, kKerb});
  mesh.group("houses");
  for (int column = 0; column < 2; ++column)
    for (int row = 0; row < 3; ++row) {
      const Mesh::Frame frame(mesh, {column == 0 ? 2_m : kBlock - 2_m - kWidth, 2_m + row * (kDepth + kPassage), kKerb},
                              0);
      addHouse(mesh, random);
    }
  mesh.group("trees");
  for (int i = 0; i < 4; ++i) {
    const Mesh::Frame frame(mesh, {kBlock / 2 + (i % 2 == 0 ? -3_m : 3_m), 4_m + i * 5_m, kKerb}, 0);
    broadleaf(mesh, random.between(5_m, 8_m), 8);
  }
}

// Below the alley, through the whole tile; the stairs come up between the houses.
void addTunnel(Mesh& mesh, Point hole, Point holeEnd) {
  mesh.group("tunnel");
  const int south = holeEnd.y, north = south + kTunnelWidth, x0 = -kStreet;
  const int first = mesh.vertex({x0, south, -kTunnelDepth});
  mesh.vertex({kBlock, south, -kTunnelDepth});
  mesh.vertex({kBlock, north, -kTunnelDepth});
  mesh.vertex({x0, north, -kTunnelDepth});
  mesh.quad(first, first + 1, first + 2, first + 3);
  const int above = mesh.vertex({x0, south, kTunnelHeight - kTunnelDepth});
  mesh.vertex({kBlock, south, kTunnelHeight - kTunnelDepth});
  mesh.vertex({kBlock, north, kTunnelHeight - kTunnelDepth});
  mesh.vertex({x0, north, kTunnelHeight - kTunnelDepth});
  mesh.quad(above + 3, above + 2, above + 1, above);
  fin(mesh, {x0, north, -kTunnelDepth}, {kBlock, north, -kTunnelDepth}, kTunnelHeight);
  // The landing at the foot of the stairs joins the tunnel's floor.
  const int foot = hole.x - 2_m;
  const int landing = mesh.vertex({foot, hole.y, -kTunnelDepth});
  mesh.vertex({hole.x, hole.y, -kTunnelDepth});
  mesh.vertex({hole.x, south, -kTunnelDepth});
  mesh.vertex({foot, south, -kTunnelDepth});
  mesh.quad(landing, landing + 1, landing + 2, landing + 3);
  fin(mesh, {x0, south, -kTunnelDepth}, {foot, south, -kTunnelDepth}, kTunnelHeight);
  fin(mesh, {hole.x, south, -kTunnelDepth}, {kBlock, south, -kTunnelDepth}, kTunnelHeight);
  stairs(mesh, {hole.x, hole.y, -kTunnelDepth}, {holeEnd.x, holeEnd.y, kKerb}, 24, true);
}

// The bridge crosses the street in the west, from the passage of the block there to that of this one.
void addBridge(Mesh& mesh) {
  mesh.group("bridge");
  const int y = 2_m + kDepth + (kPassage - kBridgeWidth) / 2, run = 9_m, edge = 1_m;
  ramp(mesh, {-kStreet - edge - run, y, kKerb}, {-kStreet - edge, y + kBridgeWidth, kBridgeHeight});
  box(mesh, {-kStreet - edge, y, kBridgeHeight - 0.25_m}, {edge, y + kBridgeWidth, kBridgeHeight});
  const Mesh::Frame frame(mesh, {edge + run, y + kBridgeWidth, 0}, 2 * kQuarterTurn);
  ramp(mesh, {0, 0, kKerb}, {run, kBridgeWidth, kBridgeHeight});
}

}  // namespace

Mesh makeCityTile(int column, int row) {
  Random random = randomOf(column, row);
  Mesh mesh;
  const Mesh::Frame tile(mesh, {column * kTile, row * kTile, 0}, 0);
  addStreets(mesh, random);
  const Mesh::Frame block(mesh, {kStreet, kStreet, 0}, 0);
  const Point hole{kBlock / 2 - 5_m, kBlock / 2 - 1_m, 0};
  const Point holeEnd = hole + Point{9_m, 2_m, kKerb};
  addBlock(mesh, random, hasTunnel(row), hole, holeEnd);
  if (hasTunnel(row)) addTunnel(mesh, hole, holeEnd);
  if (hasBridge(column, row)) addBridge(mesh);
  return mesh;
}

CitySize writeCity(std::ostream& out, std::uint64_t triangles) {
  CitySize size;
  out << Mesh::objHead("City: streets, houses with stairs, footbridges, underpasses.");
  const auto add = [&](int column, int row) {
    if (size.triangles >= triangles) return;
    const Mesh mesh = makeCityTile(column, row);
    out << mesh.objBody(size.vertices);
    ++size.tiles;
    size.triangles += mesh.triangleCount();
    size.vertices += mesh.vertexCount();
  };
  for (int shell = 0; size.triangles < triangles && out; ++shell) {
    for (int row = 0; row < shell; ++row) add(shell, row);
    for (int column = 0; column <= shell; ++column) add(column, shell);
  }
  return size;
}

}  // namespace footfall::samples
