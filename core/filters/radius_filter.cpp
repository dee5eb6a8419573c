// RadiusFilter: removes what is nearer to the border of the walkable area than an agent's radius (model, Margins).
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/background_release.hpp"
#include "core/base/parallel.hpp"
#include "core/exact/plan_places.hpp"
#include "core/filters/face_cutter.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/radius/border_pieces.hpp"
#include "core/filters/radius/margin_choice.hpp"
#include "core/filters/radius/margins.hpp"
#include "core/filters/radius/radius_memory.hpp"
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
  mesh->withoutPlaces = kernel.sharedMesh();
  poll();
  result.planIds = addPlanPlaces(*mesh, places, poll);
  result.kernel = std::make_shared<PlanKernel>(std::move(mesh), kernel.heights());
  return result;
}

/// The numbers of the margins that reach each face, ascending.
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

/// Cuts that leave nothing.
std::shared_ptr<const FaceCuts> wholeCuts() {
  const auto cuts = std::make_shared<FaceCuts>();
  cuts->removed = true;
  return cuts;
}

/// The objects that the filter makes besides its result. They are freed together, and in the background where the run
/// ends with an exception: that takes longer than cancelling a run may take.
struct RadiusWork {
  using Polygons = std::vector<std::span<const Index>>;

  StatePtr simplified;
  std::shared_ptr<const RoundedPlaces> places;  ///< of the simplified area
  std::shared_ptr<const NavigationMesh> product;
  CoveredRecall covered;
  GenerationSoup soup;
  std::vector<Index> faces;
  std::shared_ptr<WalkableState> state;
  std::shared_ptr<const WalkableMesh> floors;
  std::vector<Margin> margins;
  KernelWithMargins known;
  MarginsOfFaces touched;
  std::vector<Polygons> polygons;  ///< that are cut out of each face of `touched`
  std::vector<CutFaces::Found> found;
  std::shared_ptr<RadiusMemory> memory;
};

/// Gives the state its cuts and its mesh.
void cutOut(RadiusWork& work, const CutFaces* before, RunContext& context, ExactFallbacks& fallbacks) {
  WalkableState& state = *work.state;
  const PlanKernel& kernel = *state.kernel;
  const SourceMesh& source = kernel.mesh();
  const MarginsOfFaces& touched = work.touched = groupByFaces(work.margins, state.walkable.size(), context);
  std::vector<RadiusWork::Polygons>& polygons = work.polygons;
  std::vector<CutFaces::Found>& found = work.found;
  polygons.resize(touched.faces.size());
  found.resize(touched.faces.size());
  const std::shared_ptr<const FaceCuts> coveredWhole = wholeCuts();
  PerThread<std::unique_ptr<FaceCutter>> cutters;
  PerThread<CutCopies> copies;
  PerThread<MarginChoice> choices([&] { return MarginChoice(work.margins); });
  parallelRanges(found.size(), kFacesPerTask, [&](const auto& range) {
    auto& cutter = cutters.local();
    if (!cutter) cutter = std::make_unique<FaceCutter>(kernel, context);
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      context.checkCancelled();
      const Index face = touched.faces[i];
      const auto placeOf = [&](int k) {
        const Vec3& p = source.scaled[source.triangles[face][k]];
        return PlanVector{p.x, p.y};
      };
      const MarginChoice::Result chosen =
          choices.local().chooseOn({placeOf(0), placeOf(1), placeOf(2)}, touched.margins[i]);
      if (chosen.isCovered) {
        found[i].cuts = coveredWhole;
        continue;
      }
      for (const Index margin : chosen.needed)
        polygons[i].emplace_back(work.known.planIds.data() + work.known.first[margin],
                                 work.known.first[margin + 1] - work.known.first[margin]);
      if (before != nullptr) {
        if (auto again = before->find(kernel, face, polygons[i], copies.local())) {
          found[i] = std::move(*again);
          continue;
        }
      }
      found[i].cuts = std::make_shared<const FaceCuts>(cutter->cut(face, polygons[i]));
    }
  });
  for (const auto& cutter : cutters) fallbacks += cutter->cutFallbacks();
  auto cuts = std::make_shared<CutTable>(state.walkable.size());
  const auto meshes = std::make_shared<FaceMeshes>(state.walkable.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i].cuts->empty()) cuts->set(touched.faces[i], found[i].cuts);
    (*meshes)[touched.faces[i]] = found[i].mesh;
  }
  state.cuts = std::move(cuts);
  meshFaces(state, nullptr, {}, *meshes, context, fallbacks);
  if (work.memory) {
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i % kMarginsPerPoll == 0) context.checkCancelled();
      if (found[i].cuts != coveredWhole)
        work.memory->cutFaces.add(kernel, touched.faces[i], polygons[i], found[i].cuts, (*meshes)[touched.faces[i]]);
    }
  }
  state.mesh = joinFaces(state, nullptr, {}, meshes, nullptr, context, fallbacks);
  work.touched = {};
  polygons = {};
  found = {};
}

}  // namespace

