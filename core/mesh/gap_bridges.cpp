// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/gap_bridges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

bool isSamePlace(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y; }

/// True when both edges of a link end at one place, at the given end.
bool meetsAt(const StepLink& link, std::span<const Vec3> vertices, int end) {
  return isSamePlace(vertices[link.from[end]], vertices[link.to[1 - end]]);
}

/// The edges of gaps that a step leads on from, or that have a bridge.
class TakenEdges {
 public:
  explicit TakenEdges(const NavigationMesh& mesh) : hasGap_(mesh.vertices.size(), 0) {
    for (const StepLink& link : mesh.links) {
      if (link.kind != StepKind::Gap) continue;
      edges_.push_back(link.from);
      edges_.push_back(link.to);
      hasGap_[link.from[0]] = hasGap_[link.to[0]] = 1;
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    isTaken_.assign(edges_.size(), 0);
  }

  void take(const StepLink& link) {
    for (const Edge& edge : {link.from, link.to})
      if (const std::size_t place = placeOf(edge); place < edges_.size()) isTaken_[place] = 1;
  }
  [[nodiscard]] bool hasEither(const StepLink& link) const {
    return isTaken_[placeOf(link.from)] != 0 || isTaken_[placeOf(link.to)] != 0;
  }

 private:
  using Edge = std::array<std::uint32_t, 2>;
  /// The place among the edges of gaps, or their number.
  [[nodiscard]] std::size_t placeOf(const Edge& edge) const {
    if (hasGap_[edge[0]] == 0) return edges_.size();
    const auto place = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return place != edges_.end() && *place == edge ? static_cast<std::size_t>(place - edges_.begin()) : edges_.size();
  }

  std::vector<char> hasGap_;  ///< of each vertex: an edge of a gap begins there
  std::vector<Edge> edges_;
  std::vector<char> isTaken_;
};

}  // namespace

std::vector<Triangle> bridgeOver(const StepLink& link, std::span<const Vec3> vertices) {
  const auto [a, b] = link.from;
  const auto [c, d] = link.to;
  const auto isUp = [&](const Triangle& t) { return facing(vertices[t[0]], vertices[t[1]], vertices[t[2]]) > 0; };
  std::vector<Triangle> bridge;
  if (meetsAt(link, vertices, 0) && meetsAt(link, vertices, 1)) return bridge;
  if (meetsAt(link, vertices, 0))
    bridge = {{b, a, c}};
  else if (meetsAt(link, vertices, 1))
    bridge = {{b, a, d}};
  else
    bridge = {{b, a, d}, {b, d, c}};
  if (!std::all_of(bridge.begin(), bridge.end(), isUp)) bridge.clear();
  return bridge;
}

double widthOf(const StepLink& link, std::span<const Vec3> vertices) {
  double width = 0;
  for (const int end : {0, 1}) {
    const Vec3 &p = vertices[link.from[end]], &q = vertices[link.to[1 - end]];
    if (isSamePlace(p, q)) continue;
    // Differences, squares and root are off by a few units in the last place at most.
    const double length = std::hypot(p.x - q.x, p.y - q.y) * (1 + 0x1p-48);
    width = std::max(width, std::nextafter(length, std::numeric_limits<double>::infinity()));
  }
  return width;
}

NavigationMesh withBridges(const NavigationMesh& mesh) {
  NavigationMesh bridged = mesh;
  TakenEdges taken(mesh);
  for (const StepLink& link : mesh.links)
    if (link.kind == StepKind::Step) taken.take(link);
  for (const StepLink& link : mesh.links) {
    if (link.kind != StepKind::Gap || taken.hasEither(link)) continue;
    const std::vector<Triangle> bridge = bridgeOver(link, mesh.vertices);
    if (bridge.empty()) continue;
    taken.take(link);
    const auto first = static_cast<std::uint32_t>(bridged.triangles.size());
    for (const Triangle& triangle : bridge) {
      bridged.triangles.push_back(triangle);
      bridged.sourceTriangles.push_back(mesh.sourceTriangles.empty() ? 0 : mesh.sourceTriangles[link.fromTriangle]);
      if (!mesh.layers.empty()) bridged.layers.push_back(mesh.layers[link.fromTriangle]);
    }
    const auto addStep = [&](const std::array<std::uint32_t, 2>& from) {
      if (from[0] == link.to[1] && from[1] == link.to[0]) return;
      bridged.links.push_back({from, link.to, first, link.toTriangle, link.height});
    };
    if (meetsAt(link, mesh.vertices, 0)) addStep({link.from[0], link.to[0]});
    if (meetsAt(link, mesh.vertices, 1)) addStep({link.to[1], link.from[1]});
  }
  return bridged;
}

}  // namespace footfall::detail
