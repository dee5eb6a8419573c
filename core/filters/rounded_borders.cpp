// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "core/environment/triangle_tree.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/rounded_mesh.hpp"
#include "core/filters/triangle_split.hpp"

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }

/// An edge with a triangle on one side only.
struct Border {
  Index from = -1, to = -1;
  Index triangle = -1;
  int k = 0;
};

/// Calls visit(sides) for every edge, with the numbers 3 * triangle + k of all its sides.
template <class Visit>
void visitEdges(const RoundedMesh& mesh, Visit visit) {
  std::vector<std::array<Index, 3>> uses;  // vertices (smaller first) and side
  uses.reserve(mesh.triangles.size() * 3);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t].corners[k], b = mesh.triangles[t].corners[next(k)];
      uses.push_back({std::min(a, b), std::max(a, b), 3 * t + k});
    }
  tbb::parallel_sort(uses.begin(), uses.end());
  std::vector<Index> sides;
  for (std::size_t i = 0; i < uses.size();) {
    sides.clear();
    std::size_t j = i;
    for (; j < uses.size() && uses[j][0] == uses[i][0] && uses[j][1] == uses[i][1]; ++j) sides.push_back(uses[j][2]);
    visit(sides);
    i = j;
  }
}

std::vector<Border> findBorders(const RoundedMesh& mesh) {
  std::vector<Border> borders;
  visitEdges(mesh, [&](const std::vector<Index>& sides) {
    if (sides.size() > 1) return;
    const Index t = sides[0] / 3;
    const int k = sides[0] % 3;
    borders.push_back({mesh.triangles[t].corners[k], mesh.triangles[t].corners[next(k)], t, k});
  });
  return borders;
}

// p lies strictly between a and b, which differ; all three are known to be collinear.
bool isBetween(const Vec3& a, const Vec3& p, const Vec3& b) {
  const Place pa = placeOf(a), pp = placeOf(p), pb = placeOf(b);
  return (pa < pp && pp < pb) || (pb < pp && pp < pa);  // order along a line is the order of x, then y, then z
}

/// For each border with ends of others strictly inside it: those places, and the border's number.
std::map<std::size_t, std::vector<Place>> findInnerEnds(const RoundedMesh& mesh, const std::vector<Border>& borders,
                                                        RunContext& context) {
  const auto boxOf = [&](const Border& e) {
    const Vec3 &a = mesh.vertices[e.from], &b = mesh.vertices[e.to];
    return Box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
               {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
  };
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    boxes.push_back(boxOf(borders[i]));
    ids.push_back(static_cast<std::int32_t>(i));
  }
  TriangleTree tree;
  tree.build(std::move(boxes), std::move(ids), [&context] { context.checkCancelled(); });

  std::map<std::size_t, std::vector<Place>> inner;
  std::vector<std::int32_t> stack;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    if ((i & 1023) == 0) context.checkCancelled();
    const Vec3 &v = mesh.vertices[borders[i].from], &w = mesh.vertices[borders[i].to];
    tree.visitOverlapping(boxOf(borders[i]), stack, [&](std::int32_t o) {
      const Vec3 &a = mesh.vertices[borders[o].from], &b = mesh.vertices[borders[o].to];
      const double along = (w.x - v.x) * (b.x - a.x) + (w.y - v.y) * (b.y - a.y) + (w.z - v.z) * (b.z - a.z);
      if (along >= 0 || !isDegenerate(a, b, v) || !isDegenerate(a, b, w)) return true;  // only opposite ones meet
      for (const Vec3* p : {&v, &w})
        if (isBetween(a, *p, b)) inner[static_cast<std::size_t>(o)].push_back(placeOf(*p));
      return true;
    });
  }
  return inner;
}

void splitBorders(RoundedMesh& mesh, const std::vector<Border>& borders,
                  const std::map<std::size_t, std::vector<Place>>& inner) {
  if (inner.empty()) return;
  std::map<Index, std::array<std::vector<Index>, 3>> splits;
  for (const auto& [number, given] : inner) {
    const Border& e = borders[number];
    std::vector<Place> places = given;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (placeOf(mesh.vertices[e.to]) < placeOf(mesh.vertices[e.from])) std::reverse(places.begin(), places.end());
    for (const auto& [x, y, z] : places) {
      splits[e.triangle][e.k].push_back(static_cast<Index>(mesh.vertices.size()));
      mesh.vertices.push_back({x, y, z});
    }
  }
  std::vector<MeshTriangle> triangles;
  std::vector<std::uint32_t> layers;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (const auto it = splits.find(t); it != splits.end())
      splitTriangle(mesh.triangles[t], {&it->second[0], &it->second[1], &it->second[2]}, triangles);
    else
      triangles.push_back(mesh.triangles[t]);
    if (!mesh.layers.empty()) layers.resize(triangles.size(), mesh.layers[t]);
  }
  mesh.triangles = std::move(triangles);
  mesh.layers = std::move(layers);
}

}  // namespace

void markBorders(RoundedMesh& mesh) {
  for (const Border& e : findBorders(mesh))
    mesh.triangles[e.triangle].obstacleEdges |= static_cast<std::uint8_t>(1 << e.k);
}

bool settleBorders(RoundedMesh& mesh) {
  bool shared = false;
  visitEdges(mesh, [&](const std::vector<Index>& sides) {
    bool flagged = false;
    for (const Index s : sides) flagged = flagged || (mesh.triangles[s / 3].obstacleEdges >> (s % 3) & 1) != 0;
    const bool obstacle = flagged && sides.size() > 1;
    shared = shared || obstacle;
    for (const Index s : sides) {
      std::uint8_t& flags = mesh.triangles[s / 3].obstacleEdges;
      const auto bit = static_cast<std::uint8_t>(1 << (s % 3));
      flags = static_cast<std::uint8_t>(obstacle ? flags | bit : flags & ~bit);
    }
  });
  return shared;
}

void markClosedSlivers(RoundedMesh& mesh, RunContext& context) {
  std::vector<Border> borders = findBorders(mesh);
  if (const auto inner = findInnerEnds(mesh, borders, context); !inner.empty()) {
    splitBorders(mesh, borders, inner);
    borders = findBorders(mesh);
  }
  const auto keyOf = [&](const Border& e) {
    const Place a = placeOf(mesh.vertices[e.from]), b = placeOf(mesh.vertices[e.to]);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto runsForward = [&](const Border& e) {
    return placeOf(mesh.vertices[e.from]) < placeOf(mesh.vertices[e.to]);
  };
  std::sort(borders.begin(), borders.end(), [&](const Border& x, const Border& y) {
    const auto kx = keyOf(x), ky = keyOf(y);
    return kx != ky ? kx < ky : x.triangle < y.triangle;
  });
  for (std::size_t i = 0; i < borders.size();) {
    std::size_t j = i;
    bool forward = false, backward = false;
    for (; j < borders.size() && keyOf(borders[j]) == keyOf(borders[i]); ++j)
      (runsForward(borders[j]) ? forward : backward) = true;
    if (forward && backward)
      for (std::size_t m = i; m < j; ++m)
        mesh.triangles[borders[m].triangle].obstacleEdges |= static_cast<std::uint8_t>(1 << borders[m].k);
    i = j;
  }
}

}  // namespace footfall
