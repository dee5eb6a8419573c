// SlopeFilter: rejects triangles that are steeper than the limit, exactly (model, Slope).
// SPDX-License-Identifier: GPL-3.0-or-later

#include <atomic>

#include "core/base/parallel.hpp"
#include "core/filters/face_filter.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {

FilterOutcome applySlope(const StatePtr& state, double degrees, double tolerance, RunContext& context) {
  const FaceTest isWithin = makeFaceTest(filterDescriptor(FilterType::Slope), {degrees, tolerance}, state->kernel);
  auto result = std::make_shared<WalkableState>(*state);
  std::atomic<std::uint64_t> fallbacks{0};
  parallelRanges(result->walkable.size(), 1024, [&](const auto& range) {
    context.checkCancelled();
    ExactFallbacks count;
    for (std::size_t t = range.begin(); t != range.end(); ++t)
      if (result->walkable[t] != 0) result->walkable[t] = static_cast<char>(isWithin(static_cast<Index>(t), count));
    fallbacks.fetch_add(count.slope, std::memory_order_relaxed);
  });
  if (state->mesh) {
    // Parts keep the plane of the face that they were cut from.
    auto mesh = std::make_shared<WalkableMesh>();
    mesh->vertices = state->mesh->vertices;
    mesh->layerCount = state->mesh->layerCount;
    for (std::size_t i = 0; i < state->mesh->triangles.size(); ++i) {
      const MeshTriangle& t = state->mesh->triangles[i];
      if (result->walkable[t.face] == 0) continue;
      mesh->triangles.push_back(t);
      if (!state->mesh->layers.empty()) mesh->layers.push_back(state->mesh->layers[i]);
    }
    if (!state->mesh->links.empty())
      mesh->links =
          linksBetween(state->mesh->links, mesh->triangles, findEdges(mesh->triangles, mesh->vertices.size()));
    result->mesh = mesh;
  }
  FilterOutcome outcome{result, {}, {}};
  outcome.fallbacks.slope = fallbacks;
  return outcome;
}

}  // namespace footfall::detail
