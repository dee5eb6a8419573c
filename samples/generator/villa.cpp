// A villa on coarse terrain, with the mesh errors that the thesis names (5.4.1): intersecting, repeated and degenerate
// polygons, repeated vertices, and polygons that cross much without need.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>

#include "props.hpp"
#include "samples.hpp"

namespace footfall::samples {

namespace {

constexpr int kCell = 2.5_m;
constexpr int kCells = 48;  // terrain of 120 m x 120 m around the origin
constexpr int kHalf = kCells * kCell / 2;
constexpr int kWidth = 24_m, kDepth = 16_m, kStorey = 3.5_m, kSlab = 0.5_m;

/// Hills at the rim, level ground around the villa, roughness everywhere else.
class Terrain {
 public:
  Terrain() : heights_((kCells + 1) * (kCells + 1)) {
    Random random(20180);
    for (int row = 0; row <= kCells; ++row)
      for (int column = 0; column <= kCells; ++column) {
        const int x = std::abs(column * kCell - kHalf), y = std::abs(row * kCell - kHalf);
        const int away = std::max({x - 26_m, y - 22_m, 0});
        const Direction wave = direction(column * 190 + row * 70);
        const Direction cross = direction(row * 230 - column * 50);
        const int hills = scaled(away / 8, wave.sin) + scaled(away / 9, cross.cos) + away * (away / 64) / 2_m / 64;
        heights_[row * (kCells + 1) + column] = away == 0 ? 0 : hills + random.between(-8, 8, 2);
      }
  }
  int at(int column, int row) const { return heights_[row * (kCells + 1) + column]; }
  /// The grid point below and left of a place, which is near enough to put objects on it.
  int near(int x, int y) const { return at((x + kHalf) / kCell, (y + kHalf) / kCell); }

