// Makes the product from the last state: split along obstacle edges, rounded, repaired, with connections.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "core/assembly/mesh_assembly.hpp"
#include "core/assembly/obstacle_split.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/poll.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/filters/rounding/known_places.hpp"
#include "core/filters/rounding/placed_mesh.hpp"
#include "core/filters/rounding/rounded_drops.hpp"
#include "core/filters/rounding/rounded_links.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "core/filters/rounding/settled_product.hpp"
#include "core/mesh/first_uses.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPerTask = 2048;

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }

// Each once, whatever its sides: sorted by the places of their ends, as the first side in the order of the result.
void addObstacleEdges(const RoundedMesh& mesh, const std::vector<Index>& order, const std::vector<Index>& renumbered,
                      NavigationMesh& result) {
  std::vector<std::tuple<std::array<Place, 2>, std::size_t, int>> edges;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const MeshTriangle& t = mesh.triangles[order[i]];
    for (int k = 0; k < 3; ++k) {
      if ((t.obstacleEdges >> k & 1) == 0) continue;
      const Place a = placeOf(mesh.vertices[t.corners[k]]), b = placeOf(mesh.vertices[t.corners[next(k)]]);
      edges.push_back({{std::min(a, b), std::max(a, b)}, i, k});
    }
  }
  parallelSort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && std::get<0>(edges[i]) == std::get<0>(edges[i - 1])) continue;
    const auto& [places, place, k] = edges[i];
    const auto& corners = mesh.triangles[order[place]].corners;
    result.obstacleEdges.push_back(
        {static_cast<std::uint32_t>(renumbered[corners[k]]), static_cast<std::uint32_t>(renumbered[corners[next(k)]])});
  }
}

// Sorted by the numbers of their vertices.
void addConnections(const RoundedMesh& mesh, const Adjacency& topology, const std::vector<Index>& renumbered,
                    NavigationMesh& result) {
  if (mesh.layers.empty()) return;
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    const auto sides = topology.sidesOf(e);
    const std::uint32_t layer = mesh.layers[sides[0] / 3];
    if (std::all_of(sides.begin(), sides.end(), [&](Index s) { return mesh.layers[s / 3] == layer; })) continue;
    const MeshTriangle& t = mesh.triangles[sides[0] / 3];
    const auto a = static_cast<std::uint32_t>(renumbered[t.corners[sides[0] % 3]]);
    const auto b = static_cast<std::uint32_t>(renumbered[t.corners[next(sides[0] % 3)]]);
    result.connections.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(result.connections.begin(), result.connections.end());
}

Vec3 middleOf(const Vec3& a, const Vec3& b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2}; }

// A split mesh, with the places of the mesh that it was made from.
RoundedMesh withPlaces(SplitMesh split, const std::vector<Vec3>& places) {
  RoundedMesh rounded{{}, std::move(split.triangles), std::move(split.layers)};
  rounded.vertices.reserve(split.vertices.size());
  for (const auto& [origin, middle] : split.vertices)
    rounded.vertices.push_back(origin >= 0 ? places[origin] : middleOf(places[middle[0]], places[middle[1]]));
  return rounded;
}

/// A mesh that is split, with its edges.
struct SplitParts {
  SplitMesh mesh;
  Adjacency topology;
};

