// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.hpp"

#include <algorithm>
#include <cstdlib>

namespace footfall::samples {

Ring rectangle(Point lower, int width, int depth) {
  return {lower, lower + Point{width, 0, 0}, lower + Point{width, depth, 0}, lower + Point{0, depth, 0}};
}

Ring polygonRing(Point centre, int radius, int sides, int angle) {
  return ellipseRing(centre, radius, radius, sides, angle);
}

Ring ellipseRing(Point centre, int radiusX, int radiusY, int sides, int angle) {
  Ring ring;
  for (int i = 0; i < sides; ++i) {
    const Direction at = direction(angle + i * kTurn / sides);
    ring.push_back(centre + Point{scaled(radiusX, at.cos), scaled(radiusY, at.sin), 0});
  }
  return ring;
}

Ring moved(Ring ring, Point by) {
  for (Point& point : ring) point = point + by;
  return ring;
}

void loft(Mesh& mesh, const std::vector<Ring>& rings, Caps caps) {
  const int sides = static_cast<int>(rings.front().size());
  const int first = static_cast<int>(mesh.vertexCount());
  for (const Ring& ring : rings)
    for (const Point& point : ring) mesh.vertex(point);
  for (int level = 0; level + 1 < static_cast<int>(rings.size()); ++level)
    for (int i = 0; i < sides; ++i) {
      const int a = first + level * sides + i;
      const int b = first + level * sides + (i + 1) % sides;
      mesh.quad(a, b, b + sides, a + sides);
    }
  const int top = first + sides * (static_cast<int>(rings.size()) - 1);
  for (int i = 2; i < sides; ++i) {
    if (caps == Caps::kBoth || caps == Caps::kBottom) mesh.triangle(first, first + i, first + i - 1);
    if (caps == Caps::kBoth || caps == Caps::kTop) mesh.triangle(top, top + i - 1, top + i);
  }
}

void prism(Mesh& mesh, const Ring& outline, int height, Caps caps) {
  loft(mesh, {outline, moved(outline, {0, 0, height})}, caps);
}

void box(Mesh& mesh, Point lower, Point upper, Caps caps) {
  prism(mesh, rectangle(lower, upper.x - lower.x, upper.y - lower.y), upper.z - lower.z, caps);
}

void post(Mesh& mesh, Point foot, int width, int depth, int height) {
  const Point lower = foot - Point{width / 2, depth / 2, 0};
  box(mesh, lower, lower + Point{width, depth, height});
}

void cylinder(Mesh& mesh, Point foot, int radius, int height, int sides, Caps caps) {
  prism(mesh, polygonRing(foot, radius, sides), height, caps);
}

void cone(Mesh& mesh, const Ring& foot, Point tip) {
  const int sides = static_cast<int>(foot.size());
  const int first = static_cast<int>(mesh.vertexCount());
  for (const Point& point : foot) mesh.vertex(point);
  const int apex = mesh.vertex(tip);
  for (int i = 0; i < sides; ++i) mesh.triangle(first + i, first + (i + 1) % sides, apex);
}

void beam(Mesh& mesh, Point from, Point to, int width) {
  const Point along = to - from;
  // Two directions across, along the axes farthest from the beam's own.
  Point u{width, 0, 0};
  Point v{0, width, 0};
  if (std::abs(along.z) < std::max(std::abs(along.x), std::abs(along.y))) {
    v = {0, 0, width};
    u = std::abs(along.x) > std::abs(along.y) ? Point{0, along.x > 0 ? width : -width, 0}
                                              : Point{along.y > 0 ? -width : width, 0, 0};
  } else if (along.z < 0) {
    std::swap(u, v);
  }
  const Point half{(u.x + v.x) / 2, (u.y + v.y) / 2, (u.z + v.z) / 2};
  const Point corner = from - half;
  const Ring ring{corner, corner + u, corner + u + v, corner + v};
  loft(mesh, {ring, moved(ring, along)}, Caps::kNone);
}

void fin(Mesh& mesh, Point a, Point b, int height) {
  mesh.polygon({a, b, b + Point{0, 0, height}, a + Point{0, 0, height}});
}

void ramp(Mesh& mesh, Point lower, Point upper) {
  const int a = mesh.vertex(lower);
  const int b = mesh.vertex({upper.x, lower.y, lower.z});
  const int c = mesh.vertex({upper.x, upper.y, lower.z});
  const int d = mesh.vertex({lower.x, upper.y, lower.z});
  const int e = mesh.vertex({upper.x, lower.y, upper.z});
  const int f = mesh.vertex(upper);
  mesh.quad(a, e, f, d);
  mesh.quad(b, c, f, e);
  mesh.quad(a, d, c, b);
  mesh.triangle(a, b, e);
  mesh.triangle(d, f, c);
}

void slope(Mesh& mesh, Point lower, Point upper) {
  mesh.polygon({lower, {upper.x, lower.y, upper.z}, upper, {lower.x, upper.y, lower.z}});
}

void stairs(Mesh& mesh, Point lower, Point upper, int steps, bool clip) {
  const int run = (upper.x - lower.x) / steps;
  const int rise = (upper.z - lower.z) / steps;
  for (int i = 0; i < steps; ++i) {
    const int x = lower.x + i * run;
    const int z = lower.z + i * rise;
    const int end = i + 1 == steps ? upper.x : x + run;
    const int top = i + 1 == steps ? upper.z : z + rise;
    const int a = mesh.vertex({x, lower.y, z});
    const int b = mesh.vertex({x, upper.y, z});
    const int c = mesh.vertex({x, lower.y, top});
    const int d = mesh.vertex({x, upper.y, top});
    const int e = mesh.vertex({end, lower.y, top});
    const int f = mesh.vertex({end, upper.y, top});
    mesh.quad(b, a, c, d);
    mesh.quad(c, e, f, d);
    const int g = mesh.vertex({x, lower.y, lower.z});
    const int h = mesh.vertex({end, lower.y, lower.z});
    const int k = mesh.vertex({x, upper.y, lower.z});
    const int l = mesh.vertex({end, upper.y, lower.z});
    mesh.quad(g, h, e, c);
    mesh.quad(l, k, d, f);
  }
  fin(mesh, {upper.x, lower.y, lower.z}, {upper.x, upper.y, lower.z}, upper.z - lower.z);
  // The ramp runs from the foot of the first riser, one tread before it, through all noses to that of the last step.
  if (clip) slope(mesh, {lower.x - run, lower.y, lower.z}, {lower.x + (steps - 1) * run, upper.y, upper.z});
}

Opening door(int left, int width, int height) { return {left, left + width, 0, height}; }

Opening window(int left, int width, int bottom, int top) { return {left, left + width, bottom, top}; }

namespace {

/// One face of a wall: the corners at panel borders and around openings, at one depth.
struct WallFace {
  std::vector<int> low, high;              // at the borders of the panels
  std::vector<std::array<int, 4>> corner;  // of each opening: left low, right low, right high, left high
};

WallFace wallFace(Mesh& mesh, Point foot, int height, const std::vector<int>& borders,
                  const std::vector<Opening>& openings) {
  WallFace face;
  for (int x : borders) {
    face.low.push_back(mesh.vertex(foot + Point{x, 0, 0}));
    face.high.push_back(mesh.vertex(foot + Point{x, 0, height}));
  }
  for (const Opening& hole : openings)
    face.corner.push_back(
        {mesh.vertex(foot + Point{hole.left, 0, hole.bottom}), mesh.vertex(foot + Point{hole.right, 0, hole.bottom}),
         mesh.vertex(foot + Point{hole.right, 0, hole.top}), mesh.vertex(foot + Point{hole.left, 0, hole.top})});
  return face;
}

}  // namespace

void wall(Mesh& mesh, Point foot, int length, int thickness, int height, const std::vector<Opening>& openings) {
  const Point front = foot + Point{0, 0, kHair};
  std::vector<int> borders{0};
  for (std::size_t i = 1; i < openings.size(); ++i) borders.push_back((openings[i - 1].right + openings[i].left) / 2);
  borders.push_back(length);
  const WallFace near = wallFace(mesh, front, height - kHair, borders, openings);
  const WallFace far = wallFace(mesh, front + Point{0, thickness, 0}, height - kHair, borders, openings);

  const auto both = [&mesh](int a, int b, int c, int d, int a2, int b2, int c2, int d2) {
    mesh.quad(a, b, c, d);
    mesh.quad(d2, c2, b2, a2);
  };
  const auto across = [&](int a, int b, int a2, int b2) { mesh.quad(a, b, b2, a2); };
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const int al = near.low[i], ah = near.high[i], bl = near.low[i + 1], bh = near.high[i + 1];
    const int cl = far.low[i], ch = far.high[i], dl = far.low[i + 1], dh = far.high[i + 1];
    across(ah, bh, ch, dh);
    if (openings.empty()) {
      both(al, bl, bh, ah, cl, dl, dh, ch);
      across(bl, al, dl, cl);
      continue;
    }
    const auto& n = near.corner[i];
    const auto& f = far.corner[i];
    both(n[1], bl, bh, n[2], f[1], dl, dh, f[2]);
    both(n[2], bh, ah, n[3], f[2], dh, ch, f[3]);
    both(al, n[0], n[3], ah, cl, f[0], f[3], ch);
    across(n[1], n[2], f[1], f[2]);
    across(n[2], n[3], f[2], f[3]);
    across(n[3], n[0], f[3], f[0]);
    if (openings[i].bottom == 0) {
      across(n[0], al, f[0], cl);
      across(bl, n[1], dl, f[1]);
    } else {
      both(al, bl, n[1], n[0], cl, dl, f[1], f[0]);
      across(n[0], n[1], f[0], f[1]);
      across(bl, al, dl, cl);
    }
  }
  across(near.low.front(), near.high.front(), far.low.front(), far.high.front());
  across(near.high.back(), near.low.back(), far.high.back(), far.low.back());
}

