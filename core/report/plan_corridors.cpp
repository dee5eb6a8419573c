// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_corridors.hpp"

#include <algorithm>
#include <limits>

#include "core/base/counted_text.hpp"
#include "core/navigation/corridor_places.hpp"

namespace footfall::detail {
namespace {

// Millimetres on the paper.
constexpr double kLine = 0.13, kDimension = 0.25, kTick = 0.9, kLetters = 1.9;

/// The triangle under a place of an edge: the one that it lies farthest inside of.
std::uint32_t triangleUnder(const NavigationMesh& mesh, const CorridorEdge& edge, const Vec3& p) {
  std::uint32_t best = edge.triangles.front();
  double most = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : edge.triangles) {
    double inside = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = mesh.vertices[mesh.triangles[t][i]], &b = mesh.vertices[mesh.triangles[t][(i + 1) % 3]];
      inside = std::min(inside, (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
    }
    if (inside <= most) continue;
    most = inside;
    best = t;
  }
  return best;
}

}  // namespace

PlanCorridorContents drawCorridors(const PlanCorridors& corridors, const NavigationMesh& mesh,
                                   const std::vector<char>& isHere, double metresPerUnit, const PlanLayout& layout,
                                   const Rgb& lineColour, const Rgb& dimensionColour, std::vector<SheetShape>& drawing,
                                   std::vector<SheetText>& words) {
  PlanCorridorContents contents;
  const CorridorMap& map = corridors.map;
  SheetPath lines{{}, false, {}, SheetStroke{lineColour, kLine}};
  for (const CorridorEdge& edge : map.edges) {
    if (!corridors.hasLines) break;
    if (std::ranges::none_of(edge.triangles, [&isHere](std::uint32_t t) { return isHere[t] != 0; })) continue;
    std::vector<SheetPoint>& line = lines.lines.emplace_back();
    for (const Vec3& p : placesAlong(map, edge)) line.push_back(layout.at(p.x, p.y));
  }
  contents.lines = !lines.lines.empty();
  if (contents.lines) drawing.emplace_back(std::move(lines));
  for (const std::size_t i : corridors.narrow) {
    const Bottleneck& b = map.bottlenecks[i];
    const CorridorEdge& edge = map.edges[b.edge];
    if (edge.triangles.empty() || isHere[triangleUnder(mesh, edge, b.place)] == 0) continue;
    contents.bottlenecks = true;
    const SheetPoint left = layout.at(b.left.x, b.left.y), right = layout.at(b.right.x, b.right.y);
    addDimension(drawing, left, right, dimensionColour);
    words.push_back({{std::max(left.x, right.x) + kTick, std::max(left.y, right.y) + kTick / 2},
                     formatted(b.width * metresPerUnit, "%.2f") + " m",
                     kLetters,
                     SheetAnchor::Left,
                     dimensionColour,
                     true,
                     true});
  }
  return contents;
}

void addDimension(std::vector<SheetShape>& drawing, SheetPoint a, SheetPoint b, const Rgb& colour) {
  SheetPath path{{{a, b}}, false, {}, SheetStroke{colour, kDimension}};
  for (const SheetPoint& end : {a, b})
    path.lines.push_back({{end.x - kTick / 2, end.y - kTick / 2}, {end.x + kTick / 2, end.y + kTick / 2}});
  drawing.emplace_back(std::move(path));
}

}  // namespace footfall::detail
