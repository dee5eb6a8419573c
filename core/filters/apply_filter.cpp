// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/apply_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/base/vector.hpp"
#include "core/exact/source_edit.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/edit.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

StatePtr makeInitialState(std::shared_ptr<const Environment> environment, RunContext& context, const Recall& recall,
                          const Grid& grid) {
  context.checkCancelled();
  const Poll poll(context);
  std::shared_ptr<const SourceMesh> mesh;
  if (recall.before && environment->edit && recall.before->environment == environment->edit->base.lock())
    mesh = editSourceMesh(recall.before->kernel->sharedMesh(),
                          {{environment->vertices, environment->triangles},
                           environment->edit->keptVertices,
                           environment->edit->keptTriangles,
                           environment->bothSides},
                          poll);
  if (!mesh) {
    SoupView soup(environment->vertices, environment->triangles);
    soup.grid = grid;
    mesh = std::make_shared<SourceMesh>(makeSourceMesh(soup, environment->bothSides, nullptr, poll));
  }
  context.checkCancelled();
  auto state = std::make_shared<WalkableState>();
  state->environment = std::move(environment);
  state->walkable.resize(mesh->triangles.size());
  state->removed.assign(mesh->triangles.size(), 0);
  const std::vector<std::uint8_t>& obstacleOnly = state->environment->obstacleOnly;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t)
    state->walkable[t] =
        static_cast<char>(mesh->facing[t] > 0 && (obstacleOnly.empty() || obstacleOnly[mesh->inputTriangles[t]] == 0));
  state->kernel = std::make_shared<PlanKernel>(std::move(mesh), std::vector<double>{});
  return state;
}

// The switch has no default, so that a filter that is left out does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
FilterOutcome applyFilter(const FilterDescriptor& filter, const std::vector<double>& values, const StatePtr& state,
                          RunContext& context, const Recall& recall) {
  context.checkCancelled();
  switch (filter.type) {
    case FilterType::Duplication:
      return applyDuplication(state, values[0], context);
    case FilterType::Degeneracy:
      return applyDegeneracy(state, context);
    case FilterType::Slope:
      return applySlope(state, values[0], values[1], context);
    case FilterType::VerticalClearance:
      return applyVerticalClearance(state, values[0], recall, context);
    case FilterType::Step:
      return applyStep(state, values[0], values[1], recall, context);
    case FilterType::Radius:
      return applyRadius(state, values[0], values[1], values[2], recall, context);
    case FilterType::Drop:
      return applyDrop(state, values[0], values[1], context);
    case FilterType::Reachable:
      return applyReachable(state, values, context);
    case FilterType::Area:
      return applyArea(state, values[0], recall, context);
    case FilterType::Simplification:
      return applySimplification(state, values[0] != 0, values[1], recall, context);
    case FilterType::LayerSubdivision:
      return applyLayerSubdivision(state, recall, context);
    case FilterType::Rounding:
      return applyRounding(state, values[0] != 0, context);
    case FilterType::GridStrategy:
    case FilterType::RecursiveStrategy:
    case FilterType::SortedRecursiveStrategy:
    case FilterType::HeightAwareStrategy:
    case FilterType::AutoStrategy:
    case FilterType::Collapse:
      break;
  }
  throw std::logic_error(std::string(filter.name) + " is no filter that runs on its own");
}
#pragma GCC diagnostic pop

