// Questions about results: components, paths, why a place is walkable or not, comparing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "handles.hpp"

using namespace footfall;
using namespace footfall::c;

namespace {

// The numbers in footfall.h are those of the library.
static_assert(static_cast<int>(PathStatus::NotConnected) == FOOTFALL_PATH_NOT_CONNECTED &&
              static_cast<int>(LinkKind::Touch) == FOOTFALL_LINK_TOUCH &&
              static_cast<int>(PlaceVerdict::TooSteep) == FOOTFALL_TOO_STEEP &&
              static_cast<int>(PlaceVerdict::TooNearLedge) == FOOTFALL_TOO_NEAR_LEDGE &&
              static_cast<int>(PlaceVerdict::Removed) == FOOTFALL_REMOVED);

footfall_explanation explanationOf(const PlaceExplanation& found) {
  footfall_explanation result{};
  const bool isWalkable = found.verdict == PlaceVerdict::Walkable;
  result.verdict = static_cast<footfall_verdict>(found.verdict);
  copyTo(found.place.point, result.point);
  result.triangle = found.place.triangle;
  result.step = found.step ? static_cast<std::uint32_t>(*found.step) : FOOTFALL_NONE;
  result.limit = found.limit;
  result.slope = found.slope;
  result.headroom = found.above ? found.above->height : std::numeric_limits<double>::infinity();
  result.wall = found.wallDistance.value_or(std::numeric_limits<double>::quiet_NaN());
  result.ledge = found.ledgeDistance.value_or(std::numeric_limits<double>::quiet_NaN());
  result.obstacle = found.obstacle ? found.obstacle->triangle : FOOTFALL_NONE;
  result.layer = found.layer.value_or(FOOTFALL_NONE);
  result.component = isWalkable ? found.component : FOOTFALL_NONE;
  return result;
}

}  // namespace

// --- Components
// -------------------------------------------------------------------------------------------------------

footfall_status footfall_find_components(const footfall_result* result, footfall_context* context,
                                         footfall_components** components) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(components, "components");
    *components = new footfall_components{findComponents(result->mesh(), contextOf(context))};
  });
}

size_t footfall_component_count(const footfall_components* components) {
  return components == nullptr ? 0 : components->components.list.size();
}

footfall_status footfall_get_component(const footfall_components* components, size_t index,
                                       footfall_component* component) {
  return guarded(__func__, [&] {
    const std::vector<Component>& list = given(components, "components").components.list;
    given(component, "component");
    if (index >= list.size()) throw InputError(Pattern{"there is no component %1 of %2"}, index, list.size());
    const Component& found = list[index];
    *component = {found.area, found.triangles, found.firstTriangle, {}, {}};
    copyTo(found.lower, component->lower);
    copyTo(found.upper, component->upper);
  });
}

footfall_numbers footfall_component_of_triangles(const footfall_components* components) {
  return components == nullptr ? footfall_numbers{} : spanOf(components->components.ofTriangle);
}

void footfall_free_components(footfall_components* components) { delete components; }

// --- Paths
// ------------------------------------------------------------------------------------------------------------

footfall_status footfall_make_path_finder(const footfall_result* result, footfall_context* context,
                                          footfall_path_finder** finder) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(finder, "finder");
    *finder = new footfall_path_finder{result->environment, result->pipeline,
                                       PathFinder(result->run.mesh, contextOf(context))};
  });
}

footfall_status footfall_follow_path_finder(const footfall_result* result, const footfall_path_finder* before,
                                            footfall_context* context, footfall_path_finder** finder) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(before, "before");
    given(finder, "finder");
    *finder = new footfall_path_finder{result->environment, result->pipeline,
                                       PathFinder(result->run.mesh, before->finder, contextOf(context))};
  });
}

footfall_status footfall_find_path(const footfall_path_finder* finder, const double from[3], const double to[3],
                                   footfall_context* context, footfall_path** path) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(path, "path");
    auto found = std::make_unique<footfall_path>();
    const Environment& environment = *finder->environment;
    found->path = finder->finder.find(placeFrom(from, "from"), placeFrom(to, "to"), placeReach(finder->pipeline),
                                      contextOf(context));
    if (found->path.status == PathStatus::NotConnected) {
      const SeparationFinder separations(finder->finder, finder->environment,
                                         agentHeight(finder->pipeline, environment.metresPerUnit),
                                         agentStep(finder->pipeline), contextOf(context), agentGap(finder->pipeline));
      addSeparation(found->path, separations, contextOf(context));
    }
    found->failure = formatFailure(found->path, environment.up);
    *path = found.release();
  });
}

