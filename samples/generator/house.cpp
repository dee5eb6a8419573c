// A small house in its garden, like the one that the thesis measured first (5.4.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "props.hpp"
#include "samples.hpp"

namespace footfall::samples {

namespace {

constexpr int kFloor = 0.5_m;     // of the ground floor
constexpr int kStorey = 3.25_m;   // of the upper floor
constexpr int kWallTop = 5.75_m;  // under the roof

void mainBuilding(Mesh& mesh) {
  mesh.group("house_floor");
  box(mesh, {}, {12_m, 9_m, kFloor});
  mesh.group("house_walls");
  shell(mesh, {0, 0, kFloor}, 12_m, 9_m, 2.5_m, 0.25_m,
        {{{window(1.25_m), door(4.5_m, 1.5_m), window(8.5_m, 2_m)}, {}, {door(1_m)}, {}}});
  mesh.group("upper_floor");
  slabWithHole(mesh, {0, -1.5_m, 3_m}, {12_m, 9_m, kStorey}, {3.25_m, 7_m, 3_m}, {8_m, 8.75_m, kStorey});
  mesh.group("upper_walls");
  shell(mesh, {0, 0, kStorey}, 12_m, 9_m, 2.5_m, 0.25_m,
        {{{door(4.5_m, 1.5_m), window(8.5_m, 2_m)}, {window(3.5_m)}, {}, {}}});
  // Partitions and the railings of balcony and stairwell are sheets without thickness.
  for (int floor : {kFloor, kStorey}) {
    fin(mesh, {0.25_m, 5_m, floor}, {4_m, 5_m, floor}, 2.5_m);
    fin(mesh, {5_m, 5_m, floor}, {11.75_m, 5_m, floor}, 2.5_m);
  }
  mesh.group("railings");
  fin(mesh, {0, -1.5_m, kStorey}, {12_m, -1.5_m, kStorey}, 1_m);
  fin(mesh, {0, 0, kStorey}, {0, -1.5_m, kStorey}, 1_m);
  fin(mesh, {12_m, -1.5_m, kStorey}, {12_m, 0, kStorey}, 1_m);
  fin(mesh, {3.25_m, 7_m, kStorey}, {8_m, 7_m, kStorey}, 1_m);
  mesh.group("stairs");
  stairs(mesh, {3.75_m, 7_m, kFloor}, {8_m, 8.75_m, kStorey}, 4, true);
  mesh.group("roof");
  gableRoof(mesh, {0, 0, kWallTop}, 12_m, 9_m, 5_m, 0.75_m, 0.25_m);
  gableEnds(mesh, {0, 0, kWallTop}, 12_m, 9_m, 5_m);
  box(mesh, {8.5_m, 6_m, 7_m}, {9.5_m, 7_m, 11.5_m});
  mesh.group("furniture");
  post(mesh, {9_m, 2.5_m, kFloor}, 1.75_m, 1_m, 0.75_m);
}

void entrances(Mesh& mesh) {
  mesh.group("porch");
  // A ramp along the front and three steps up to the same landing, under the balcony.
  box(mesh, {4_m, -1.5_m, 0}, {7_m, 0, kFloor});
  ramp(mesh, {-1_m, -1.5_m, 0}, {4_m, 0, kFloor});
  for (int i = 1; i < 3; ++i) box(mesh, {7_m, -1.5_m, 0}, {7_m + (3 - i) * 0.375_m, 0, i * 0.1875_m});
  for (int x : {0.25_m, 11.5_m}) box(mesh, {x, -1.5_m, 0}, {x + 0.25_m, -1.25_m, 3_m});
  mesh.group("back_terrace");
  box(mesh, {5.5_m, 9_m, 0}, {11.5_m, 12_m, kFloor});
  {
    const Mesh::Frame frame(mesh, {8.5_m, 14_m, 0}, -kQuarterTurn);
    ramp(mesh, {0, -1_m, 0}, {2_m, 1_m, kFloor});
  }
  // The overhang: too low at its outer edge to stand under.
  mesh.group("overhang");
  mesh.polygon({{5.5_m, 9_m, 2.875_m}, {5.5_m, 12.5_m, 2.125_m}, {11.5_m, 12.5_m, 2.125_m}, {11.5_m, 9_m, 2.875_m}});
  mesh.polygon({{5.5_m, 9_m, 3_m}, {11.5_m, 9_m, 3_m}, {11.5_m, 12.5_m, 2.25_m}, {5.5_m, 12.5_m, 2.25_m}});
}

void garage(Mesh& mesh) {
  mesh.group("garage");
  shell(mesh, {}, 5_m, 6_m, 2.5_m, 0.25_m, {{{{1_m, 4_m, 0, 2.125_m}}, {}, {}, {}}});
  box(mesh, {-0.25_m, -0.25_m, 2.5_m}, {5.25_m, 6.25_m, 2.75_m});
  // Exactly 45 degrees: as steep as the agent climbs, up to the flat roof.
  mesh.group("steep_ramp");
  ramp(mesh, {-3_m, 2_m, 0}, {-0.25_m, 3.5_m, 2.75_m});
}

}  // namespace

Mesh makeHouse() {
  Mesh mesh;
  mesh.group("garden");
  grid(mesh, {}, 4, 3, 12_m, [](int column, int row) { return column == 4 && row >= 2 ? 3_m : 0; });
  {
    const Mesh::Frame frame(mesh, {14_m, 14_m, 0}, 0);
    mainBuilding(mesh);
    entrances(mesh);
  }
  {
    const Mesh::Frame frame(mesh, {32_m, 15_m, 0}, 0);
    garage(mesh);
  }
  mesh.group("tanks");
  cylinder(mesh, {7_m, 30_m, kHair}, 2.5_m, 4_m, 10);
  cylinder(mesh, {6.5_m, 22_m, kHair}, 2_m, 3_m, 10);
  // Places that touch nothing else: a tree house and stones.
  mesh.group("tree_house");
  cylinder(mesh, {36_m, 29_m, 0}, 0.5_m, 3.5_m, 6);
  prism(mesh, polygonRing({36_m, 29_m, 3.5_m}, 2.25_m, 8), 0.25_m);
  mesh.group("bridge");
  ramp(mesh, {8_m, 5_m, 0}, {12_m, 7_m, 2.25_m});
  box(mesh, {12_m, 5_m, 2_m}, {18_m, 7_m, 2.25_m});
  {
    const Mesh::Frame frame(mesh, {22_m, 7_m, 0}, 2 * kQuarterTurn);
    ramp(mesh, {0, 0, 0}, {4_m, 2_m, 2.25_m});
  }
  mesh.group("tree");
  {
    const Mesh::Frame frame(mesh, {4_m, 9_m, 0}, 0);
    conifer(mesh, 7_m, 6);
  }
  mesh.group("stones");
  for (int i = 0; i < 2; ++i) {
    const Mesh::Frame frame(mesh, {30_m + i * 1.5_m, 9_m + i % 2 * 0.5_m, 0}, 300 * i);
    post(mesh, {}, 1.25_m, 1_m, 0.25_m);
  }
  // A fence of sheets around the garden, open at the gate.
  mesh.group("fence");
  for (int x : {0_m, 9_m}) fin(mesh, {x, 0, 0}, {x + 9_m, 0, 0}, 1.25_m);
  for (int x : {24_m, 36_m}) fin(mesh, {x, 0, 0}, {x + 12_m, 0, 0}, 1.25_m);
  for (int y : {0_m, 12_m, 24_m}) fin(mesh, {0, y + 12_m, 0}, {0, y, 0}, 1.25_m);
  return mesh;
}

}  // namespace footfall::samples