 private:
  std::vector<int> heights_;
};

void ground(Mesh& mesh, const Terrain& terrain, Random& random) {
  mesh.group("terrain");
  grid(mesh, {-kHalf, -kHalf, 0}, kCells, kCells, kCell, [&](int column, int row) { return terrain.at(column, row); });
  // Patches that are there twice, with vertices of their own, and some a little off.
  mesh.group("terrain_again");
  for (int i = 0; i < 24; ++i) {
    const int column = random.between(2, kCells - 8), row = random.between(2, kCells - 8);
    const int lift = i % 3 == 0 ? 2 : 0;
    grid(mesh, {column * kCell - kHalf, row * kCell - kHalf, lift}, 3, 3, kCell,
         [&](int c, int r) { return terrain.at(column + c, row + r); });
  }
  // Long slivers that cross the terrain far and wide, and triangles without area.
  mesh.group("extraneous");
  for (int i = 0; i < 24; ++i) {
    const Point a{random.between(-50_m, 50_m, 8), random.between(-55_m, -30_m, 8), -0.5_m};
    mesh.polygon({a, a + Point{0.25_m, 0, 0}, {a.x + random.between(-6_m, 6_m, 4), a.y + 24_m, 1.5_m}});
  }
  for (int i = 0; i < 12; ++i) {
    const Point a{random.between(-50_m, 50_m, 64), random.between(-50_m, 50_m, 64), 0};
    mesh.polygon({a, a + Point{2_m, 0, 0}, a + Point{i % 2 == 0 ? 4_m : 2_m, 0, 0}});
  }
  mesh.group("rocks");
  for (int i = 0; i < 40; ++i) {
    const int x = random.between(-57_m, 57_m, 16), y = random.between(-57_m, 57_m, 16);
    if (std::abs(x) < 30_m && std::abs(y) < 26_m) continue;
    const Mesh::Frame frame(mesh, {x, y, terrain.near(x, y) - 0.75_m}, random.between(0, kTurn - 1));
    const int size = random.between(1_m, 2.5_m, 8);
    loft(mesh, {polygonRing({}, size, 7), polygonRing({size / 4, 0, size / 2}, size * 3 / 4, 7, 290),
                polygonRing({0, size / 5, size}, size / 3, 7, 150)});
  }
}

/// One room's furniture, between its walls; `kind` picks what the room is for.
void furnish(Mesh& mesh, Point lower, int width, int depth, int kind, Random& random) {
  const auto put = [&](int x, int y, int quarter, auto&& thing) {
    const Mesh::Frame frame(mesh, lower + Point{x, y, 0}, quarter * kQuarterTurn);
    thing();
  };
  const int shelves = random.between(1, 2);
  for (int i = 0; i < shelves; ++i)
    put(1.25_m + i * 1.25_m, depth - 0.25_m, 0, [&] { shelf(mesh, 1.125_m, random.between(3, 5)); });
  switch (kind) {
    case 0:  // dining room
      put(width / 2, depth / 2, 0, [&] { table(mesh, 2.5_m, 1.125_m); });
      for (int i = -1; i <= 1; ++i)
        for (int side : {0, 2})
          put(width / 2 + i * 0.75_m, depth / 2 + (side == 0 ? 0.75_m : -0.75_m), side, [&] { chair(mesh); });
      break;
    case 1:  // living room
      put(width / 2, depth / 2 + 1_m, 0, [&] { sofa(mesh, 2.25_m); });
      put(width / 2 - 1.75_m, depth / 2 - 0.5_m, 1, [&] { sofa(mesh, 1.5_m); });
      put(width / 2, depth / 2 - 0.5_m, 0, [&] { post(mesh, {}, 1.25_m, 0.75_m, 0.4375_m); });
      put(width - 1_m, 1_m, 0, [&] { broadleaf(mesh, 1.75_m, 7); });
      break;
    case 2:  // bedroom
      put(width / 2, depth - 1.75_m, 0, [&] { bed(mesh, 1.75_m); });
      put(width - 0.75_m, 1_m, 1, [&] { wardrobe(mesh, 1.5_m); });
      put(1_m, 1_m, random.between(0, 3), [&] { chair(mesh); });
      break;
    case 3:  // kitchen
      put(width - 0.625_m, 0.5_m, 1, [&] { kitchen(mesh, 5); });
      put(width / 2 - 0.5_m, depth / 2, 0, [&] { table(mesh, 1.25_m, 1.25_m); });
      for (int i = 0; i < 4; ++i) {
        const int x[] = {0, 1, 0, -1}, y[] = {1, 0, -1, 0};
        put(width / 2 - 0.5_m + x[i] * 0.75_m, depth / 2 + y[i] * 0.75_m, (4 - i) % 4, [&] { chair(mesh); });
      }
      break;
    default:  // study
      put(width / 2, depth / 2, 0, [&] { table(mesh, 1.5_m, 0.75_m); });
      put(width / 2, depth / 2 + 0.625_m, random.between(0, 3), [&] { chair(mesh); });
      put(0.375_m, depth / 2, 1, [&] { shelf(mesh, 2_m, 5); });
      put(width - 0.375_m, depth / 2, 3, [&] { shelf(mesh, 2_m, 4); });
      break;
  }
}

/// Outer and inner walls, rooms, and the stairs to the next storey, with its floor at the origin.
void storey(Mesh& mesh, int number, Random& random) {
  const auto group = [&](std::string name) { mesh.group(name.append(std::to_string(number))); };
  group("walls_");
  const std::vector<Opening> front{window(1.5_m),  window(5_m),    window(8_m), door(11_m, 2_m),
                                   window(14.5_m), window(17.5_m), window(21_m)};
  const std::vector<Opening> back{window(1.5_m), window(5_m), door(11.25_m, 1.5_m), window(17.5_m), window(21_m)};
  const std::vector<Opening> side{window(2_m), window(5.5_m), window(9_m), window(12.5_m)};
  shell(mesh, {}, kWidth, kDepth, kStorey - kSlab, 0.25_m, {{front, side, back, side}});
  // A corridor through the middle, three rooms on either side; the middle room in the north holds the stairs.
  for (int y : {6.5_m, 9_m})
    wall(mesh, {0.25_m, y, 0}, kWidth - 0.5_m, 0.125_m, kStorey - kSlab,
         {door(3.5_m), door(11_m, 1.5_m), door(19.5_m)});
  for (int x : {8_m, 16_m}) {
    const Mesh::Frame frame(mesh, {x, 0.25_m, 0}, kQuarterTurn);
    wall(mesh, {}, 6.25_m, 0.125_m, kStorey - kSlab);
    wall(mesh, {8.875_m, 0, 0}, 6.625_m, 0.125_m, kStorey - kSlab, {door(2_m)});
  }
  group("furniture_");
  for (int i = 0; i < 3; ++i) {
    const int x = i * 8_m + 0.25_m;
    furnish(mesh, {x, 0.5_m, 0}, 7.5_m, 5.75_m, (number + i) % 5, random);
    if (i != 1) furnish(mesh, {x, 9.5_m, 0}, 7.5_m, 6_m, (number + i + 3) % 5, random);
  }
  if (number == 3) return;
  group("stairs_");
  stairs(mesh, {9.5_m, 13_m, 0}, {15_m, 15.5_m, kStorey}, 16, true);
  {
    const Mesh::Frame frame(mesh, {9_m, 12.875_m, kStorey}, 0);
    balustrade(mesh, 6_m, 0.25_m);
  }
}

void building(Mesh& mesh, Random& random) {
  mesh.group("plinth");
  box(mesh, {-3_m, -6_m, -1_m}, {kWidth + 3_m, kDepth + 3_m, 0.5_m});
  {
    const Mesh::Frame frame(mesh, {kWidth / 2, -9.5_m, 0}, kQuarterTurn);
    ramp(mesh, {0, -2_m, 0}, {3.5_m, 2_m, 0.5_m});
  }
  for (int number = 1; number <= 3; ++number) {
    const Mesh::Frame frame(mesh, {0, 0, 0.5_m + (number - 1) * kStorey}, 0);
    storey(mesh, number, random);
    mesh.group("floors");
    const Point lower{0, 0, kStorey - kSlab}, upper{kWidth, kDepth, kStorey};
    if (number < 3) {
      slabWithHole(mesh, lower, upper, {9_m, 12.875_m, lower.z}, {15_m, 15.5_m, upper.z});
    } else {
      box(mesh, lower, upper);
    }
    // Balconies along the front, on columns.
    if (number < 3) box(mesh, {4_m, -4_m, lower.z}, {20_m, 0, upper.z});
    mesh.group("columns");
    if (number < 3)
      for (int x = 4.5_m; x <= 19.5_m; x += 3_m) cylinder(mesh, {x, -3.5_m, 0}, 0.25_m, kStorey - kSlab, 12);
    mesh.group("balustrades");
    const Mesh::Frame rail(mesh, {4_m, -3.875_m, kStorey}, 0);
    if (number < 3) balustrade(mesh, 16_m, 0.25_m);
  }
  mesh.group("roof");
  const int top = 0.5_m + 3 * kStorey;
  gableRoof(mesh, {0, 0, top}, kWidth, kDepth, 8.5_m, 1_m, 0.25_m);
  gableEnds(mesh, {0, 0, top}, kWidth, kDepth, 8.5_m);
  for (int x : {4_m, 18_m}) box(mesh, {x, 9_m, top}, {x + 1.5_m, 10.5_m, top + 10_m});
  mesh.group("turret");
  {
    const Point foot{kWidth, kDepth, 0.5_m + kHair};
    cylinder(mesh, foot, 3_m, 14.5_m, 16);
    cone(mesh, polygonRing(foot + Point{0, 0, 14.5_m}, 3.5_m, 16), foot + Point{0, 0, 20_m});
  }
}

void garden(Mesh& mesh, const Terrain& terrain, Random& random) {
  mesh.group("drive");  // laid over the terrain without regard for it
  for (int i = 0; i < 12; ++i) {
    const int y = -20_m - i * 3_m;
    const int z = terrain.near(0, y) + 0.125_m, next = terrain.near(0, y - 3_m) + 0.125_m;
    mesh.polygon({{-2.5_m, y - 3_m, next}, {2.5_m, y - 3_m, next}, {2.5_m, y, z}, {-2.5_m, y, z}});
  }
  mesh.group("pool");
  box(mesh, {-24_m, -10_m, -0.5_m}, {-16_m, -9.5_m, 0.25_m});
  box(mesh, {-24_m, 5.5_m, -0.5_m}, {-16_m, 6_m, 0.25_m});
  box(mesh, {-24_m, -9.5_m, -0.5_m}, {-23.5_m, 5.5_m, 0.25_m});
  box(mesh, {-16.5_m, -9.5_m, -0.5_m}, {-16_m, 5.5_m, 0.25_m});
  mesh.group("fence");
  const int x = 25_m, y = 21_m;
  const Point corner[] = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
  for (int side = 0; side < 4; ++side) {
    const Mesh::Frame frame(mesh, corner[side], side * kQuarterTurn);
    if (side == 0) {
      railFence(mesh, 20_m, 2_m);
      const Mesh::Frame beyond(mesh, {30_m, 0, 0}, 0);
      railFence(mesh, 20_m, 2_m);
    } else {
      railFence(mesh, side == 2 ? 50_m : 42_m, 2_m);
    }
  }
  mesh.group("hedges");
  for (int i = 0; i < 16; ++i)
    post(mesh, {-22_m + i % 8 * 2_m, i < 8 ? 18_m : 14.5_m, -0.25_m}, 1.875_m, 0.75_m, 1.25_m);
  mesh.group("benches");
  for (int i = 0; i < 10; ++i) {
    const Mesh::Frame frame(mesh, {-20_m + i * 4.5_m, -18_m, 0}, random.between(0, kTurn - 1));
    bench(mesh);
  }
  mesh.group("cars");
  for (int i = 0; i < 4; ++i) {
    const Mesh::Frame frame(mesh, {9_m + i * 4_m, -17_m + i % 2 * 0.5_m, 0}, kQuarterTurn + 40 * i);
    car(mesh);
  }
  mesh.group("trees");
  for (int i = 0; i < 150; ++i) {
    const int tx = random.between(-57_m, 57_m, 16), ty = random.between(-57_m, 57_m, 16);
    if (std::abs(tx) < 28_m && std::abs(ty) < 24_m) continue;
    if (std::abs(tx) < 5_m && ty < 0) continue;
    const Mesh::Frame frame(mesh, {tx, ty, terrain.near(tx, ty) - 0.25_m}, random.between(0, kTurn - 1));
    if (random.chance(55)) {
      conifer(mesh, random.between(4_m, 9_m, 16), random.between(6, 9));
    } else {
      broadleaf(mesh, random.between(4_m, 8_m, 16), random.between(7, 10));
    }
  }
}

}  // namespace

Mesh makeVilla() {
  Mesh mesh;
  Random random(30363);
  const Terrain terrain;
  ground(mesh, terrain, random);
  {
    const Mesh::Frame frame(mesh, {-kWidth / 2, -kDepth / 2 + 2_m, 0}, 0);
    building(mesh, random);
  }
  garden(mesh, terrain, random);
  return mesh;
}

}  // namespace footfall::samples