footfall_path_status footfall_path_found(const footfall_path* path) {
  return path == nullptr ? FOOTFALL_PATH_NOTHING_WALKABLE : static_cast<footfall_path_status>(path->path.status);
}

footfall_points footfall_path_points(const footfall_path* path) {
  return path == nullptr ? footfall_points{} : spanOf(path->path.points);
}

footfall_numbers footfall_path_triangles(const footfall_path* path) {
  return path == nullptr ? footfall_numbers{} : spanOf(path->path.triangles);
}

double footfall_path_length(const footfall_path* path) { return path == nullptr ? 0 : path->path.length; }

double footfall_path_least_plan_length(const footfall_path* path) {
  return path == nullptr ? 0 : path->path.leastPlanLength;
}
double footfall_path_plan_length(const footfall_path* path) { return path == nullptr ? 0 : path->path.planLength; }

size_t footfall_path_drop_count(const footfall_path* path) { return path == nullptr ? 0 : path->path.drops.size(); }

const char* footfall_path_failure(const footfall_path* path) { return path == nullptr ? "" : path->failure.c_str(); }

int footfall_path_barrier(const footfall_path* path, footfall_barrier* barrier) {
  if (path == nullptr || barrier == nullptr || !path->path.separation) return 0;
  const BorderLink& link = path->path.separation->barrier();
  *barrier = {static_cast<footfall_link_kind>(link.kind), {}, {}, link.gap, link.rise, link.obstacle, link.headroom};
  copyTo(link.from, barrier->from);
  copyTo(link.to, barrier->to);
  return 1;
}

void footfall_free_path(footfall_path* path) { delete path; }

void footfall_free_path_finder(footfall_path_finder* finder) { delete finder; }

// --- Why a place is walkable or not
// -----------------------------------------------------------------------------------

footfall_status footfall_make_inspector(const footfall_result* result, footfall_cache* cache, footfall_context* context,
                                        footfall_inspector** inspector) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(inspector, "inspector");
    *inspector = new footfall_inspector{
        Inspector(result->environment, result->pipeline, result->run.mesh, cacheOf(cache), contextOf(context))};
  });
}

footfall_status footfall_explain(const footfall_inspector* inspector, const double point[3], footfall_context* context,
                                 footfall_explanation* explanation, char** text) {
  return guarded(__func__, [&] {
    given(inspector, "inspector");
    given(explanation, "explanation");
    const Vec3 asked = placeFrom(point, "point");
    const std::optional<PickedPlace> place = inspector->inspector.placeBelow(asked);
    if (!place) throw InputError(Pattern{"no triangle is at or under the place; give a point above a floor"});
    const PlaceExplanation found = inspector->inspector.explain(*place, contextOf(context));
    if (text != nullptr) *text = copyOf(formatExplanation(inspector->inspector, found));
    *explanation = explanationOf(found);
  });
}

void footfall_free_inspector(footfall_inspector* inspector) { delete inspector; }

// --- Comparing
// --------------------------------------------------------------------------------------------------------

footfall_status footfall_compare(const footfall_result* first, const footfall_result* second, footfall_context* context,
                                 footfall_comparison* comparison) {
  return guarded(__func__, [&] {
    given(first, "first");
    given(second, "second");
    given(comparison, "comparison");
    const MeshComparison found = compareMeshes(first->mesh(), second->mesh(), {}, contextOf(context));
    const auto& areas = found.sets.areas;
    const double none = std::numeric_limits<double>::quiet_NaN();
    *comparison = {found.equal() ? 1 : 0, areas[0].surface, areas[1].surface, areas[2].surface, none, none};
    if (!found.distances) return;
    const auto& [there, back] = *found.distances;
    comparison->distance_least = std::max(there.lower, back.lower);
    comparison->distance_most = std::max(there.upper, back.upper);
  });
}
