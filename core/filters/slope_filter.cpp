// SlopeFilter: rejects triangles that are steeper than the limit, exactly (design section 2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/parallel_for.h>

#include <atomic>

#include "core/exact/source_predicates.hpp"
#include "core/filters/filter_registry.hpp"

namespace footfall {

FilterOutcome applySlope(const StatePtr& state, double degrees, RunContext& context) {
  const SourceMesh& source = state->kernel->mesh();
  auto result = std::make_shared<WalkableState>(*state);
  const SlopeLimit limit(degrees);
  std::atomic<std::uint64_t> fallbacks{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, source.triangles.size(), 1024), [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      if (result->walkable[t] == 0) continue;
      const int sign = limit.compare(source.normals[t], state->kernel->sign());
      if (sign != kUnknownSign) {
        result->walkable[t] = static_cast<char>(sign > 0);
        continue;
      }
      const auto& f = source.triangles[t];
      bool beyondDoubles = false;
      result->walkable[t] = static_cast<char>(
          isWithinSlope(source.vertices[f[0]], source.vertices[f[1]], source.vertices[f[2]], degrees, &beyondDoubles));
      if (beyondDoubles) fallbacks.fetch_add(1, std::memory_order_relaxed);
    }
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
    result->mesh = mesh;
  }
  FilterOutcome outcome{result, {}, {}};
  outcome.fallbacks.slope = fallbacks;
  return outcome;
}

}  // namespace footfall
