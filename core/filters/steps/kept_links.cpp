// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/kept_links.hpp"

#include <optional>

#include "core/filters/height_levels.hpp"
#include "core/filters/steps/step_linker.hpp"

namespace footfall::detail {

MeshLink linkOf(const StepLink& link) {
  const auto edge = [](const std::array<std::uint32_t, 2>& e) {
    return std::array{static_cast<Index>(e[0]), static_cast<Index>(e[1])};
  };
  return {edge(link.from), edge(link.to), link.kind == StepKind::Gap};
}

std::shared_ptr<WalkableMesh> floorsOf(const NavigationMesh& product, const SourceMesh& source,
                                       const std::vector<Index>& faces, double error) {
  auto mesh = std::make_shared<WalkableMesh>();
  mesh->vertices.resize(product.vertices.size());
  mesh->triangles.resize(product.triangles.size());
  for (std::size_t v = 0; v < product.vertices.size(); ++v) {
    const Index number = source.welded[v];
    const Vec3& place = source.scaled[number];
    mesh->vertices[v] = {PlanPoint::source(source.planIds[number]), -1, number, place.x, place.y, place.z, error};
  }
  for (std::size_t t = 0; t < product.triangles.size(); ++t) {
    mesh->triangles[t].face = faces[t];
    for (int k = 0; k < 3; ++k) {
      mesh->triangles[t].corners[k] = static_cast<Index>(product.triangles[t][k]);
      mesh->vertices[product.triangles[t][k]].face = faces[t];
    }
  }
  for (const StepLink& link : product.links) mesh->links.push_back(linkOf(link));
  return mesh;
}

StatePtr withLinks(const StatePtr& state, const WalkableMesh& earlier, bool isAsked, RunContext& context,
                   ExactFallbacks& fallbacks) {
  if (earlier.links.empty()) return state;
  auto result = std::make_shared<WalkableState>(*state);
  std::optional<StepLinker::Limits> limits;
  if (isAsked) {
    limits = {state->step, state->clearance};
    result->kernel = kernelWithHeight(kernelWithHeight(state->kernel, limits->height), limits->step);
  }
  const WalkableState linkable = *result;
  StepLinker linker(linkable, context);
  result->mesh = linker.relink(earlier, limits);
  result->kernel = linker.kernel();
  result->topology = nullptr;
  fallbacks += linker.fallbacks();
  return result;
}

}  // namespace footfall::detail
