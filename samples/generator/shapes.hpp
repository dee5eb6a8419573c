// Simple solids and sheets that the samples are built from. Faces look outward and sheets look up, unless a comment
// says otherwise.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh.hpp"

namespace footfall::samples {

using Ring = std::vector<Point>;

/// The ends of a solid that are closed.
enum class Caps { kBoth, kTop, kBottom, kNone };

/// The gap between a tall solid and the floor that it stands on, as in many models: its closed underside then removes
/// the floor inside of it. On a coincident face that floor would stay, as a walkable place that nobody can reach.
constexpr int kHair = 1;

/// A horizontal rectangle, counter-clockwise seen from above.
Ring rectangle(Point lower, int width, int depth);
/// A horizontal regular polygon, counter-clockwise; its first corner lies in direction `angle`.
Ring polygonRing(Point centre, int radius, int sides, int angle = 0);
/// The same for an ellipse.
Ring ellipseRing(Point centre, int radiusX, int radiusY, int sides, int angle = 0);
/// A copy, moved.
Ring moved(Ring ring, Point by);

/// Rings of equal size, from the lowest to the highest, joined by quads. The first corner of a closed end must see
/// all others.
void loft(Mesh& mesh, const std::vector<Ring>& rings, Caps caps = Caps::kBoth);
/// An outline raised by `height`.
void prism(Mesh& mesh, const Ring& outline, int height, Caps caps = Caps::kBoth);
void box(Mesh& mesh, Point lower, Point upper, Caps caps = Caps::kBoth);
/// A box given by its middle on the floor.
void post(Mesh& mesh, Point foot, int width, int depth, int height);
void cylinder(Mesh& mesh, Point foot, int radius, int height, int sides, Caps caps = Caps::kBoth);
/// A pointed solid, open below.
void cone(Mesh& mesh, const Ring& foot, Point tip);
/// A bar of square section between any two points; `width` across, open at its ends.
void beam(Mesh& mesh, Point from, Point to, int width);

/// A grid of quads over a rectangle, vertices shared, heights from `height(column, row)`.
template <class Height>
void grid(Mesh& mesh, Point lower, int columns, int rows, int step, Height height) {
  const int first = static_cast<int>(mesh.vertexCount());
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      mesh.vertex(lower + Point{column * step, row * step, height(column, row)});
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int a = first + row * (columns + 1) + column;
      const int d = a + columns + 1;
      if ((row + column) % 2 == 0) {
        mesh.quad(a, a + 1, d + 1, d);
      } else {
        mesh.quad(a + 1, d + 1, d, a);
      }
    }
}

/// A wall without thickness, from a to b, seen from its right-hand side.
void fin(Mesh& mesh, Point a, Point b, int height);
/// A wedge that rises along +X from lower.z to upper.z.
void ramp(Mesh& mesh, Point lower, Point upper);
/// A sloping sheet that rises along +X.
void slope(Mesh& mesh, Point lower, Point upper);
/// Solid steps that rise along +X. With `clip`, a sheet over their noses, as levels have it for their agents.
void stairs(Mesh& mesh, Point lower, Point upper, int steps, bool clip);

/// A hole in a wall; a door where `bottom` is 0.
struct Opening {
  int left, right, bottom, top;
};
// Constants, because Clang 14 does not take a consteval literal as a default argument.
constexpr int kDoorWidth = 1_m, kDoorHeight = 2.125_m;
constexpr int kWindowWidth = 1.25_m, kWindowBottom = 0.875_m, kWindowTop = 2_m;
Opening door(int left, int width = kDoorWidth, int height = kDoorHeight);
Opening window(int left, int width = kWindowWidth, int bottom = kWindowBottom, int top = kWindowTop);

/// A wall along +X from the origin of `foot`, `thickness` deep along +Y. Its closed underside is kHair above the
/// floor. Openings go from left to right.
void wall(Mesh& mesh, Point foot, int length, int thickness, int height, const std::vector<Opening>& openings = {});
/// Four walls around a rectangle: south, east, north, west; openings count from the left seen from outside.
void shell(Mesh& mesh, Point lower, int width, int depth, int height, int thickness,
           const std::array<std::vector<Opening>, 4>& openings);
/// A roof with its ridge along X over a rectangle, `overhang` wider on all sides, boards of the given thickness.
void gableRoof(Mesh& mesh, Point lower, int width, int depth, int rise, int overhang, int thickness);
/// The two triangles that close the gables, `thickness` inside the rectangle's ends.
void gableEnds(Mesh& mesh, Point lower, int width, int depth, int rise);
/// A floor slab with a rectangular hole, as four boxes that touch.
void slabWithHole(Mesh& mesh, Point lower, Point upper, Point holeLower, Point holeUpper);

}  // namespace footfall::samples
