// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "core/assembly/mesh_assembly.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/base/poll.hpp"
#include "core/base/vector.hpp"
#include "core/filters/filter_traits.hpp"
#include "core/inspect/border_distances.hpp"
#include "core/inspect/place_cover.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/inspect.hpp"

namespace footfall {
namespace detail {

struct InspectedRun {
  std::shared_ptr<const Environment> environment;
  Pipeline pipeline;
  std::shared_ptr<const NavigationMesh> product;
  std::vector<std::size_t> steps;  ///< the enabled ones
  std::vector<StatePtr> states;    ///< one before the first step and one after each
  Components components;
  std::vector<std::int32_t> faceOf;  ///< number in the first state of each triangle of the environment
  mutable std::mutex distancesMutex;
  mutable std::map<std::size_t, std::shared_ptr<const BorderDistances>> distances;  ///< keyed by place in `states`
};

}  // namespace detail

using namespace detail;
namespace {

// A share of the environment's diagonal: typed coordinates are rounded. It chooses the place that is meant, and decides
// nothing about it.
constexpr double kTypedReach = 1e-6;

double slopeOf(const SourceMesh& mesh, Index face) {
  const auto& n = mesh.normals[face];
  return std::atan2(std::hypot(n[0].value, n[1].value), n[2].value) * (180 / std::numbers::pi);
}

/// The exact place of a point of a triangle, moved into it where rounding has put it beside.
GenericPlace placeIn(const std::array<ExactPoint, 3>& corners, const Vec3& point) {
  const mpq_class middleX = (corners[0][0] + corners[1][0] + corners[2][0]) / 3;
  const mpq_class middleY = (corners[0][1] + corners[1][1] + corners[2][1]) / 3;
  const mpq_class x(point.x), y(point.y);
  // Ever larger parts of the way to the middle, so that the place hardly moves where that is enough.
  for (const double part : {0.0, 0x1p-50, 0x1p-40, 0x1p-30, 0x1p-20, 0x1p-10, 0x1p-4}) {
    const mpq_class p(part);
    GenericPlace place(x + p * (middleX - x), y + p * (middleY - y), middleX, middleY);
    if (place.isInside(corners)) return place;
  }
  return {middleX, middleY, middleX, middleY};
}

bool measuresBorders(const FilterTraits& traits) {
  return std::ranges::any_of(traits.removals, [](const Removal& r) { return r.measure == PlaceMeasure::WallDistance; });
}

/// The distances to walls and ledges in one of the states; `step` made it.
BorderDistances::Nearest distancesAt(const InspectedRun& run, std::size_t number, PlaceFollower follower,
                                     const PipelineStep& step, RunContext& context) {
  std::shared_ptr<const BorderDistances> distances;
  {
    const std::lock_guard lock(run.distancesMutex);
    std::shared_ptr<const BorderDistances>& known = run.distances[number];
    if (!known) {
      ExactFallbacks fallbacks;
      known = std::make_shared<const BorderDistances>(*withMesh(run.states[number], context, fallbacks), context);
    }
    distances = known;
  }
  const auto cover = follower.follow(distances->state(), step);
  if (!cover || cover->triangle < 0) return {};
  return distances->at(cover->triangle, follower.place().x().get_d(), follower.place().y().get_d(), context);
}

/// The place is too near a wall or a ledge. If neither, the tolerance removed more, and the cause is the nearer border
/// beside the place; or the way to it bends, as it does to what keeps more away.
PlaceVerdict verdictOfRadius(const BorderDistances::Nearest& nearest, const std::vector<double>& values) {
  const double wall = nearest.wall.value_or(std::numeric_limits<double>::infinity());
  const double ledge = nearest.ledge.value_or(std::numeric_limits<double>::infinity());
  if (wall < values[0]) return PlaceVerdict::TooNearWall;
  if (ledge < values[1]) return PlaceVerdict::TooNearLedge;
  const double more = 1 + values[2];
  if (wall > more * values[0] && ledge > more * values[1] && values[0] != values[1])
    return values[0] > values[1] ? PlaceVerdict::TooNearWall : PlaceVerdict::TooNearLedge;
  return wall * values[1] <= ledge * values[0] ? PlaceVerdict::TooNearWall : PlaceVerdict::TooNearLedge;
}

std::optional<TriangleAbove> aboveIn(const SourceMesh& mesh, const std::vector<ColumnFace>& column,
                                     const GenericNumber& height) {
  const ColumnFace* lowest = lowestAbove(mesh, column, height);
  if (lowest == nullptr) return std::nullopt;
  return TriangleAbove{mesh.inputTriangles[lowest->face], mpq_class(lowest->height.value - height.value).get_d()};
}

double areaOf(const WalkableMesh& mesh, const MeshTriangle& t) {
  const MeshVertex &a = mesh.vertices[t.corners[0]], &b = mesh.vertices[t.corners[1]], &c = mesh.vertices[t.corners[2]];
  return detail::areaOf({a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z});
}

/// The area of the region around a place, as AreaFilter computed it.
double regionAreaAt(const StatePtr& before, PlaceFollower follower, const PipelineStep& step, RunContext& context) {
  ExactFallbacks fallbacks;
  const StatePtr state = withMesh(before, context, fallbacks);
  const auto cover = follower.follow(*state, step);
  if (!cover) return 0;
  const Poll poll(context);
  Index count = 0;
  const std::vector<Index> region = findRegions(*state->mesh, *topologyOf(*state, poll), count);
  context.checkCancelled();
  double area = 0;
  for (std::size_t t = 0; t < region.size(); ++t)
    if (region[t] == region[cover->triangle]) area += areaOf(*state->mesh, state->mesh->triangles[t]);
  return std::ldexp(area, -2 * state->kernel->mesh().grid.scaleExponent());
}

/// The step that removed a place.
struct Rejection {
  const InspectedRun& run;
  std::size_t step;        ///< place in the pipeline
  std::size_t state;       ///< place in InspectedRun::states of the one before it
  const Removal* removal;  ///< null: the filter does not describe what it removes
};

/// Says why the step removed the place, which `before` has followed up to it.
void reject(PlaceExplanation& result, const Rejection& rejection, const PlaceFollower& before, RunContext& context) {
  const auto& [run, number, state, removal] = rejection;
  const PipelineStep& step = run.pipeline.steps[number];
  result.verdict = removal != nullptr ? removal->verdict : PlaceVerdict::Removed;
  result.step = number;
  if (removal == nullptr) return;
  if (removal->limit) result.limit = step.values[*removal->limit];
  const SourceMesh& mesh = run.states.front()->kernel->mesh();
  switch (removal->measure) {
    case PlaceMeasure::Slope:
      if (&before.mesh() != &mesh) result.movedSlope = slopeOf(before.mesh(), before.face());
      break;
    case PlaceMeasure::Headroom:
      result.obstacle = aboveIn(before.mesh(), facesAt(before.mesh(), before.place()), before.height());
      break;
    case PlaceMeasure::RegionArea:
      result.regionArea = regionAreaAt(run.states[state], before, step, context);
      break;
    case PlaceMeasure::WallDistance:  // measured before
    case PlaceMeasure::LedgeDistance:
    case PlaceMeasure::None:
      break;
  }
}

/// The square of the distance between a point and a triangle, in doubles; for choosing among neighbours.
double squaredDistance(const Vec3& p, const std::array<Vec3, 3>& t) {
  const auto toSegment = [&](const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a, ap = p - a;
    const double length = dot(ab, ab);
    const double along = length > 0 ? std::clamp(dot(ap, ab) / length, 0.0, 1.0) : 0;
    const Vec3 rest = ap - along * ab;
    return dot(rest, rest);
  };
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = p - t[0], n = cross(u, v);
  const double nn = dot(n, n);
  if (nn > 0) {
    const double second = dot(cross(w, v), n), third = dot(cross(u, w), n);
    if (second >= 0 && third >= 0 && second + third <= nn) return dot(w, n) * dot(w, n) / nn;
  }
  return std::min({toSegment(t[0], t[1]), toSegment(t[1], t[2]), toSegment(t[2], t[0])});
}

/// Rounding and its repairs moved the product by a hair: the triangle that is nearest to the place.
void findProductPlace(const InspectedRun& run, PlaceExplanation& explanation) {
  const NavigationMesh& mesh = *run.product;
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> nearest;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (explanation.layer && !mesh.layers.empty() && mesh.layers[t] != *explanation.layer) continue;
    const Triangle& triangle = mesh.triangles[t];
    const double distance = squaredDistance(
        explanation.place.point, {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]});
    if (distance >= least) continue;
    least = distance;
    nearest = t;
  }
  if (!nearest) return;
  explanation.component = run.components.ofTriangle[*nearest];
  explanation.componentArea = run.components.list[explanation.component].area;
}

}  // namespace