// Triangles have their numbers in place of layers; all later steps carry these along.
SplitParts splitOf(const std::vector<MeshTriangle>& triangles, std::size_t vertexCount, const Adjacency& edges,
                   Poll poll) {
  std::vector<std::uint32_t> numbers(triangles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  SplitParts parts{splitAtObstacleEdges(triangles, numbers, vertexCount, edges, poll), {}};
  parts.topology = findEdges(parts.mesh.triangles, parts.mesh.vertices.size(), poll);
  return parts;
}

// Vertices that rounding moved, and ends of obstacle edges.
std::vector<char> suspectsOf(const RoundedMesh& mesh, const std::vector<char>& sturdy) {
  std::vector<char> suspects(sturdy.size());
  std::transform(sturdy.begin(), sturdy.end(), suspects.begin(), [](char s) { return static_cast<char>(s == 0); });
  for (const MeshTriangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if ((t.obstacleEdges >> k & 1) != 0) suspects[t.corners[k]] = suspects[t.corners[next(k)]] = 1;
  return suspects;
}

// Repairs can merge the two sides of an obstacle, so each side gets its own vertices once more.
void splitAgain(RoundedMesh& mesh, const Adjacency& topology) {
  mesh = withPlaces(splitAtObstacleEdges(mesh.triangles, mesh.layers, mesh.vertices.size(), topology), mesh.vertices);
}

// Stable, by counting.
std::vector<Index> orderByLayer(const RoundedMesh& mesh) {
  std::vector<Index> order(mesh.triangles.size());
  std::vector<Index> start{0};
  for (const std::uint32_t layer : mesh.layers) {
    if (start.size() < layer + 2) start.resize(layer + 2, 0);
    ++start[layer + 1];
  }
  for (std::size_t l = 1; l < start.size(); ++l) start[l] += start[l - 1];
  for (std::size_t t = 0; t < order.size(); ++t)
    order[mesh.layers.empty() ? t : start[mesh.layers[t]]++] = static_cast<Index>(t);
  return order;
}

// Sides without another one, with the triangles in another order.
std::vector<Index> bordersOf(const Adjacency& topology, const std::vector<Index>& order) {
  std::vector<Index> places(order.size()), borders;
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = static_cast<Index>(i);
  for (Index e = 0; e < topology.edgeCount(); ++e)
    if (const auto sides = topology.sidesOf(e); sides.size() == 1)
      borders.push_back(3 * places[sides[0] / 3] + sides[0] % 3);
  return borders;
}

// Repairs what rounding broke. `places` and `exact` are those of the vertices before they were split.
SettledMesh settle(SplitParts parts, const std::vector<Vec3>& places, const std::vector<char>& exact,
                   RunContext& context) {
  std::vector<char> sturdy;
  sturdy.reserve(parts.mesh.vertices.size());
  for (const SplitVertex& v : parts.mesh.vertices) sturdy.push_back(v.origin >= 0 ? exact[v.origin] : char{0});
  SettledMesh settled{withPlaces(std::move(parts.mesh), places), std::move(parts.topology), {}, {}};
  auto& rounded = settled.mesh;
  auto& topology = settled.topology;
  context.checkCancelled();
  const auto findAgain = [&context](const SettledMesh& made) {
    return findEdges(made.mesh.triangles, made.mesh.vertices.size(), Poll(context));
  };
  std::vector<char> suspects = suspectsOf(rounded, sturdy);
  const auto repair = [&context](SettledMesh& made, const std::vector<char>& kept) {
    const std::vector<Index> crowded = markBorders(made.mesh, made.topology);
    const RoundingCases cases = repairRounding(made.mesh, kept, context, crowded);
    for (const auto& [from, to] : cases.collapsed)
      made.moved.push_back({made.mesh.vertices[from], made.mesh.vertices[to]});
    return cases.anyBroken();
  };
  if (repair(settled, sturdy)) {
    topology = findAgain(settled);
    suspects.clear();
  }
  context.checkCancelled();
  // The middle of an edge of a few units in the last place need not lie on it, and can turn a triangle over.
  constexpr int kMostRounds = 8;
  for (int round = 0; settleBorders(rounded, topology) && round < kMostRounds; ++round) {
    splitAgain(rounded, topology);
    topology = findAgain(settled);
    suspects.clear();
    if (repair(settled, std::vector<char>(rounded.vertices.size(), 0))) topology = findAgain(settled);
  }
  dropSharedObstacles(rounded, topology);
  context.checkCancelled();
  if (markClosedSlivers(rounded, topology, suspects, context)) topology = findAgain(settled);
  context.checkCancelled();
  settled.origins = std::exchange(rounded.layers, {});
  return settled;
}

// `layers` are those of the mesh that was given, or empty.
void addLayers(SettledMesh& settled, const std::vector<std::uint32_t>& layers) {
  if (layers.empty()) return;
  settled.mesh.layers.reserve(settled.origins.size());
  for (const std::uint32_t origin : settled.origins) settled.mesh.layers.push_back(layers[origin]);
}

// Triangles in the given order; vertices in the order of their first use. `sources` has the input triangle of each
// face.
std::shared_ptr<NavigationMesh> numbered(const SettledMesh& settled, const std::vector<Index>& order,
                                         std::span<const std::uint32_t> sources, const RunContext& context) {
  const RoundedMesh& rounded = settled.mesh;
  const auto cornersOf = [&](std::size_t i) { return rounded.triangles[order[i]].corners; };
  auto result = std::make_shared<NavigationMesh>();
  FirstUses uses;
  parallelInvoke(
      [&] {
        uses = findFirstUses(order.size(), rounded.vertices.size(), cornersOf, Poll(context));
        result->vertices.resize(uses.order.size());
      },
      [&] {
        result->triangles.resize(order.size());
        result->sourceTriangles.resize(order.size());
        result->layers.resize(rounded.layers.size());
      });
  forRanges(uses.order.size(), kPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t v = first; v < last; ++v) result->vertices[v] = rounded.vertices[uses.order[v]];
  });
  forRanges(order.size(), kPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t i = first; i < last; ++i) {
      const MeshTriangle& t = rounded.triangles[order[i]];
      for (int k = 0; k < 3; ++k) result->triangles[i][k] = static_cast<std::uint32_t>(uses.numbers[t.corners[k]]);
      result->sourceTriangles[i] = sources[t.face];
      if (!rounded.layers.empty()) result->layers[i] = rounded.layers[order[i]];
    }
  });
  context.checkCancelled();
  addObstacleEdges(rounded, order, uses.numbers, *result);
  addConnections(rounded, settled.topology, uses.numbers, *result);
  return result;
}

}  // namespace