void shell(Mesh& mesh, Point lower, int width, int depth, int height, int thickness,
           const std::array<std::vector<Opening>, 4>& openings) {
  const int inner = depth - 2 * thickness;
  wall(mesh, lower, width, thickness, height, openings[0]);
  {
    const Mesh::Frame frame(mesh, lower + Point{width, thickness, 0}, kQuarterTurn);
    wall(mesh, {}, inner, thickness, height, openings[1]);
  }
  {
    const Mesh::Frame frame(mesh, lower + Point{width, depth, 0}, 2 * kQuarterTurn);
    wall(mesh, {}, width, thickness, height, openings[2]);
  }
  {
    const Mesh::Frame frame(mesh, lower + Point{0, depth - thickness, 0}, 3 * kQuarterTurn);
    wall(mesh, {}, inner, thickness, height, openings[3]);
  }
}

void gableRoof(Mesh& mesh, Point lower, int width, int depth, int rise, int overhang, int thickness) {
  // The eaves hang below the walls' tops by the slope of the pitch.
  const int drop = 2 * rise * overhang / depth;
  const int x0 = lower.x - overhang, x1 = lower.x + width + overhang;
  const int south = lower.y - overhang, middle = lower.y + depth / 2, north = lower.y + depth + overhang;
  const int eaves = lower.z - drop, ridge = lower.z + rise;
  std::array<Ring, 2> ends;
  for (int i = 0; i < 2; ++i) {
    const int x = i == 0 ? x0 : x1;
    ends[i] = {{x, south, eaves + thickness},
               {x, middle, ridge + thickness},
               {x, north, eaves + thickness},
               {x, north, eaves},
               {x, middle, ridge},
               {x, south, eaves}};
  }
  const int first = static_cast<int>(mesh.vertexCount());
  for (const Ring& end : ends)
    for (const Point& point : end) mesh.vertex(point);
  for (int i = 0; i < 6; ++i) {
    const int a = first + i, b = first + (i + 1) % 6;
    mesh.quad(a, a + 6, b + 6, b);
  }
  for (int side = 0; side < 2; ++side) {
    const int v = first + 6 * side;
    const auto end = [&](int a, int b, int c, int d) {
      if (side == 0) {
        mesh.quad(v + a, v + b, v + c, v + d);
      } else {
        mesh.quad(v + d, v + c, v + b, v + a);
      }
    };
    end(0, 1, 4, 5);
    end(1, 2, 3, 4);
  }
}

void gableEnds(Mesh& mesh, Point lower, int width, int depth, int rise) {
  const Point north = lower + Point{0, depth, 0};
  const Point tip = lower + Point{0, depth / 2, rise};
  const Point across{width, 0, 0};
  mesh.polygon({lower, tip, north});
  mesh.polygon({lower + across, north + across, tip + across});
}

void slabWithHole(Mesh& mesh, Point lower, Point upper, Point holeLower, Point holeUpper) {
  box(mesh, lower, {holeLower.x, upper.y, upper.z});
  box(mesh, {holeUpper.x, lower.y, lower.z}, upper);
  box(mesh, {holeLower.x, lower.y, lower.z}, {holeUpper.x, holeLower.y, upper.z});
  box(mesh, {holeLower.x, holeUpper.y, lower.z}, {holeUpper.x, upper.y, upper.z});
}

}  // namespace footfall::samples
