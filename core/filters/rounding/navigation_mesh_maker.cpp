// From the last state to the product: split along obstacle edges, rounded, repaired, with connections.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "core/assembly/mesh_assembly.hpp"
#include "core/assembly/obstacle_split.hpp"
#include "core/base/geometry.hpp"
#include "core/base/poll.hpp"
#include "core/filters/filter.hpp"
#include "core/filters/rounding/rounded_drops.hpp"
#include "core/filters/rounding/rounded_links.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"

namespace footfall::detail {
namespace {

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
  tbb::parallel_sort(edges.begin(), edges.end());
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

// The split mesh of the state with the rounded places of the state's mesh, and its edges.
RoundedMesh roundSplitMesh(const WalkableState& state, std::vector<Vec3>& places, std::vector<char>& sturdy,
                           Adjacency& topology, RunContext& context) {
  const Poll poll(context);
  std::vector<char> exact;
  SplitMesh split;
  tbb::parallel_invoke([&] { places = roundVertices(*state.kernel, state.mesh->vertices, exact, context); },
                       [&] {
                         split = splitAtObstacleEdges(state.mesh->triangles, state.mesh->layers,
                                                      state.mesh->vertices.size(), *topologyOf(state, poll), poll);
                         topology = findEdges(split.triangles, split.vertices.size(), poll);
                       });
  sturdy.reserve(split.vertices.size());
  for (const SplitVertex& v : split.vertices) sturdy.push_back(v.origin >= 0 ? exact[v.origin] : char{0});
  return withPlaces(std::move(split), places);
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

// Repairs can bring the two sides of an obstacle together: give each its own vertices once more.
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

}  // namespace

std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& given, RunContext& context) {
  ExactFallbacks fallbacks;
  const StatePtr state = withMesh(given, context, fallbacks);
  const SourceMesh& source = state->kernel->mesh();
  const Poll poll(context);
  std::vector<char> sturdy;
  Adjacency topology;
  std::vector<Vec3> places;
  RoundedMesh rounded = roundSplitMesh(*state, places, sturdy, topology, context);
  context.checkCancelled();
  const auto edgesOf = [&] { return findEdges(rounded.triangles, rounded.vertices.size(), poll); };
  std::vector<char> suspects = suspectsOf(rounded, sturdy);
  markBorders(rounded, topology);
  std::vector<std::array<Vec3, 2>> moved;
  if (const RoundingCases cases = repairRounding(rounded, sturdy, context); cases.anyBroken()) {
    for (const auto& [from, to] : cases.collapsed) moved.push_back({rounded.vertices[from], rounded.vertices[to]});
    topology = edgesOf();
    suspects.clear();
  }
  context.checkCancelled();
  // The middle of an edge of a few units in the last place need not lie on it, and can turn a triangle over.
  constexpr int kMostRounds = 8;
  for (int round = 0; settleBorders(rounded, topology) && round < kMostRounds; ++round) {
    splitAgain(rounded, topology);
    topology = edgesOf();
    suspects.clear();
    markBorders(rounded, topology);
    const RoundingCases again = repairRounding(rounded, std::vector<char>(rounded.vertices.size(), 0), context);
    for (const auto& [from, to] : again.collapsed) moved.push_back({rounded.vertices[from], rounded.vertices[to]});
    if (again.anyBroken()) topology = edgesOf();
  }
  dropSharedObstacles(rounded, topology);
  context.checkCancelled();
  if (markClosedSlivers(rounded, topology, suspects, context)) topology = edgesOf();
  context.checkCancelled();

  // Triangles by layer, then in the order of the mesh; vertices in the order of their first use.
  const std::vector<Index> order = orderByLayer(rounded);
  auto result = std::make_shared<NavigationMesh>();
  result->triangles.reserve(order.size());
  result->sourceTriangles.reserve(order.size());
  result->layers.reserve(rounded.layers.size());
  std::vector<Index> renumbered(rounded.vertices.size(), -1);
  for (const Index i : order) {
    const MeshTriangle& t = rounded.triangles[i];
    Triangle corners{};
    for (int k = 0; k < 3; ++k) {
      Index& number = renumbered[t.corners[k]];
      if (number < 0) {
        number = static_cast<Index>(result->vertices.size());
        result->vertices.push_back(rounded.vertices[t.corners[k]]);
      }
      corners[k] = static_cast<std::uint32_t>(number);
    }
    result->triangles.push_back(corners);
    result->sourceTriangles.push_back(source.inputTriangles[t.face]);
    if (!rounded.layers.empty()) result->layers.push_back(rounded.layers[i]);
  }
  context.checkCancelled();
  result->layerCount = state->mesh->layerCount;
  result->frame = state->environment->frame();
  addObstacleEdges(rounded, order, renumbered, *result);
  addConnections(rounded, topology, renumbered, *result);
  if (!state->mesh->links.empty())
    result->links = roundLinks(state->mesh->links, places, moved, bordersOf(topology, order), *result);
  result->drops = roundDrops(*state, places, moved, *result);
  return result;
}

}  // namespace footfall::detail
