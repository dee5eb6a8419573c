// Paths for an agent with a body, for any radius.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "handles.hpp"

using namespace footfall;
using namespace footfall::c;

namespace {

// The numbers in footfall.h are those of the library.
static_assert(static_cast<int>(BodyPathStatus::NoPath) == FOOTFALL_BODY_PATH_NONE &&
              static_cast<int>(BodyPathStatus::StartTooNear) == FOOTFALL_BODY_PATH_START_TOO_NEAR &&
              static_cast<int>(BodyPathStatus::TargetTooNear) == FOOTFALL_BODY_PATH_TARGET_TOO_NEAR &&
              static_cast<int>(BodyPathStatus::TooNarrow) == FOOTFALL_BODY_PATH_TOO_NARROW);

}  // namespace

footfall_status footfall_make_body_path_finder(const footfall_result* result, footfall_context* context,
                                               footfall_body_path_finder** finder) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(finder, "finder");
    *finder =
        new footfall_body_path_finder{result->environment, result->pipeline,
                                      std::make_unique<const BodyPathFinder>(result->run.mesh, contextOf(context))};
  });
}

footfall_status footfall_find_body_path(const footfall_body_path_finder* finder, const double from[3],
                                        const double to[3], double radius, double preferred_width,
                                        footfall_context* context, footfall_body_path** path) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(path, "path");
    const Environment& environment = *finder->environment;
    const Pipeline& pipeline = finder->pipeline;
    auto found = std::make_unique<footfall_body_path>();
    found->path = finder->finder->find(placeFrom(from, "from"), placeFrom(to, "to"), {radius, preferred_width},
                                       placeReach(pipeline), contextOf(context));
    PathResult& way = found->path.path;
    if (found->path.status == BodyPathStatus::NoPath && way.status == PathStatus::NotConnected && way.drops.empty()) {
      const SeparationFinder separations(finder->finder->pointFinder(), finder->environment,
                                         agentHeight(pipeline, environment.metresPerUnit), agentStep(pipeline),
                                         contextOf(context), agentGap(pipeline));
      addSeparation(way, separations, contextOf(context));
    }
    found->way = {way, formatFailure(found->path, environment.up)};
    *path = found.release();
  });
}

footfall_body_path_status footfall_body_path_found(const footfall_body_path* path) {
  return path == nullptr ? FOOTFALL_BODY_PATH_NONE : static_cast<footfall_body_path_status>(path->path.status);
}

const footfall_path* footfall_body_path_way(const footfall_body_path* path) {
  if (path == nullptr) return nullptr;
  const bool hasWay = path->path.reached() || path->path.status == BodyPathStatus::NoPath;
  return hasWay ? &path->way : nullptr;
}

const char* footfall_body_path_failure(const footfall_body_path* path) {
  return path == nullptr ? "" : path->way.failure.c_str();
}

int footfall_body_path_narrowest(const footfall_body_path* path, footfall_passage* passage) {
  if (path == nullptr || passage == nullptr || !path->path.narrowest) return 0;
  const Passage& found = *path->path.narrowest;
  copyTo(found.place, passage->place);
  copyTo(found.left, passage->left);
  copyTo(found.right, passage->right);
  passage->width = found.width;
  return 1;
}

int footfall_body_path_admissible(const footfall_body_path* path, double place[3]) {
  if (path == nullptr || place == nullptr || !path->path.admissible) return 0;
  copyTo(*path->path.admissible, place);
  return 1;
}

double footfall_body_path_lacking(const footfall_body_path* path) { return path == nullptr ? 0 : path->path.lacking; }

double footfall_body_path_start_distance(const footfall_body_path* path) {
  return path == nullptr ? 0 : path->path.startDistance;
}

double footfall_body_path_target_distance(const footfall_body_path* path) {
  return path == nullptr ? 0 : path->path.targetDistance;
}

void footfall_free_body_path(footfall_body_path* path) { delete path; }

void footfall_free_body_path_finder(footfall_body_path_finder* finder) { delete finder; }