Inspector::Inspector(std::shared_ptr<const Environment> environment, Pipeline pipeline,
                     std::shared_ptr<const NavigationMesh> product, ResultCache* cache, RunContext* context,
                     int threads) {
  RunContext ownContext;
  if (context == nullptr) context = &ownContext;
  std::optional<ResultCache> ownCache;
  if (cache == nullptr) cache = &ownCache.emplace(pipeline.steps.size() + 1);
  auto run = std::make_unique<InspectedRun>();
  run->states = stepStates(environment, pipeline, *context, *cache, threads);
  run->components = findComponents(*product, context);
  run->environment = std::move(environment);
  run->pipeline = std::move(pipeline);
  run->product = std::move(product);
  for (std::size_t i = 0; i < run->pipeline.steps.size(); ++i)
    if (run->pipeline.steps[i].enabled) run->steps.push_back(i);
  const auto& inputs = run->states.front()->kernel->mesh().inputTriangles;
  run->faceOf.assign(run->environment->triangles.size(), -1);
  for (std::size_t face = 0; face < inputs.size(); ++face) run->faceOf[inputs[face]] = static_cast<std::int32_t>(face);
  inside_ = std::move(run);
}

Inspector::~Inspector() = default;

const Environment& Inspector::environment() const { return *inside_->environment; }
const Pipeline& Inspector::pipeline() const { return inside_->pipeline; }
const NavigationMesh& Inspector::product() const { return *inside_->product; }
const Components& Inspector::components() const { return inside_->components; }

