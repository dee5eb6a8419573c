// SPDX-License-Identifier: GPL-3.0-or-later
#include "props.hpp"

#include <cstdlib>

namespace footfall::samples {

namespace {

void legs(Mesh& mesh, int width, int depth, int size, int height) {
  for (int x : {-width / 2, width / 2 - size})
    for (int y : {-depth / 2, depth / 2 - size}) box(mesh, {x, y, 0}, {x + size, y + size, height});
}

}  // namespace

void table(Mesh& mesh, int width, int depth) {
  legs(mesh, width - 0.125_m, depth - 0.125_m, 0.0625_m, 0.6875_m);
  post(mesh, {0, 0, 0.6875_m}, width, depth, 0.0625_m);
}

void chair(Mesh& mesh) {
  legs(mesh, 0.4375_m, 0.4375_m, 0.0625_m, 0.4375_m);
  post(mesh, {0, 0, 0.4375_m}, 0.4375_m, 0.4375_m, 0.0625_m);
  box(mesh, {-0.21875_m, 0.15625_m, 0.5_m}, {0.21875_m, 0.21875_m, 1_m});
}

void bed(Mesh& mesh, int width) {
  legs(mesh, width, 2_m, 0.125_m, 0.25_m);
  post(mesh, {0, 0, 0.25_m}, width, 2_m, 0.125_m);
  post(mesh, {0, 0, 0.375_m}, width - 0.125_m, 1.875_m, 0.1875_m);
  box(mesh, {-width / 2, 1_m, 0}, {width / 2, 1.0625_m, 1.125_m});
  for (int side : {-1, 1}) post(mesh, {side * width / 4, 0.6875_m, 0.5625_m}, width / 2 - 0.1875_m, 0.375_m, 0.125_m);
}

void shelf(Mesh& mesh, int width, int boards) {
  const int height = boards * 0.375_m;
  for (int x : {-width / 2, width / 2 - 0.0625_m})
    box(mesh, {x, -0.15625_m, 0}, {x + 0.0625_m, 0.15625_m, height + 0.0625_m});
  fin(mesh, {width / 2, 0.15625_m, 0}, {-width / 2, 0.15625_m, 0}, height);  // its back, a sheet
  for (int i = 0; i <= boards; ++i)
    box(mesh, {-width / 2 + 0.0625_m, -0.15625_m, i * 0.375_m},
        {width / 2 - 0.0625_m, 0.15625_m, i * 0.375_m + 0.03125_m});
}

void sofa(Mesh& mesh, int width) {
  post(mesh, {0, 0, 0}, width, 0.875_m, 0.4375_m);
  box(mesh, {-width / 2, 0.25_m, 0.4375_m}, {width / 2, 0.4375_m, 0.875_m});
  for (int side : {-1, 1})
    box(mesh, {side * (width / 2 - 0.0625_m) - 0.0625_m, -0.4375_m, 0.4375_m},
        {side * (width / 2 - 0.0625_m) + 0.0625_m, 0.25_m, 0.625_m});
}

void wardrobe(Mesh& mesh, int width) {
  post(mesh, {0, 0, 0}, width, 0.625_m, 2.0625_m);
  for (int side : {-1, 1}) post(mesh, {side * 0.0625_m, -0.328125_m, 1_m}, 0.03125_m, 0.03125_m, 0.125_m);
}

void kitchen(Mesh& mesh, int units) {
  for (int i = 0; i < units; ++i) {
    const int x = i * 0.625_m;
    box(mesh, {x, 0, 0.125_m}, {x + 0.609375_m, 0.59375_m, 0.84375_m});
    box(mesh, {x, 0.25_m, 1.375_m}, {x + 0.609375_m, 0.59375_m, 2_m});
  }
  box(mesh, {0, -0.03125_m, 0.84375_m}, {units * 0.625_m, 0.59375_m, 0.890625_m});
  box(mesh, {0, 0.0625_m, 0}, {units * 0.625_m, 0.59375_m, 0.125_m});
}

void conifer(Mesh& mesh, int height, int sides) {
  const int radius = height / 4;
  cylinder(mesh, {}, radius / 8, height / 4, 5, Caps::kNone);
  for (int i = 0; i < 3; ++i) {
    const int foot = height / 6 + i * height / 4;
    cone(mesh, polygonRing({0, 0, foot}, radius - i * radius / 4, sides, i * 200), {0, 0, foot + height / 3});
  }
}

void broadleaf(Mesh& mesh, int height, int sides) {
  const int radius = height / 4;
  cylinder(mesh, {}, radius / 6, height / 2, 6, Caps::kNone);
  const int foot = height * 3 / 8;
  loft(mesh, {polygonRing({0, 0, foot}, radius / 2, sides), polygonRing({0, 0, foot + radius * 2 / 3}, radius, sides),
              polygonRing({0, 0, foot + radius * 3 / 2}, radius * 7 / 8, sides),
              polygonRing({0, 0, foot + radius * 9 / 4}, radius / 3, sides)});
}

void bench(Mesh& mesh) {
  for (int side : {-1, 1}) post(mesh, {side * 0.625_m, 0, 0}, 0.125_m, 0.375_m, 0.4375_m);
  for (int i = -1; i <= 1; ++i) post(mesh, {0, i * 0.15625_m, 0.4375_m}, 1.75_m, 0.125_m, 0.0625_m);
  post(mesh, {0, 0.21875_m, 0.625_m}, 1.75_m, 0.0625_m, 0.25_m);
}

void car(Mesh& mesh) {
  prism(mesh, rectangle({-2.125_m, -0.875_m, 0.25_m}, 4.25_m, 1.75_m), 0.5625_m);
  loft(mesh, {rectangle({-1.5_m, -0.8125_m, 0.8125_m}, 2.625_m, 1.625_m),
              rectangle({-1.125_m, -0.6875_m, 1.4375_m}, 1.625_m, 1.375_m)});
  for (int x : {-1.375_m, 1.375_m})
    for (int y : {-0.90625_m, 0.71875_m})
      prism(mesh,
            {{x - 0.3125_m, y, 0},
             {x + 0.3125_m, y, 0},
             {x + 0.3125_m, y + 0.1875_m, 0},
             {x - 0.3125_m, y + 0.1875_m, 0}},
            0.625_m);
}

void railFence(Mesh& mesh, int length, int spacing) {
  for (int x = 0; x <= length; x += spacing) post(mesh, {x, 0, -0.25_m}, 0.125_m, 0.125_m, 1.375_m);
  for (int x = 0; x + spacing <= length; x += spacing)
    for (int z : {0.375_m, 0.875_m})
      box(mesh, {x + 0.0625_m, -0.03125_m, z}, {x + spacing - 0.0625_m, 0.03125_m, z + 0.125_m});
}

void balustrade(Mesh& mesh, int length, int spacing) {
  for (int x = spacing / 2; x < length; x += spacing) cylinder(mesh, {x, 0, 0}, 0.0625_m, 0.875_m, 6);
  box(mesh, {0, -0.09375_m, 0.875_m}, {length, 0.09375_m, 1_m});
}

void barrel(Mesh& mesh, int sides) {
  loft(mesh, {polygonRing({}, 0.28125_m, sides), polygonRing({0, 0, 0.46875_m}, 0.375_m, sides),
              polygonRing({0, 0, 0.9375_m}, 0.28125_m, sides)});
}

void bollard(Mesh& mesh) {
  loft(mesh, {polygonRing({}, 0.1875_m, 8), polygonRing({0, 0, 0.5625_m}, 0.15625_m, 8),
              polygonRing({0, 0, 0.625_m}, 0.25_m, 8), polygonRing({0, 0, 0.75_m}, 0.21875_m, 8)});
}

void rope(Mesh& mesh, Point from, Point to, int sag, int segments) {
  const Point along = to - from;
  const bool alongX = std::abs(along.x) >= std::abs(along.y);
  const int width = 0.0625_m;
  const int side = alongX ? (along.x > 0 ? width : -width) : (along.y > 0 ? -width : width);
  const Point across = alongX ? Point{0, side, 0} : Point{side, 0, 0};
  std::vector<Ring> rings;
  for (int i = 0; i <= segments; ++i) {
    const int drop = 4 * sag * i * (segments - i) / (segments * segments);
    const Point at = from + Point{along.x * i / segments, along.y * i / segments, along.z * i / segments - drop};
    rings.push_back({at, at + across, at + Point{across.x / 2, across.y / 2, width}});
  }
  loft(mesh, rings, Caps::kNone);
}

}  // namespace footfall::samples
