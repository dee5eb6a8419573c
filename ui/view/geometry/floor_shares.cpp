// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/floor_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kFloorsPerTask = 4096;
constexpr double kInsideMargin = 1e-6;  // share of a triangle's area: corners that are outside by less count as inside
constexpr double kThinnest = 1e-7;  // share of the smaller area: triangles that share less, at an edge, do not overlap
constexpr double kDoubled = 0.5;    // share of a floor's area: a decal on a floor is no copy of it
constexpr double kApart = 1e-3;  // share of a piece's extent: joined pieces may lie a little above or below their floor

using CornerPlaces = std::array<Vec3, 3>;

CornerPlaces cornerPlacesOf(const std::vector<Vec3>& vertices, const Triangle& t) {
  return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
}

double planCross(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Twice the area in the plan, above 0 where the triangle faces up.
double planArea(const CornerPlaces& p) { return planCross(p[0], p[1], p[2]); }

double spaceAreaOf(const CornerPlaces& p) { return detail::areaOf(p[0], p[1], p[2]); }

double heightAt(const CornerPlaces& p, double x, double y) {
  const double area = planArea(p);
  const Vec3 at{x, y, 0};
  return (planCross(p[1], p[2], at) * p[0].z + planCross(p[2], p[0], at) * p[1].z +
          planCross(p[0], p[1], at) * p[2].z) /
         area;
}

bool isInside(const CornerPlaces& piece, const CornerPlaces& floor) {
  const double area = planArea(floor);
  if (!(std::abs(area) > 0)) return false;
  return std::ranges::all_of(piece, [&](const Vec3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (planCross(floor[k], floor[(k + 1) % 3], p) / area < -kInsideMargin) return false;
    }
    return true;
  });
}

Box boxOf(const CornerPlaces& p) {
  const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
  const auto [z0, z1] = std::minmax({p[0].z, p[1].z, p[2].z});
  return {{x0, y0, z0}, {x1, y1, z1}};
}

// The part of the piece's area that lies over the floor, at its height.
double shareOf(const CornerPlaces& piece, const CornerPlaces& floor, double slack) {
  const double facing = planArea(floor) < 0 ? -1 : 1;
  std::array<Vec3, 9> polygon{piece[0], piece[1], piece[2]};
  std::size_t size = 3;
  for (std::size_t k = 0; k < 3 && size > 0; ++k) {
    const Vec3 &a = floor[k], &b = floor[(k + 1) % 3];
    std::array<Vec3, 9> kept;
    std::size_t left = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % size];
      const double dp = facing * planCross(a, b, p), dq = facing * planCross(a, b, q);
      if (dp >= 0 && left < kept.size()) kept[left++] = p;
      if ((dp > 0) == (dq > 0) || dp == 0 || dq == 0 || left == kept.size()) continue;
      const double t = dp / (dp - dq);
      kept[left++] = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
    }
    polygon = kept;
    size = left;
  }
  double twice = 0;
  Vec3 middle;
  for (std::size_t i = 0; i < size; ++i) {
    if (i >= 2) twice += planCross(polygon[0], polygon[i - 1], polygon[i]);
    middle.x += polygon[i].x / static_cast<double>(size);
    middle.y += polygon[i].y / static_cast<double>(size);
  }
  const double all = std::abs(planArea(piece));
  if (!(std::abs(twice) > kThinnest * std::min(all, std::abs(planArea(floor))))) return 0;
  const double apart = std::abs(heightAt(piece, middle.x, middle.y) - heightAt(floor, middle.x, middle.y));
  return apart <= slack ? std::abs(twice) / all * spaceAreaOf(piece) : 0;
}

bool mayBeFloor(const Environment& environment, const CornerPlaces& corners) {
  const double area = planArea(corners);
  return environment.bothSides ? area != 0 : area > 0;
}

// A tree of all triangles of the environment that may be floors, and for which `isIn` is true.
template <typename IsIn>
TriangleTree treeOf(const Environment& environment, IsIn isIn) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    const CornerPlaces corners = cornerPlacesOf(environment.vertices, environment.triangles[t]);
    if (!mayBeFloor(environment, corners) || !isIn(t)) continue;
    boxes.push_back(boxOf(corners));
    ids.push_back(static_cast<std::int32_t>(t));
  }
  TriangleTree tree;
  tree.build(boxes, ids);
  return tree;
}