namespace {

// Sums of this many terms are added up one after another, so that the total does not depend on the threads.
constexpr std::size_t kTermsPerBlock = 4096;

template <class Term>
double sumOf(std::size_t count, Term term) {
  std::vector<double> sums((count + kTermsPerBlock - 1) / kTermsPerBlock, 0);
  parallelFor(sums.size(), [&](std::size_t block) {
    for (std::size_t i = block * kTermsPerBlock; i < std::min((block + 1) * kTermsPerBlock, count); ++i)
      sums[block] += term(i);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

// Half the length of a normal; scaled coordinates are below 2^38, so the squares stay far from the largest double.
double halfLength(double x, double y, double z) { return 0.5 * std::sqrt(x * x + y * y + z * z); }

double areaOf(const WalkableMesh& mesh, const MeshTriangle& t) {
  const MeshVertex &a = mesh.vertices[t.corners[0]], &b = mesh.vertices[t.corners[1]], &c = mesh.vertices[t.corners[2]];
  const Vec3 n = normalOf({a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z});
  return halfLength(n.x, n.y, n.z);
}

}  // namespace

StateSummary summarize(const WalkableState& state) {
  StateSummary summary;
  const SourceMesh& source = state.kernel->mesh();
  const bool hasMesh = state.mesh != nullptr;
  // The loop has no branches, because neighbours differ at random.
  std::uint64_t faces = 0, floors = 0;
  const auto count = [&](const auto& isCovered) {
    for (std::size_t t = 0; t < source.triangles.size(); ++t) {
      const unsigned isThere = static_cast<unsigned>(state.removed[t] == 0);
      faces += isThere;
      floors += isThere & static_cast<unsigned>(state.walkable[t] != 0) & static_cast<unsigned>(!isCovered(t));
    }
  };
  if (hasMesh && state.cuts)
    count([&cuts = *state.cuts](std::size_t t) { return cuts.isRemoved(t); });
  else
    count([](std::size_t) { return false; });
  summary.rejected = faces - floors;
  const int unscale = -2 * source.grid.scaleExponent();
  if (!hasMesh) {
    summary.triangles = floors;
    summary.area = std::ldexp(sumOf(source.triangles.size(),
                                    [&](std::size_t t) {
                                      const auto& n = source.normals[t];
                                      return state.removed[t] == 0 && state.walkable[t] != 0
                                                 ? halfLength(n[0].value, n[1].value, n[2].value)
                                                 : 0.0;
                                    }),
                              unscale);
    return summary;
  }
  const WalkableMesh& mesh = *state.mesh;
  summary.triangles = mesh.triangles.size();
  unsigned marks = 0;
  for (const MeshTriangle& t : mesh.triangles)
    marks += (t.obstacleEdges & 1U) + (t.obstacleEdges >> 1U & 1U) + (t.obstacleEdges >> 2U & 1U);
  summary.area =
      std::ldexp(sumOf(mesh.triangles.size(), [&](std::size_t t) { return areaOf(mesh, mesh.triangles[t]); }), unscale);
  summary.layers = mesh.layerCount;
  summary.connections = mesh.layers.empty() ? 0 : countConnections(mesh, *topologyOf(state));
  summary.obstacleEdges = marks / 2;
  summary.links = mesh.links.size();
  summary.drops = mesh.drops.size();
  return summary;
}

std::shared_ptr<const NavigationMesh> makePreviewMesh(const WalkableState& state) {
  auto preview = std::make_shared<NavigationMesh>();
  const SourceMesh& source = state.kernel->mesh();
  if (!state.mesh) {
    preview->vertices = source.vertices;
    for (std::size_t t = 0; t < source.triangles.size(); ++t) {
      if (state.walkable[t] == 0) continue;
      const auto& f = source.triangles[t];
      preview->triangles.push_back(
          {static_cast<std::uint32_t>(f[0]), static_cast<std::uint32_t>(f[1]), static_cast<std::uint32_t>(f[2])});
      preview->sourceTriangles.push_back(source.inputTriangles[t]);
    }
    return preview;
  }
  const int scale = -source.grid.scaleExponent();
  for (const MeshVertex& v : state.mesh->vertices)
    preview->vertices.push_back({std::ldexp(v.x, scale), std::ldexp(v.y, scale), std::ldexp(v.z, scale)});
  for (const MeshTriangle& t : state.mesh->triangles) {
    preview->triangles.push_back({static_cast<std::uint32_t>(t.corners[0]), static_cast<std::uint32_t>(t.corners[1]),
                                  static_cast<std::uint32_t>(t.corners[2])});
    preview->sourceTriangles.push_back(source.inputTriangles[t.face]);
  }
  preview->layers = state.mesh->layers;
  preview->layerCount = state.mesh->layerCount;
  return preview;
}

}  // namespace footfall::detail
