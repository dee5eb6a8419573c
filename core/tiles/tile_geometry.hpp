// The definitions of a tile's vertices, over numbers that hold for a part of the environment alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/exact/plan_kernel.hpp"
#include "core/tiles/tile.hpp"

namespace footfall::detail {

/// The same point over other numbers: `planOf`, `vertexOf` and `triangleOf` give those of plan ids, vertices and
/// triangles. There are no borders between cells.
template <class PlanOf, class VertexOf, class TriangleOf>
PlanPoint renumbered(const PlanPoint& point, PlanOf planOf, VertexOf vertexOf, TriangleOf triangleOf) {
  const auto lineOf = [&](const PlanLine& line) {
    if (line.kind != PlanLine::Edge) return PlanLine{line.kind, triangleOf(line.a), line.b};
    const Index a = planOf(line.a), b = planOf(line.b);  // places of the plan alone are not in order
    return PlanLine{PlanLine::Edge, a < b ? a : b, a < b ? b : a};
  };
  switch (point.kind()) {
    case PlanPoint::Source:
      return PlanPoint::source(planOf(point.planId()));
    case PlanPoint::EdgePlane:
      return PlanPoint::edgePlane(vertexOf(point.edgeBegin()), vertexOf(point.edgeEnd()), triangleOf(point.triangle()),
                                  point.level());
    case PlanPoint::Crossing:
      break;
  }
  const PlanLine first = lineOf(point.firstLine()), second = lineOf(point.secondLine());
  return PlanPoint::crossing(first, second, point.face() < 0 ? -1 : triangleOf(point.face()));
}

/// The definitions of these vertices of a kernel's mesh. `numbers` holds the number in the environment of each of its
/// input triangles; empty: they are the same.
TileGeometry geometryOf(const PlanKernel& kernel, std::vector<MeshVertex> vertices,
                        const std::vector<std::uint32_t>& numbers);

/// The name of a vertex, of which `face` is the number in the environment of the first walkable triangle that has it.
TileBorder borderOf(const PlanKernel& kernel, const MeshVertex& vertex, bool isExact, Index number, std::uint32_t face);

/// Some triangles of a tile, with what their vertices are made of, and no links: those of which `chosen` is not 0.
/// `numbers` (may be null) receives for each vertex its number among them, or -1.
Tile chosenTriangles(const Tile& tile, const std::vector<char>& chosen, std::vector<Index>* numbers = nullptr);

}  // namespace footfall::detail
