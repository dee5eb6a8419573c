// RadiusFilter: removes what is nearer to the border of the walkable area than an agent's radius (design section 7).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "core/assembly/mesh_assembly.hpp"
#include "core/exact/plan_places.hpp"
#include "core/filters/face_cutter.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/radius/border_pieces.hpp"
#include "core/filters/radius/margin_choice.hpp"
#include "core/filters/radius/margins.hpp"
#include "core/filters/radius/thin_triangles.hpp"
#include "core/filters/rounding/generation.hpp"
#include "core/filters/steps/kept_links.hpp"
#include "core/mesh/gap_bridges.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kFacesPerTask = 8;
constexpr std::size_t kMarginsPerPoll = 64;

/// The floors as RadiusFilter measures on them: with a bridge over each gap, which has no face.
std::shared_ptr<const WalkableMesh> addBridges(const WalkableMesh& floors, const NavigationMesh& product) {
  const NavigationMesh bridged = withBridges(product);
  auto mesh = std::make_shared<WalkableMesh>(floors);
  for (std::size_t t = product.triangles.size(); t < bridged.triangles.size(); ++t) {
    MeshTriangle bridge;
    for (int k = 0; k < 3; ++k) bridge.corners[k] = static_cast<Index>(bridged.triangles[t][k]);
    mesh->triangles.push_back(bridge);
  }
  for (std::size_t i = product.links.size(); i < bridged.links.size(); ++i)
    mesh->links.push_back(linkOf(bridged.links[i]));
  std::erase_if(mesh->links, [](const MeshLink& link) { return link.isGap; });
  return mesh;
}

/// The margins in a kernel that has their corners as places of the plan.
struct KernelWithMargins {
  std::shared_ptr<const PlanKernel> kernel;
  std::vector<Index> planIds;      ///< of the corners of all margins
  std::vector<std::size_t> first;  ///< of each margin, and one more
};

KernelWithMargins addMargins(const PlanKernel& kernel, const std::vector<Margin>& margins, const Poll& poll) {
  std::vector<Vec3> places;
  KernelWithMargins result{nullptr, {}, {0}};
  const double anywhere = kernel.mesh().scaled.front().z;
  for (const Margin& margin : margins) {
    for (const auto& [x, y] : margin.corners) places.push_back({x, y, anywhere});
    result.first.push_back(places.size());
  }
  auto mesh = std::make_shared<SourceMesh>(kernel.mesh());
  poll();
  result.planIds = addPlanPlaces(*mesh, places, poll);
  result.kernel = std::make_shared<PlanKernel>(std::move(mesh), kernel.heights());
  return result;
}

/// For each face the numbers of the margins that reach it, ascending.
struct MarginsOfFaces {
  std::vector<Index> faces;  ///< that have any, ascending
  std::vector<std::vector<Index>> margins;
};

MarginsOfFaces groupByFaces(const std::vector<Margin>& margins, std::size_t faceCount, const Poll& poll) {
  std::vector<std::vector<Index>> ofFaces(faceCount);
  for (std::size_t i = 0; i < margins.size(); ++i) {
    if (i % kMarginsPerPoll == 0) poll();
    for (const Index face : margins[i].faces)
      if (face >= 0) ofFaces[face].push_back(static_cast<Index>(i));
  }
  MarginsOfFaces result;
  for (std::size_t face = 0; face < faceCount; ++face) {
    if (ofFaces[face].empty()) continue;
    result.faces.push_back(static_cast<Index>(face));
    result.margins.push_back(std::move(ofFaces[face]));
  }
  return result;
}

}  // namespace

FilterOutcome applyRadius(const StatePtr& given, double radius, double ledges, double tolerance, RunContext& context) {
  FilterOutcome outcome;
  outcome.state = given;
  if (radius == 0 && ledges == 0) return outcome;
  // The same area in fewer triangles: each that a margin touches is cut and meshed anew.
  const FilterOutcome simplified = applySimplification(given, false, 0, {}, context);
  outcome.fallbacks += simplified.fallbacks;
  const StatePtr& before = simplified.state;
  const auto product = std::make_shared<NavigationMesh>(*makeNavigationMesh(before, context));
  if (product->triangles.empty()) return outcome;
  divideThinTriangles(*product, std::max(radius, ledges), context);
  std::vector<Index> faces;
  auto state = std::make_shared<WalkableState>(
      *startGeneration(*before, makeGenerationSoup(*before, *product, context, outcome.fallbacks), context, &faces));
  const auto floors = floorsOf(*product, state->kernel->mesh(), faces, state->kernel->sign().slack);
  state->mesh = floors;
  state->mesh = addBridges(*floors, *product);
  if (radius != ledges) state->kernel = kernelForKinds(*state);
  const int scale = state->kernel->mesh().grid.scaleExponent();
  const std::vector<Margin> margins = findMargins(
      *state, {std::ldexp(radius, scale), std::ldexp(ledges, scale), tolerance}, context, outcome.fallbacks);

  const KernelWithMargins known = addMargins(*state->kernel, margins, context);
  state->kernel = known.kernel;
  const MarginsOfFaces touched = groupByFaces(margins, state->walkable.size(), context);
  std::vector<FaceCuts> found(touched.faces.size());
  tbb::enumerable_thread_specific<std::unique_ptr<FaceCutter>> cutters;
  tbb::enumerable_thread_specific<MarginChoice> choices([&] { return MarginChoice(margins); });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, found.size(), kFacesPerTask), [&](const auto& range) {
    auto& cutter = cutters.local();
    if (!cutter) cutter = std::make_unique<FaceCutter>(*state->kernel, context);
    std::vector<std::span<const Index>> polygons;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      context.checkCancelled();
      polygons.clear();
      const auto& corners = state->kernel->mesh().triangles[touched.faces[i]];
      const auto placeOf = [&](int k) {
        const Vec3& p = state->kernel->mesh().scaled[corners[k]];
        return PlanVector{p.x, p.y};
      };
      for (const Index margin : choices.local().neededOn({placeOf(0), placeOf(1), placeOf(2)}, touched.margins[i]))
        polygons.emplace_back(known.planIds.data() + known.first[margin],
                              known.first[margin + 1] - known.first[margin]);
      found[i] = cutter->cut(touched.faces[i], polygons);
    }
  });
  for (const auto& cutter : cutters) outcome.fallbacks += cutter->cutFallbacks();
  auto cuts = std::make_shared<CutTable>(state->walkable.size());
  for (std::size_t i = 0; i < found.size(); ++i) cuts->set(touched.faces[i], std::move(found[i]));
  state->cuts = std::move(cuts);
  state->mesh = assembleMesh(*state, context, outcome.fallbacks);
  outcome.state = withLinks(state, *floors, false, context, outcome.fallbacks);
  if (state->mesh->triangles.empty())
    outcome.note = FOOTFALL_TEXT("nothing is left: no place is so far from all borders");
  return outcome;
}

}  // namespace footfall::detail
