// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/triangle_cutter.hpp"

#include <algorithm>
#include <cassert>

namespace footfall::detail {
namespace {

std::array<double, 3> coordinates(const Vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

TriangleCutter::TriangleCutter(const CutGeometry& geometry, const Partition& partition)
    : geometry_(geometry), partition_(partition) {
  for (const Partition::Node& node : partition.nodes) {
    Index number = -1;
    if (node.axis != 2) {
      const auto& borders = partition.borders[static_cast<std::size_t>(node.axis)];
      number = static_cast<Index>(std::lower_bound(borders.begin(), borders.end(), node.coordinate) - borders.begin());
      assert(number < static_cast<Index>(borders.size()) && geometry.border(node.axis, number) == node.coordinate);
    }
    borderOfNode_.push_back(number);
  }
}

Index TriangleCutter::descend(Index triangle) const {
  if (partition_.nodes.empty()) return -1;
  const SourceMesh& mesh = geometry_.mesh();
  const auto& f = mesh.triangles[triangle];
  auto lower = coordinates(mesh.vertices[f[0]]), upper = lower;
  if (mesh.degenerate[triangle] == 0)
    for (const Index v : {f[1], f[2]}) {
      const auto p = coordinates(mesh.vertices[v]);
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], p[k]);
        upper[k] = std::max(upper[k], p[k]);
      }
    }
  upper[2] = lower[2];
  Index child = 0;
  while (child >= 0) {
    const Partition::Node& node = partition_.nodes[child];
    const auto axis = static_cast<std::size_t>(node.axis);
    if (lower[axis] >= node.coordinate)
      child = node.above;
    else if (upper[axis] <= node.coordinate)
      child = node.below;
    else
      break;
  }
  return child;
}

void TriangleCutter::cut(Index triangle, Index node, CutPieces& pieces) const {
  const SourceMesh& mesh = geometry_.mesh();
  const auto& f = mesh.triangles[triangle];
  Polygon whole;
  for (Index k = 0; k < 3; ++k) whole.push({CutVertex::Source, f[static_cast<std::size_t>(k)]}, {PieceSide::kEdge, k});
  const double z = std::min({mesh.vertices[f[0]].z, mesh.vertices[f[1]].z, mesh.vertices[f[2]].z});
  cut(triangle, whole, node, z, pieces);
}

CutVertex TriangleCutter::crossing(Index triangle, const PieceSide& side, const PieceSide& border) const {
  if (side.axis == PieceSide::kEdge) {
    const auto& f = geometry_.mesh().triangles[triangle];
    const auto k = static_cast<std::size_t>(side.number);
    return geometry_.edgePoint(f[k], f[k == 2 ? 0 : k + 1], border.axis, border.number);
  }
  CutVertex point{CutVertex::Inside, triangle};
  point.borders[static_cast<std::size_t>(side.axis)] = side.number;
  point.borders[static_cast<std::size_t>(border.axis)] = border.number;
  return point;
}

void TriangleCutter::cut(Index triangle, const Polygon& whole, Index child, double z, CutPieces& pieces) const {
  if (child < 0) {
    pieces.pieces.push_back({pieces.corners.size(), whole.size, -1 - child});
    pieces.corners.insert(pieces.corners.end(), whole.corners.begin(), whole.corners.begin() + whole.size);
    return;
  }
  const Partition::Node& node = partition_.nodes[child];
  if (node.axis == 2) return cut(triangle, whole, z < node.coordinate ? node.below : node.above, z, pieces);
  const PieceSide border{node.axis, borderOfNode_[static_cast<std::size_t>(child)]};
  std::array<int, 10> signs;  // NOLINT: set below
  bool hasBelow = false, hasAbove = false;
  for (std::size_t k = 0; k < whole.size; ++k) {
    signs[k] = geometry_.side(whole.corners[k].vertex, border.axis, border.number);
    hasBelow = hasBelow || signs[k] < 0;
    hasAbove = hasAbove || signs[k] > 0;
  }
  // A part on the border alone belongs above.
  if (!hasBelow || !hasAbove) return cut(triangle, whole, hasBelow ? node.below : node.above, z, pieces);
  Polygon below, above;
  for (std::size_t k = 0; k < whole.size; ++k) {
    const auto& [vertex, side] = whole.corners[k];
    const int here = signs[k], next = signs[k + 1 == whole.size ? 0 : k + 1];
    if (here <= 0) below.push(vertex, here == 0 && next > 0 ? border : side);
    if (here >= 0) above.push(vertex, here == 0 && next < 0 ? border : side);
    if (here * next >= 0) continue;
    const CutVertex point = crossing(triangle, side, border);
    below.push(point, here < 0 ? border : side);
    above.push(point, here > 0 ? border : side);
  }
  cut(triangle, below, node.below, z, pieces);
  cut(triangle, above, node.above, z, pieces);
}

}  // namespace footfall::detail
