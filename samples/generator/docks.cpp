// A shipyard and harbour town (thesis, 5.4.1): water and quay are a few giant triangles, under very many obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "props.hpp"
#include "samples.hpp"

namespace footfall::samples {

namespace {

// The quay lies south of y = 0 at height 0; the water, less than an agent lower, reaches under everything.
constexpr int kWater = -1.75_m;
constexpr int kPierLength = 48_m;

void ground(Mesh& mesh) {
  mesh.group("water");
  mesh.polygon(rectangle({-160_m, -100_m, kWater}, 320_m, 200_m));
  mesh.group("quay");
  mesh.polygon(rectangle({-150_m, -90_m, 0}, 300_m, 90_m));
  mesh.group("quay_wall");
  fin(mesh, {150_m, 0, kWater - 1_m}, {-150_m, 0, kWater - 1_m}, 3_m);
  fin(mesh, {150_m, -90_m, kWater - 1_m}, {150_m, 0, kWater - 1_m}, 3_m);
  fin(mesh, {-150_m, 0, kWater - 1_m}, {-150_m, -90_m, kWater - 1_m}, 3_m);
  fin(mesh, {-150_m, -90_m, kWater - 1_m}, {150_m, -90_m, kWater - 1_m}, 3_m);
}

void crate(Mesh& mesh, Point foot, int size, int angle) {
  const Mesh::Frame frame(mesh, foot, angle);
  post(mesh, {}, size, size, size);
}

/// A pier into the water from the origin along +Y: planks side by side on posts, bollards, some cargo.
void pier(Mesh& mesh, Random& random) {
  mesh.group("piers");
  for (int y = 0; y < kPierLength; y += 0.75_m) box(mesh, {-3_m, y, -0.25_m}, {3_m, y + 0.75_m, 0});
  mesh.group("pier_posts");
  for (int y = 3_m; y <= kPierLength; y += 5_m)
    for (int x : {-2.75_m, 2.75_m}) cylinder(mesh, {x, y, kWater - 1_m}, 0.25_m, 3.5_m, 6);
  mesh.group("bollards");
  for (int y = 6_m; y < kPierLength; y += 14_m)
    for (int x : {-2.25_m, 2.25_m}) {
      const Mesh::Frame frame(mesh, {x, y, 0}, 0);
      bollard(mesh);
    }
  mesh.group("pier_cargo");
  for (int i = 0; i < 14; ++i)
    crate(mesh, {random.between(-1.5_m, 1.5_m, 16), random.between(12_m, kPierLength - 2_m, 16), 0},
          random.between(0.5_m, 1.25_m, 8), random.between(0, 3) * 256);
}

Ring deckLine(int z, int beam, int length) {
  return {{0, -length, z},
          {beam * 3 / 4, -length, z},
          {beam, -length / 3, z},
          {beam, length / 3, z},
          {beam * 2 / 3, length * 3 / 4, z},
          {0, length, z},
          {-beam * 2 / 3, length * 3 / 4, z},
          {-beam, length / 3, z},
          {-beam, -length / 3, z},
          {-beam * 3 / 4, -length, z}};
}

/// A sailing ship, its bow towards +Y, the waterline at z = 0.
void ship(Mesh& mesh, int masts, Random& random) {
  const int length = 14_m, beam = 4_m, deck = 3_m;
  mesh.group("hulls");
  loft(mesh,
       {deckLine(0.125_m, beam * 3 / 4, length * 7 / 8), deckLine(1.5_m, beam, length), deckLine(deck, beam, length)});
  const Ring rail = deckLine(deck, beam, length);
  for (std::size_t i = 0; i < rail.size(); ++i) {
    if (i != 7) fin(mesh, rail[i], rail[(i + 1) % rail.size()], 1_m);  // open where the gangway comes up
  }
  box(mesh, {-3_m, -length, deck + kHair}, {3_m, -8_m, deck + 2.25_m});  // quarterdeck
  {
    const Mesh::Frame frame(mesh, {2.75_m, -5_m, deck}, -kQuarterTurn);
    stairs(mesh, {0, -1.5_m, 0}, {3_m, 0, 2.25_m}, 8, true);
  }
  mesh.group("deck_cargo");
  for (int y : {-2_m, 4_m}) box(mesh, {-1.25_m, y, deck}, {1.25_m, y + 2_m, deck + 0.5_m});
  for (int side : {-1, 1})
    for (int y = -2_m; y <= 4_m; y += 2_m) {
      const Mesh::Frame frame(mesh, {side * 2.75_m, y, deck}, side * -kQuarterTurn);
      post(mesh, {}, 0.75_m, 1_m, 0.375_m);
      loft(mesh, {polygonRing({0, 0, 0.375_m}, 0.1875_m, 8), polygonRing({0, 0.5_m, 0.5_m}, 0.125_m, 8)});
    }
  for (int i = 0; i < 5; ++i) {
    const Mesh::Frame frame(mesh, {random.between(-2_m, 2_m, 8), random.between(7_m, 9_m, 8), deck}, i * 100);
    barrel(mesh, 8);
  }
  mesh.group("rigging");
  for (int i = 0; i < masts; ++i) {
    const int y = (2 * i + 1) * 22_m / (2 * masts) - 11_m;
    const int height = 17_m - i % 2 * 3_m;
    cylinder(mesh, {0, y, deck}, 0.25_m, height, 8);
    for (int part = 1; part <= 3; ++part) {
      const int z = deck + height * part / 4, half = 6_m - part * 1_m;
      samples::beam(mesh, {-half, y, z}, {half, y, z}, 0.1875_m);
      if (part < 3)
        fin(mesh, {-half * 3 / 4, y + 0.25_m, z}, {half * 3 / 4, y + 0.25_m, z}, height / 4 - 0.5_m);  // sail
    }
    for (int side : {-1, 1})
      for (int foot = -1; foot <= 1; ++foot)
        rope(mesh, {side * 3.5_m, y + foot * 1_m, deck + 1_m}, {0, y, deck + height * 7 / 8}, 0.25_m, 5);
  }
  samples::beam(mesh, {0, length - 1_m, deck + 0.5_m}, {0, length + 5_m, deck + 3_m}, 0.25_m);
}

/// A warehouse with a gable roof and goods inside; its front looks to the water (+Y).
void warehouse(Mesh& mesh, int width, int depth, Random& random) {
  mesh.group("warehouses");
  const Opening gate{width / 2 - 2_m, width / 2 + 2_m, 0, 3.5_m};
  shell(mesh, {-width / 2, -depth, 0}, width, depth, 5_m, 0.5_m,
        {{{window(1.5_m, 1_m, 2.5_m, 3.5_m), door(width - 4_m)},
          {window(3_m, 1_m, 2.5_m, 3.5_m), window(depth - 4_m, 1_m, 2.5_m, 3.5_m)},
          {window(1.5_m, 1_m, 2.5_m, 3.5_m), gate, window(width - 2.5_m, 1_m, 2.5_m, 3.5_m)},
          {window(3_m, 1_m, 2.5_m, 3.5_m)}}});
  const Mesh::Frame turned(mesh, {-width / 2, 0, 5_m}, -kQuarterTurn);
  gableRoof(mesh, {}, depth, width, width * 5 / 8, 0.5_m, 0.25_m);
  gableEnds(mesh, {}, depth, width, width * 5 / 8);
  mesh.group("goods");
  for (int x = 2_m; x + 1.5_m < depth; x += 2.5_m)
    for (int y : {1_m, width - 2.5_m}) {
      const Mesh::Frame shelfFrame(mesh, {x, y, -5_m}, 0);
      box(mesh, {0, 0, 0}, {1.75_m, 1.5_m, 1_m});
      if (random.chance(60)) box(mesh, {0.25_m, 0.25_m, 1_m}, {1.5_m, 1.25_m, 2_m});
    }
}

/// A timber-framed house with an upper floor that hangs over the street.
void townHouse(Mesh& mesh, Random& random) {
  mesh.group("houses");
  const int width = random.between(6_m, 8_m, 64), depth = 8_m;
  shell(mesh, {}, width, depth, 2.75_m, 0.25_m, {{{window(1_m), door(3.5_m)}, {}, {window(2_m)}, {}}});
  box(mesh, {-0.5_m, -0.75_m, 2.75_m}, {width + 0.5_m, depth + 0.75_m, 3_m});
  shell(mesh, {-0.5_m, -0.75_m, 3_m}, width + 1_m, depth + 1.5_m, 2.5_m, 0.25_m,
        {{{window(1_m), window(4_m)}, {window(4_m)}, {window(3_m)}, {window(4_m)}}});
  gableRoof(mesh, {-0.5_m, -0.75_m, 5.5_m}, width + 1_m, depth + 1.5_m, 6_m, 0.5_m, 0.1875_m);
  gableEnds(mesh, {-0.5_m, -0.75_m, 5.5_m}, width + 1_m, depth + 1.5_m, 6_m);
  for (int x = 0; x <= width; x += 2_m) samples::beam(mesh, {x, -0.8125_m, 3_m}, {x, -0.8125_m, 5.5_m}, 0.1875_m);
}

void townWall(Mesh& mesh) {
  mesh.group("town_wall");
  box(mesh, {-150_m, -90_m, kHair}, {150_m, -86_m, 6_m});
  for (int x = -150_m; x < 150_m; x += 2_m) box(mesh, {x, -90_m, 6_m}, {x + 1_m, -89.5_m, 7.25_m});
  for (int x : {-148_m, -74_m, 0_m, 74_m, 148_m}) {
    const Point foot{x, -88_m, kHair};
    cylinder(mesh, foot, 5_m, 11_m, 16);
    for (int i = 0; i < 16; i += 2) {
      const Mesh::Frame frame(mesh, foot + Point{0, 0, 11_m}, i * kTurn / 16 + kTurn / 32);
      post(mesh, {4.5_m, 0, 0}, 0.625_m, 1.5_m, 1.25_m);
    }
  }
  for (int x : {-110_m, -36_m, 38_m, 112_m}) ramp(mesh, {x - 12_m, -86_m, 0}, {x, -83_m, 6_m});
}

/// Stacks and heaps of cargo on the quay, in blocks with lanes between them.
void cargo(Mesh& mesh, Random& random) {
  for (int block = 0; block < 36; ++block) {
    const Point middle{-141_m + block % 18 * 16.5_m, block < 18 ? -10_m : -20_m, 0};
    mesh.group("crates");
    for (int i = 0; i < 14; ++i) {
      const int size = random.between(0.75_m, 1.5_m, 8);
      const Point foot{middle.x + random.between(-6_m, 6_m, 16), middle.y + random.between(-3.5_m, 3.5_m, 16), 0};
      const int angle = random.chance(50) ? 0 : random.between(0, kTurn - 1);
      crate(mesh, foot, size, angle);
      if (random.chance(40)) crate(mesh, foot + Point{0, 0, size}, size * 3 / 4, random.between(0, kTurn - 1));
    }
    mesh.group("barrels");
    for (int i = 0; i < 5; ++i) {
      const Point foot{middle.x + random.between(-7_m, 7_m, 16), middle.y + random.between(-4_m, 4_m, 16), 0};
      const Mesh::Frame frame(mesh, foot, random.between(0, 511));
      barrel(mesh, 8);
    }
  }
}

void quaySide(Mesh& mesh) {
  for (int i = 0; i < 60; ++i) {
    mesh.group("bollards");
    const int x = -147.5_m + i * 5_m;
    {
      const Mesh::Frame frame(mesh, {x, -1_m, 0}, 0);
      bollard(mesh);
    }
    mesh.group("ropes");
    if (i % 3 == 0) rope(mesh, {x, -1_m, 0.625_m}, {x + 5_m, -1_m, 0.625_m}, 0.375_m, 10);
  }
  mesh.group("cranes");
  for (int x : {-105_m, -15_m, 75_m}) {
    const Mesh::Frame frame(mesh, {x, -4_m, 0}, 0);
    for (int side : {-1, 1}) {
      box(mesh, {side * 1.5_m - 0.25_m, -1.5_m, 0}, {side * 1.5_m + 0.25_m, -1_m, 8_m});
      cylinder(mesh, {side * 2.25_m, 0, 0}, 0.125_m, 2_m, 8);
    }
    box(mesh, {-2_m, -2_m, 5_m}, {2_m, 0, 8_m});
    samples::beam(mesh, {0, -2_m, 8_m}, {0, 8_m, 12_m}, 0.375_m);
    rope(mesh, {0, 7.5_m, 11.75_m}, {0, 7.75_m, 3_m}, 0, 4);
  }
  mesh.group("slipway");
  {
    const Mesh::Frame frame(mesh, {135_m, 16_m, kWater}, -kQuarterTurn);
    ramp(mesh, {0, -5_m, 0}, {16_m, 5_m, -kWater});
  }
}

}  // namespace

Mesh makeDocks() {
  Mesh mesh;
  Random random(59418);
  ground(mesh);
  for (int i = 0; i < 5; ++i) {
    const Mesh::Frame frame(mesh, {-120_m + i * 55_m, 0, 0}, 0);
    pier(mesh, random);
    // Ships on both sides, bows outward or inward, tied up and reached by gangways from the pier.
    for (int side : {-1, 1}) {
      if (i == 4 && side == 1) continue;
      {
        const Mesh::Frame berth(mesh, {side * 10_m, 26_m, kWater}, side == 1 ? 0 : 2 * kQuarterTurn);
        ship(mesh, 2 + (i + side) % 2, random);
      }
      mesh.group("gangways");
      const Mesh::Frame gangway(mesh, {side * 2.5_m, side == 1 ? 24_m : 28_m, 0}, side == 1 ? 0 : 2 * kQuarterTurn);
      slope(mesh, {0, -0.75_m, 0}, {3.75_m, 0.75_m, 3_m + kWater});
      mesh.group("ropes");
      rope(mesh, {0, -9_m, 0.625_m}, {4.25_m, -7_m, 1.75_m}, 0.25_m, 12);
      rope(mesh, {0, 12_m, 0.625_m}, {4.25_m, 9_m, 1.75_m}, 0.25_m, 12);
    }
  }
  quaySide(mesh);
  cargo(mesh, random);
  for (int i = 0; i < 9; ++i) {
    const Mesh::Frame frame(mesh, {-130_m + i * 32_m, -29_m, 0}, 0);
    warehouse(mesh, 16_m + i % 3 * 2_m, 22_m, random);
  }
  for (int i = 0; i < 26; ++i) {
    const Mesh::Frame frame(mesh, {-144_m + i % 13 * 22_m, i < 13 ? -64_m : -80_m, 0}, 0);
    townHouse(mesh, random);
  }
  townWall(mesh);
  return mesh;
}

}  // namespace footfall::samples
