// SlopeFilter: rejects triangles that are steeper than the limit, exactly (model, Slope).
// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <string>

#include "core/base/parallel.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/face_filter.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {
namespace {

constexpr double kNear =
    0.05;  // degrees that roundings can make of a slope; core/inspect/parameter_check.cpp has it, too

double areaOf(const SourceMesh& mesh, std::size_t face) {
  const auto& f = mesh.triangles[face];
  const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  return std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

/// The floors that the filter has removed and that lie just beyond its limit, in degrees; empty where there are none.
Text nearlyWithin(const WalkableState& before, const WalkableState& after, double limit) {
  const FaceTest isNear = makeFaceTest(filterDescriptor(FilterType::Slope), {limit, kNear}, before.kernel);
  ExactFallbacks ignored;
  double area = 0;
  for (std::size_t t = 0; t < after.walkable.size(); ++t)
    if (before.walkable[t] != 0 && after.walkable[t] == 0 && isNear(static_cast<Index>(t), ignored))
      area += areaOf(before.kernel->mesh(), t);
  if (area == 0) return {};
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), area, std::chars_format::general, 4);
  return {FOOTFALL_TEXT("an area of %1 is steeper than the limit by less than 0.05 degrees"),
          std::string(digits.data(), end.ptr)};
}

}  // namespace

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
  FilterOutcome outcome{result, nearlyWithin(*state, *result, slopeLimit(degrees, tolerance)), {}};
  outcome.fallbacks.slope = fallbacks;
  return outcome;
}

}  // namespace footfall::detail
