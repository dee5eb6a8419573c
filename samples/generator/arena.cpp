// A stadium: a bowl of steps, a ring road on pillars, ramps all around, and one crowded car park (thesis, 5.4.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "props.hpp"
#include "samples.hpp"

namespace footfall::samples {

namespace {

constexpr int kSectors = 64;
constexpr int kRoad = 6_m;  // height of the ring road, and of the upper stand's entrances

/// The bowl's curves: ellipses around the pitch, `out` metres outside its edge.
Ring curve(int out, int z) { return ellipseRing({0, 0, z}, 56_m + out, 38_m + out, kSectors); }

/// A strip between two curves; `facingIn` where its front looks to the pitch or up.
void strip(Mesh& mesh, const Ring& inner, const Ring& outer, int from = 0, int to = kSectors) {
  const int first = static_cast<int>(mesh.vertexCount());
  const int count = to - from;
  const bool closed = count == kSectors;
  const int columns = closed ? count : count + 1;
  for (const Ring* ring : {&inner, &outer})
    for (int i = 0; i < columns; ++i) mesh.vertex((*ring)[(from + i) % kSectors]);
  for (int i = 0; i < count; ++i) {
    const int a = first + i, b = first + (i + 1) % columns;
    mesh.quad(a, a + columns, b + columns, b);
  }
}

/// Rows of steps from `out` and `z` on, and aisles over them.
void stand(Mesh& mesh, int out, int z, int rows, int depth, int rise) {
  for (int row = 0; row < rows; ++row) {
    const int edge = out + row * depth, low = z + row * rise;
    strip(mesh, curve(edge, low), curve(edge, low + rise));
    strip(mesh, curve(edge, low + rise), curve(edge + depth, low + rise));
  }
  const Ring foot = curve(out - depth, z), head = curve(out + (rows - 1) * depth, z + rows * rise);
  for (int sector = 0; sector < kSectors; sector += 8) strip(mesh, foot, head, sector, sector + 1);
}

void bowl(Mesh& mesh) {
  mesh.group("lower_stand");
  strip(mesh, curve(0, 0), curve(0, 1_m));
  strip(mesh, curve(0, 1_m), curve(3_m, 1_m));
  stand(mesh, 3_m, 1_m, 12, 0.75_m, 0.3125_m);
  mesh.group("concourse");
  strip(mesh, curve(11.25_m + 0.75_m, 4.75_m), curve(16_m, 4.75_m));
  mesh.group("upper_stand");
  for (int sector = 0; sector < kSectors; ++sector) {
    if (sector % 4 == 2) continue;  // an entrance from the ring road
    strip(mesh, curve(16_m, 4.75_m), curve(16_m, 7.5_m), sector, sector + 1);
  }
  strip(mesh, curve(16_m, 7.5_m), curve(18_m, 7.5_m));
  stand(mesh, 18_m, 7.5_m, 14, 0.75_m, 0.4375_m);
  strip(mesh, curve(28.5_m, 13.625_m), curve(30_m, 13.625_m));
  mesh.group("facade");
  strip(mesh, curve(30_m, 17_m), curve(30_m, kRoad + 3_m));
  for (int sector = 0; sector < kSectors; ++sector) {
    const Ring at = curve(29_m, 0);
    cylinder(mesh, at[sector], 0.5_m, 13.5_m, 6);
  }
  mesh.group("roof");
  strip(mesh, curve(12_m, 21_m), curve(31_m, 18_m));
  strip(mesh, curve(31_m, 17.5_m), curve(12_m, 20.5_m));
  strip(mesh, curve(12_m, 20.5_m), curve(12_m, 21_m));
  strip(mesh, curve(31_m, 18_m), curve(31_m, 17.5_m));
  for (int sector = 0; sector < kSectors; sector += 4)
    beam(mesh, curve(31_m, 13.625_m)[sector], curve(14_m, 20.5_m)[sector], 0.25_m);
}

void pitch(Mesh& mesh) {
  mesh.group("pitch");
  // Lines as coplanar sheets on the ground, as levels often paint them.
  for (int x : {-50_m, 0_m, 49.875_m}) mesh.polygon(rectangle({x, -32_m, 0}, 0.125_m, 64_m));
  for (int y : {-32_m, 31.875_m}) mesh.polygon(rectangle({-50_m, y, 0}, 100_m, 0.125_m));
  mesh.group("goals");
  for (int side : {-1, 1}) {
    for (int y : {-3.625_m, 3.625_m}) post(mesh, {side * 50_m, y, 0}, 0.125_m, 0.125_m, 2.5_m);
    box(mesh, {side * 50_m - 0.0625_m, -3.6875_m, 2.4375_m}, {side * 50_m + 0.0625_m, 3.6875_m, 2.5625_m});
    box(mesh, {side * 20_m - 4_m, -37_m, kHair}, {side * 20_m + 4_m, -35.5_m, 2.25_m});  // dugouts
  }
}

void ringRoad(Mesh& mesh) {
  mesh.group("ring_road");
  const int in = 31_m, out = 41_m;
  strip(mesh, curve(in, kRoad), curve(out, kRoad));
  strip(mesh, curve(out, kRoad - 0.75_m), curve(in, kRoad - 0.75_m));
  strip(mesh, curve(in, kRoad - 0.75_m), curve(in, kRoad));
  strip(mesh, curve(out, kRoad), curve(out, kRoad - 0.75_m));
  mesh.group("parapets");
  for (int sector = 0; sector < kSectors; ++sector) {
    if (sector % 4 == 0) continue;  // a ramp arrives here
    strip(mesh, curve(out, kRoad + 1_m), curve(out, kRoad), sector, sector + 1);
  }
  mesh.group("pillars");
  for (int sector = 0; sector < kSectors; sector += 2)
    for (int at : {33_m, 39_m}) {
      const Point foot = curve(at, 0)[sector];
      cylinder(mesh, foot, 0.625_m, kRoad - 0.75_m, 8);
    }
  // Straight ramps from the road down to the ground all around, and short ones up to the stand's entrances.
  mesh.group("ramps");
  for (int sector = 0; sector < kSectors; sector += 4) {
    const Ring edge = curve(out, kRoad), far = curve(out + 16_m, 0);
    strip(mesh, edge, far, sector, sector + 1);
    const int next = (sector + 1) % kSectors;
    for (int i : {sector, next}) {
      const Point below{far[i].x, far[i].y, 0}, under{edge[i].x, edge[i].y, 0};
      if (i == sector) {
        mesh.polygon({under, below, edge[i]});
      } else {
        mesh.polygon({below, under, edge[i]});
      }
    }
  }
  for (int sector = 2; sector < kSectors; sector += 4)
    strip(mesh, curve(16_m, 4.75_m), curve(in, kRoad), sector, sector + 1);
}

/// The crowded place: cars in rows, stalls, barriers and lamps on the forecourt in the south-east.
void forecourt(Mesh& mesh, Random& random) {
  const Point corner{66_m, -146_m, 0};
  const Mesh::Frame frame(mesh, corner, 0);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 12; ++column) {
      if (random.chance(15)) continue;
      mesh.group("cars");
      const Mesh::Frame place(mesh, {column * 3_m + 2_m, row * 9_m + 4_m, 0},
                              kQuarterTurn * (random.chance(50) ? 1 : 3) + random.between(-20, 20));
      car(mesh);
    }
  mesh.group("barriers");
  for (int i = 0; i < 80; ++i) {
    const Mesh::Frame place(mesh, {i % 20 * 2.5_m - 4_m, 46_m + i / 20 * 1.5_m, 0}, random.between(-60, 60));
    box(mesh, {0, -0.03125_m, 0.25_m}, {2.25_m, 0.03125_m, 1.125_m});
  }
  mesh.group("stalls");
  for (int i = 0; i < 10; ++i) {
    const Mesh::Frame place(mesh, {40_m, i * 4.25_m + 2_m, 0}, kQuarterTurn);
    box(mesh, {-1.5_m, -1_m, 0}, {1.5_m, -0.5_m, 1_m});
    for (int x : {-1.5_m, 1.375_m})
      for (int y : {-1_m, 0.875_m}) box(mesh, {x, y, 0}, {x + 0.125_m, y + 0.125_m, 2.25_m});
    loft(mesh, {rectangle({-1.75_m, -1.25_m, 2.25_m}, 3.5_m, 2.5_m), rectangle({-0.5_m, -0.25_m, 3.25_m}, 1_m, 0.5_m)});
    const Mesh::Frame seat(mesh, {0, -3_m, 0}, random.between(0, kTurn - 1));
    bench(mesh);
  }
}

}  // namespace