struct Surroundings {
  Box box;
  double slack = 0;  // pieces within this height above and below lie on the floor
};

Surroundings around(const CornerPlaces& piece) {
  Surroundings found;
  found.box = boxOf(piece);
  const Box& box = found.box;
  found.slack = kApart * std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  found.box.lower[2] -= found.slack;
  found.box.upper[2] += found.slack;
  return found;
}

// The items that find(number, stack, items) adds for each number from 0 to count, in that order, found on all threads.
template <typename Item, typename Find>
std::vector<Item> inOrder(std::size_t count, Find find) {
  std::vector<std::vector<Item>> found((count + kFloorsPerTask - 1) / kFloorsPerTask);
  forRanges(found.size(), 1, [&](std::size_t first, std::size_t last) {
    std::vector<std::int32_t> stack;
    for (std::size_t part = first; part < last; ++part) {
      for (std::size_t i = part * kFloorsPerTask; i < std::min(count, (part + 1) * kFloorsPerTask); ++i)
        find(i, stack, found[part]);
    }
  });
  std::vector<Item> all;
  for (const std::vector<Item>& items : found) all.insert(all.end(), items.begin(), items.end());
  return all;
}

}  // namespace

std::vector<FloorShare> floorsUnder(const NavigationMesh& mesh, const Environment& environment) {
  const auto pieceOf = [&](std::size_t t) { return cornerPlacesOf(mesh.vertices, mesh.triangles[t]); };
  const auto sourceOf = [&](std::size_t t) {
    return t < mesh.sourceTriangles.size() ? std::size_t{mesh.sourceTriangles[t]} : environment.triangles.size();
  };
  std::vector<char> inSource(mesh.triangles.size());
  forRanges(inSource.size(), kFloorsPerTask, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const std::size_t source = sourceOf(t);
      inSource[t] = source < environment.triangles.size() &&
                    isInside(pieceOf(t), cornerPlacesOf(environment.vertices, environment.triangles[source]));
    }
  });
  TriangleTree tree;
  if (std::ranges::find(inSource, char{0}) != inSource.end())
    tree = treeOf(environment, [](std::size_t) { return true; });
  return inOrder<FloorShare>(inSource.size(), [&](std::size_t t, std::vector<std::int32_t>& stack, auto& shares) {
    const CornerPlaces piece = pieceOf(t);
    const auto number = static_cast<std::uint32_t>(t);
    if (inSource[t]) return shares.push_back({number, static_cast<std::uint32_t>(sourceOf(t)), spaceAreaOf(piece)});
    const Surroundings near = around(piece);
    tree.visitOverlapping(near.box, stack, [&](std::int32_t id) {
      const auto floor = static_cast<std::uint32_t>(id);
      const double area =
          shareOf(piece, cornerPlacesOf(environment.vertices, environment.triangles[floor]), near.slack);
      if (area > 0) shares.push_back({number, floor, area});
      return true;
    });
  });
}

std::vector<DoubledFloor> doubledFloors(const std::vector<FloorShare>& shares, const Environment& environment) {
  std::vector<bool> named(environment.triangles.size(), false);
  for (const FloorShare& share : shares) named[share.floor] = true;
  const TriangleTree tree = treeOf(environment, [&](std::size_t t) { return bool(named[t]); });
  return inOrder<DoubledFloor>(named.size(), [&](std::size_t t, std::vector<std::int32_t>& stack, auto& doubled) {
    const CornerPlaces floor = cornerPlacesOf(environment.vertices, environment.triangles[t]);
    if (named[t] || !mayBeFloor(environment, floor)) return;
    const Surroundings near = around(floor);
    const std::size_t before = doubled.size();
    double area = 0;
    tree.visitOverlapping(near.box, stack, [&](std::int32_t id) {
      const auto other = static_cast<std::uint32_t>(id);
      const double common =
          shareOf(floor, cornerPlacesOf(environment.vertices, environment.triangles[other]), near.slack);
      if (common > 0) doubled.push_back({static_cast<std::uint32_t>(t), other});
      area += common;
      return true;
    });
    if (area < kDoubled * spaceAreaOf(floor)) doubled.resize(before);
  });
}

}  // namespace footfall::ui