FilterOutcome applyRadius(const StatePtr& given, double radius, double ledges, double tolerance, const Recall& recall,
                          RunContext& context) {
  FilterOutcome outcome;
  outcome.state = given;
  if (radius == 0 && ledges == 0) return outcome;
  const RadiusMemory* const before = recall.before ? recall.before->radiusMemory.get() : nullptr;
  ReleaseOnException large(given->walkable.size() >= kLargeRelease);
  const auto work = std::make_shared<RadiusWork>();
  large.hold(work);
  // The same area in fewer triangles: each that a margin touches is cut and meshed anew.
  FilterOutcome simplified =
      applySimplification(given, false, 0, {before != nullptr ? before->simplified : nullptr, recall.keep}, context);
  outcome.fallbacks += simplified.fallbacks;
  work->simplified = std::move(simplified.state);
  const KnownPlaces known = before != nullptr ? KnownPlaces{before->simplified, before->places} : KnownPlaces();
  const auto product =
      std::make_shared<NavigationMesh>(*makeNavigationMesh(work->simplified, known, work->places, context));
  work->product = product;
  if (product->triangles.empty()) return outcome;
  divideThinTriangles(*product, std::max(radius, ledges), context);
  const auto earlier =
      EarlierResult::relate(before != nullptr ? before->simplified : nullptr, *work->simplified->kernel);
  if (earlier && !before->covered.empty()) work->covered = {&*earlier, &before->covered, {}};
  // The kinds of borders depend on the obstacles at them.
  const bool hasObstacles = recall.needsObstacles || radius != ledges;
  work->soup = hasObstacles
                   ? makeGenerationSoup(*work->simplified, *product, context, outcome.fallbacks,
                                        recall.keep || work->covered.earlier != nullptr ? &work->covered : nullptr)
                   : makeSoupOfFloors(*work->simplified, *product);
  work->state = std::make_shared<WalkableState>(*startGeneration(*work->simplified, work->soup, context, &work->faces,
                                                                 before != nullptr ? before->generation : nullptr));
  WalkableState& state = *work->state;
  work->floors = floorsOf(*product, state.kernel->mesh(), work->faces, state.kernel->sign().slack);
  state.mesh = work->floors;
  state.mesh = addBridges(*work->floors, *product);
  if (radius != ledges) state.kernel = kernelForKinds(state);
  const int scale = state.kernel->mesh().grid.scaleExponent();
  work->margins =
      findMargins(state, {std::ldexp(radius, scale), std::ldexp(ledges, scale), tolerance}, context, outcome.fallbacks);

  work->known = addMargins(*state.kernel, work->margins, context);
  state.kernel = work->known.kernel;
  if (recall.keep) {
    work->memory = std::make_shared<RadiusMemory>(*state.kernel);
    work->memory->simplified = work->simplified;
    work->memory->places = std::move(work->places);
    work->memory->generation = work->state->kernel->mesh().withoutPlaces;
    work->memory->covered = std::move(work->covered.found);
  }
  cutOut(*work, before != nullptr ? &before->cutFaces : nullptr, context, outcome.fallbacks);
  state.radiusMemory = work->memory;
  outcome.state = withLinks(work->state, *work->floors, false, context, outcome.fallbacks);
  if (state.mesh->triangles.empty())
    outcome.note = FOOTFALL_TEXT("nothing is left: no place is far enough from all borders");
  return outcome;
}

}  // namespace footfall::detail
