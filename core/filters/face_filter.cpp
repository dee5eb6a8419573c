// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/face_filter.hpp"

#include <algorithm>
#include <mutex>

#include "core/base/parallel.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

// The switch has no default, so that a type that is left out does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
FaceTest makeFaceTest(const FilterDescriptor& filter, const std::vector<double>& values,
                      const std::shared_ptr<const PlanKernel>& kernel) {
  switch (filter.type) {
    case FilterType::Degeneracy:
      return [kernel](Index face, ExactFallbacks&) { return kernel->mesh().degenerate[face] == 0; };
    case FilterType::Slope:
      return makeSlopeTest(values[0], values[1], kernel);
    case FilterType::Duplication:
    case FilterType::VerticalClearance:
    case FilterType::Step:
    case FilterType::Radius:
    case FilterType::Drop:
    case FilterType::Reachable:
    case FilterType::Area:
    case FilterType::Simplification:
    case FilterType::LayerSubdivision:
    case FilterType::Rounding:
    case FilterType::GridStrategy:
    case FilterType::RecursiveStrategy:
    case FilterType::SortedRecursiveStrategy:
    case FilterType::HeightAwareStrategy:
    case FilterType::AutoStrategy:
    case FilterType::Collapse:
      break;
  }
  return {};
}
#pragma GCC diagnostic pop

FilterOutcome keepFaces(const StatePtr& state, const FaceTest& test, RunContext& context) {
  auto result = std::make_shared<WalkableState>(*state);
  FilterOutcome outcome;
  std::mutex mutex;
  parallelRanges(result->walkable.size(), 1024, [&](const auto& range) {
    context.checkCancelled();
    ExactFallbacks count;
    for (std::size_t t = range.begin(); t != range.end(); ++t)
      if (result->walkable[t] != 0) result->walkable[t] = static_cast<char>(test(static_cast<Index>(t), count));
    if (count.total() == 0) return;
    const std::lock_guard lock(mutex);
    outcome.fallbacks += count;
  });
  outcome.state = result;
  if (!state->mesh) return outcome;
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
    mesh->links = linksBetween(state->mesh->links, mesh->triangles, findEdges(mesh->triangles, mesh->vertices.size()));
  result->mesh = mesh;
  return outcome;
}

FloorFlags::FloorFlags(const std::vector<char>& walkable, const std::vector<FaceTest>& tests)
    : tests_(tests), flags_(walkable) {
  if (tests.empty()) return;
  std::replace_if(
      flags_.begin(), flags_.end(), [](char flag) { return flag != 0; }, kUnknown);
}

bool FloorFlags::passesAll(Index face) {
  return std::all_of(tests_.begin(), tests_.end(), [&](const FaceTest& test) { return test(face, fallbacks); });
}

}  // namespace footfall::detail