PlaceExplanation Inspector::explain(const PickedPlace& picked, RunContext* givenContext) const {
  RunContext ownContext;
  RunContext& context = givenContext != nullptr ? *givenContext : ownContext;
  const Pipeline& pipeline = inside_->pipeline;
  const std::vector<std::size_t>& steps = inside_->steps;
  const std::vector<StatePtr>& states = inside_->states;
  const std::vector<std::int32_t>& faceOf = inside_->faceOf;
  if (picked.triangle >= faceOf.size())
    throw InputError(FOOTFALL_TEXT("triangle %1 does not exist; the environment has %2"), picked.triangle,
                     faceOf.size());
  const Vec3& point = picked.point;
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
    throw InputError(FOOTFALL_TEXT("the place has a coordinate that is not finite; give three numbers"));
  context.checkCancelled();

  PlaceExplanation result;
  result.place = picked;
  const SourceMesh& mesh = states.front()->kernel->mesh();
  const Index face = faceOf[picked.triangle];
  if (mesh.degenerate[face] != 0) {
    result.verdict = PlaceVerdict::NoArea;
    const auto removes = [&](std::size_t i) {
      return findRemoval(*pipeline.steps[i].filter->traits, PlaceVerdict::NoArea) != nullptr;
    };
    const auto step = std::find_if(steps.begin(), steps.end(), removes);
    if (step != steps.end()) result.step = *step;
    return result;
  }
  result.slope = slopeOf(mesh, face);
  if (mesh.facing[face] == 0) {
    result.verdict = PlaceVerdict::Vertical;
    return result;
  }

  const auto corners = cornersOf(mesh, face);
  PlaceFollower follower(mesh, face, placeIn(corners, point));
  const GenericPlace& place = follower.place();
  const GenericNumber height = follower.height();
  result.place.point = {place.x().get_d(), place.y().get_d(), height.value.get_d()};
  result.above = aboveIn(mesh, facesAt(mesh, place), height);
  double clearance = 0;
  for (const std::size_t i : steps)
    if (pipeline.steps[i].filter->type == FilterType::VerticalClearance)
      clearance = std::max(clearance, pipeline.steps[i].values[0]);
  if (clearance > 0)
    for (const Index wall : wallsAt(mesh, place.x(), place.y(), corners, mpq_class(clearance)))
      result.walls.push_back(mesh.inputTriangles[wall]);
  std::sort(result.walls.begin(), result.walls.end());

  std::optional<PlaceCover> cover = follower.begin(*states.front());
  if (!cover) {
    result.verdict = mesh.facing[face] < 0 ? PlaceVerdict::FacesDown : PlaceVerdict::NeverFloor;
    return result;
  }
  if (cover->face != face) result.floor = mesh.inputTriangles[cover->face];
  // True before the first RadiusFilter, or, without one, at the end.
  bool isMeasured = false;
  const auto measure = [&](std::size_t s, const PlaceFollower& there) {
    isMeasured = true;
    const auto [wall, ledge] = distancesAt(
        *inside_, s, there,
        s == 0 ? PipelineStep{&filterDescriptor(FilterType::Slope), {}} : pipeline.steps[steps[s - 1]], context);
    result.wallDistance = wall;
    result.ledgeDistance = ledge;
    return BorderDistances::Nearest{wall, ledge};
  };
  for (std::size_t s = 0; s < steps.size(); ++s) {
    context.checkCancelled();
    const PipelineStep& step = pipeline.steps[steps[s]];
    const PlaceFollower before = follower;
    const FilterTraits& traits = *step.filter->traits;
    const bool isOfBorders = measuresBorders(traits);
    if (isOfBorders && !isMeasured) measure(s, before);
    cover = follower.follow(*states[s + 1], step);
    if (cover) continue;
    const Removal* removal = traits.removals.empty() ? nullptr : &traits.removals.front();
    if (isOfBorders) removal = findRemoval(traits, verdictOfRadius(measure(s, before), step.values));
    reject(result, {*inside_, steps[s], s, removal}, before, context);
    return result;
  }
  if (!isMeasured) measure(steps.size(), follower);
  const WalkableState& last = *states.back();
  if (cover->triangle >= 0 && !last.mesh->layers.empty()) result.layer = last.mesh->layers[cover->triangle];
  findProductPlace(*inside_, result);
  return result;
}

