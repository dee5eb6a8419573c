// Two rooms for the user guide: a doorway that is too low, a crate in the way, a gallery over part of the second room.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples.hpp"
#include "shapes.hpp"

namespace footfall::samples {

namespace {

constexpr int kWall = 0.25_m;
constexpr int kHeight = 3_m;
constexpr int kGallery = 2.375_m;  // walkable top

}  // namespace

Mesh makeRooms() {
  Mesh mesh;
  mesh.group("floor");
  mesh.polygon({{0, 0, 0}, {20_m, 0, 0}, {20_m, 10_m, 0}, {0, 10_m, 0}});
  mesh.group("walls");
  shell(mesh, {}, 20_m, 10_m, kHeight + 1.5_m, kWall,
        {{{window(2_m), window(5_m)}, {}, {window(3_m), window(13_m, 2_m)}, {}}});
  mesh.group("wall_with_doorway");
  {
    // An eighth of a metre too low for an agent of 2 m.
    const Mesh::Frame frame(mesh, {9_m, kWall, 0}, kQuarterTurn);
    wall(mesh, {}, 10_m - 2 * kWall, kWall, kHeight, {door(4.25_m, 1.25_m, 1.875_m)});
  }
  mesh.group("screen");
  fin(mesh, {2.5_m, 3_m, 0}, {6_m, 3_m, 0}, 1.5_m);
  mesh.group("table");
  box(mesh, {3_m, 6.5_m, 0.75_m}, {5_m, 7.75_m, 0.8125_m});
  for (const int x : {3.125_m, 4.75_m})
    for (const int y : {6.625_m, 7.5_m}) box(mesh, {x, y, kHair}, {x + 0.125_m, y + 0.125_m, 0.75_m});
  mesh.group("gallery");
  box(mesh, {14_m, 6_m, kGallery - 0.25_m}, {19.75_m, 9.75_m, kGallery});
  fin(mesh, {15.5_m, 6_m, kGallery}, {19.75_m, 6_m, kGallery}, 1_m);
  mesh.group("ramp_to_gallery");
  slope(mesh, {9.5_m, 8.25_m, 0}, {14_m, 9.75_m, kGallery});
  mesh.group("steep_ramp");
  {
    const Mesh::Frame frame(mesh, {15.25_m, 4.5_m, 0}, kQuarterTurn);
    slope(mesh, {0, 0, 0}, {1.5_m, 1.25_m, kGallery});
  }
  mesh.group("crate");
  box(mesh, {12_m, 2_m, kHair}, {13_m, 3_m, 1_m});
  return mesh;
}

}  // namespace footfall::samples
