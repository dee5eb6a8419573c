// From the last state to the product: split along obstacle edges, rounded, repaired, with connections.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/filters/filter.hpp"
#include "core/filters/mesh_assembly.hpp"
#include "core/filters/obstacle_split.hpp"
#include "core/filters/rounded_mesh.hpp"

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }

void addObstacleEdges(const RoundedMesh& mesh, NavigationMesh& result) {
  std::vector<std::tuple<std::array<Place, 2>, Index, int>> edges;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      if ((mesh.triangles[t].obstacleEdges >> k & 1) == 0) continue;
      const Place a = placeOf(mesh.vertices[mesh.triangles[t].corners[k]]);
      const Place b = placeOf(mesh.vertices[mesh.triangles[t].corners[next(k)]]);
      edges.push_back({{std::min(a, b), std::max(a, b)}, t, k});
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && std::get<0>(edges[i]) == std::get<0>(edges[i - 1])) continue;
    const auto& [places, t, k] = edges[i];
    result.obstacleEdges.push_back({result.triangles[t][k], result.triangles[t][next(k)]});
  }
}

void addConnections(NavigationMesh& mesh) {
  if (mesh.layers.empty()) return;
  std::vector<std::array<std::uint32_t, 3>> uses;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][next(k)];
      uses.push_back({std::min(a, b), std::max(a, b), mesh.layers[t]});
    }
  std::sort(uses.begin(), uses.end());
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j][0] == uses[i][0] && uses[j][1] == uses[i][1]) ++j;
    if (uses[i][2] != uses[j - 1][2]) mesh.connections.push_back({uses[i][0], uses[i][1]});
    i = j;
  }
}

Vec3 middleOf(const Vec3& a, const Vec3& b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2}; }

RoundedMesh roundSplitMesh(const WalkableState& state, SplitMesh&& split, std::vector<char>& sturdy,
                           RunContext& context) {
  const WalkableMesh& mesh = *state.mesh;
  std::vector<char> exact;
  const std::vector<Vec3> places = roundVertices(*state.kernel, mesh.vertices, exact, context);
  RoundedMesh rounded;
  rounded.triangles = std::move(split.triangles);
  rounded.layers = std::move(split.layers);
  for (std::size_t v = 0; v < split.origins.size(); ++v) {
    if (split.origins[v] >= 0) {
      rounded.vertices.push_back(places[split.origins[v]]);
      sturdy.push_back(exact[split.origins[v]]);
    } else {
      rounded.vertices.push_back(middleOf(places[split.middles[v][0]], places[split.middles[v][1]]));
      sturdy.push_back(0);
    }
  }
  return rounded;
}

// Repairs can bring the two sides of an obstacle together: give each its own vertices once more.
void splitAgain(RoundedMesh& mesh) {
  WalkableMesh joined;
  joined.vertices.resize(mesh.vertices.size());
  joined.triangles = std::move(mesh.triangles);
  joined.layers = std::move(mesh.layers);
  SplitMesh split = splitAtObstacleEdges(joined);
  std::vector<Vec3> vertices;
  for (std::size_t v = 0; v < split.origins.size(); ++v)
    vertices.push_back(split.origins[v] >= 0
                           ? mesh.vertices[split.origins[v]]
                           : middleOf(mesh.vertices[split.middles[v][0]], mesh.vertices[split.middles[v][1]]));
  mesh = {std::move(vertices), std::move(split.triangles), std::move(split.layers)};
}

}  // namespace

std::shared_ptr<const NavigationMesh> makeNavigationMesh(const StatePtr& given, RunContext& context) {
  ExactFallbacks fallbacks;
  const StatePtr state = withMesh(given, context, fallbacks);
  const SourceMesh& source = state->kernel->mesh();
  std::vector<char> sturdy;
  RoundedMesh rounded = roundSplitMesh(*state, splitAtObstacleEdges(*state->mesh), sturdy, context);
  context.checkCancelled();
  markBorders(rounded);
  repairRounding(rounded, sturdy, context);
  if (settleBorders(rounded)) splitAgain(rounded);
  context.checkCancelled();
  markClosedSlivers(rounded, context);
  context.checkCancelled();

  // Triangles by layer, then in the order of the mesh; vertices in the order of their first use.
  std::vector<Index> order(rounded.triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  if (!rounded.layers.empty())
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return rounded.layers[a] < rounded.layers[b]; });
  auto result = std::make_shared<NavigationMesh>();
  std::vector<std::int64_t> renumbered(rounded.vertices.size(), -1);
  RoundedMesh sorted;
  sorted.vertices = std::move(rounded.vertices);
  for (const Index i : order) {
    const MeshTriangle& t = rounded.triangles[i];
    Triangle corners{};
    for (int k = 0; k < 3; ++k) {
      auto& number = renumbered[t.corners[k]];
      if (number < 0) {
        number = static_cast<std::int64_t>(result->vertices.size());
        result->vertices.push_back(sorted.vertices[t.corners[k]]);
      }
      corners[k] = static_cast<std::uint32_t>(number);
    }
    result->triangles.push_back(corners);
    result->sourceTriangles.push_back(source.inputTriangles[t.face]);
    if (!rounded.layers.empty()) result->layers.push_back(rounded.layers[i]);
    sorted.triangles.push_back(t);
  }
  result->layerCount = state->mesh->layerCount;
  addObstacleEdges(sorted, *result);
  addConnections(*result);
  return result;
}

}  // namespace footfall