std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& given, RunContext& context) {
  std::shared_ptr<const RoundedPlaces> rounded;
  return makeNavigationMesh(given, {}, rounded, context);
}

std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& given, const KnownPlaces& known,
                                                         std::shared_ptr<const RoundedPlaces>& kept,
                                                         RunContext& context) {
  ExactFallbacks fallbacks;
  const StatePtr state = withMesh(given, context, fallbacks);
  SettledProduct product = settleProduct(*state, *topologyOf(*state, Poll(context)), known, context);
  kept = product.rounded;
  return makeNavigationMesh(*state, std::move(product), context);
}

SettledProduct settleProduct(const WalkableState& state, const Adjacency& topology, const KnownPlaces& known,
                             RunContext& context) {
  const WalkableMesh& mesh = *state.mesh;
  const auto rounded = std::make_shared<RoundedPlaces>();
  SplitParts parts;
  parallelInvoke([&] { *rounded = roundVertices(*state.kernel, mesh.vertices, known, context); },
                 [&] { parts = splitOf(mesh.triangles, mesh.vertices.size(), topology, context); });
  SettledMesh settled = settle(std::move(parts), rounded->places, rounded->exact, context);
  return {rounded, std::move(settled)};
}

std::shared_ptr<const NavigationMesh> makeNavigationMesh(const WalkableState& state, SettledProduct product,
                                                         const RunContext& context) {
  const WalkableMesh& mesh = *state.mesh;
  SettledMesh& settled = product.settled;
  const std::vector<Vec3>& places = product.rounded->places;
  addLayers(settled, mesh.layers);
  const std::vector<Index> order = orderByLayer(settled.mesh);
  const auto& sources = state.kernel->mesh().inputTriangles;
  const auto result = numbered(settled, order, {sources.begin(), sources.end()}, context);
  result->layerCount = mesh.layerCount;
  result->frame = state.environment->frame();
  if (!mesh.links.empty())
    result->links = roundLinks(mesh.links, places, settled.moved, bordersOf(settled.topology, order), *result);
  if (!mesh.drops.empty()) {
    std::vector<std::uint32_t> origins(order.size());
    std::transform(order.begin(), order.end(), origins.begin(), [&](Index t) { return settled.origins[t]; });
    result->drops = roundDrops(state, places, settled.moved, *result, origins, Poll(context));
  }
  return result;
}

std::shared_ptr<NavigationMesh> makeNavigationMesh(const PlacedMesh& mesh, RunContext& context) {
  const std::size_t count = mesh.places.size();
  const Adjacency edges = findEdges(mesh.triangles, count, Poll(context));
  const std::vector<MeshLink> links = linksBetween(mesh.links, mesh.triangles, edges);
  SettledMesh settled = settle(splitOf(mesh.triangles, count, edges, context), mesh.places, mesh.exact, context);
  addLayers(settled, mesh.layers);
  const std::vector<Index> order = orderByLayer(settled.mesh);
  std::shared_ptr<NavigationMesh> result = numbered(settled, order, mesh.sources, context);
  for (const std::uint32_t layer : mesh.layers) result->layerCount = std::max(result->layerCount, layer + 1);
  if (!links.empty())
    result->links = roundLinks(links, mesh.places, settled.moved, bordersOf(settled.topology, order), *result);
  return result;
}

}  // namespace footfall::detail