Mesh makeArena() {
  Mesh mesh;
  Random random(19829);
  mesh.group("ground");
  mesh.polygon(rectangle({-150_m, -150_m, 0}, 300_m, 300_m));
  pitch(mesh);
  bowl(mesh);
  ringRoad(mesh);
  forecourt(mesh, random);
  mesh.group("floodlights");
  for (int x : {-1, 1})
    for (int y : {-1, 1}) {
      const Point foot{x * 88_m, y * 78_m, 0};
      loft(mesh, {polygonRing(foot, 1_m, 8), polygonRing(foot + Point{0, 0, 38_m}, 0.5_m, 8)});
      const Mesh::Frame frame(mesh, foot + Point{0, 0, 36_m}, (x > 0 ? 0 : 2 * kQuarterTurn) + x * y * kTurn / 8);
      for (int row = 0; row < 2; ++row)
        for (int column = -2; column <= 2; ++column)
          post(mesh, {-0.875_m, column * 1.5_m, row * 1.5_m}, 0.5_m, 1.25_m, 1.25_m);
    }
  mesh.group("trees");
  for (int i = 0; i < 20; ++i) {
    const Mesh::Frame frame(mesh, {-143_m + i % 10 * 16_m, i < 10 ? -140_m : 140_m, 0}, random.between(0, kTurn - 1));
    broadleaf(mesh, random.between(5_m, 8_m, 16), 8);
  }
  return mesh;
}

}  // namespace footfall::samples