std::optional<PickedPlace> Inspector::placeBelow(const Vec3& point) const {
  const SourceMesh& mesh = inside_->states.front()->kernel->mesh();
  if (mesh.vertices.empty() || !std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
    return std::nullopt;
  Vec3 low = mesh.vertices.front(), high = low;
  for (const Vec3& v : mesh.vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  const double reach = kTypedReach * std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
  const std::vector<Index> found = highestBelow(mesh, point, std::isfinite(reach) ? reach : 0);
  if (found.empty()) return std::nullopt;
  const auto order = [&](Index a, Index b) {
    if (mesh.facing[a] != mesh.facing[b]) return mesh.facing[a] > mesh.facing[b];
    return mesh.inputTriangles[a] < mesh.inputTriangles[b];
  };
  const Index face = *std::min_element(found.begin(), found.end(), order);
  const mpq_class x(point.x), y(point.y);
  const auto height = GenericPlace(x, y, x, y).heightOf(cornersOf(mesh, face));
  return PickedPlace{mesh.inputTriangles[face], {point.x, point.y, height->value.get_d()}};
}

std::optional<PickedPlace> Inspector::placeNear(const Vec3& point) const {
  std::optional<PickedPlace> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < inside_->environment->triangles.size(); ++t) {
    const Triangle& triangle = inside_->environment->triangles[t];
    const auto& vertices = inside_->environment->vertices;
    const double distance =
        squaredDistance(point, {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]});
    if (!(distance < least)) continue;  // nor NaN
    least = distance;
    nearest = PickedPlace{static_cast<std::uint32_t>(t), point};
  }
  return nearest;
}

}  // namespace footfall
