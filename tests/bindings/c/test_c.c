/* The C interface as a C99 program uses it: test_c SAMPLE.obj SCRATCH_FOLDER EXPORT.obj, where the last is what the
 * command line wrote for the sample. SPDX-License-Identifier: GPL-3.0-or-later */
#include <footfall.h>
#include <limits.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition) check((condition) != 0, #condition, __LINE__)
#define CHECK_OK(call) CHECK_STATUS(call, FOOTFALL_OK)
#define CHECK_STATUS(call, expected) checkStatus((call), (expected), #call, __LINE__)
/* The call fails with that status, and its message says so. */
#define CHECK_FAILS(call, expected, words) \
  do {                                     \
    CHECK_STATUS(call, expected);          \
    checkMessage(words, __LINE__);         \
  } while (0)

static void check(int holds, const char* what, int line) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "line %d: %s\n", line, what);
}

static void checkStatus(footfall_status got, footfall_status expected, const char* what, int line) {
  if (got == expected) return;
  ++failures;
  fprintf(stderr, "line %d: %s gave %d instead of %d: %s\n", line, what, (int)got, (int)expected, footfall_message());
}

static void checkMessage(const char* words, int line) {
  if (strstr(footfall_message(), words) != NULL) return;
  ++failures;
  fprintf(stderr, "line %d: the message \"%s\" lacks \"%s\"\n", line, footfall_message(), words);
}

/* --- Levels --------------------------------------------------------------------------------------------------------
 */

/* A floor of 4 x 4; one beside it that lies 0.5 higher; a ceiling 1 above a quarter of the first. */
static const double kVertices[] = {0, 0, 0,   4, 0, 0,   4, 4, 0, 0, 4, 0, 4, 0, 0.5, 8, 0, 0.5,
                                   8, 4, 0.5, 4, 4, 0.5, 0, 0, 1, 2, 0, 1, 2, 2, 1,   0, 2, 1};
static const uint32_t kTriangles[] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 10, 9, 8, 11, 10};
static const footfall_points kPoints = {kVertices, 12};
static const footfall_triangles kFaces = {kTriangles, 6};
static const footfall_agent kAgent = {45, 1.8, 1, 0, 0.05, 0, 0};

static footfall_environment* makeLevel(void) {
  footfall_environment* level = NULL;
  CHECK_OK(footfall_make_environment(kPoints, kFaces, 1, &level));
  return level;
}

static footfall_result* runOn(const footfall_environment* level) {
  footfall_result* result = NULL;
  CHECK_OK(footfall_walkable_area(level, &kAgent, NULL, 0, &result));
  return result;
}

/* --- Tests ---------------------------------------------------------------------------------------------------------
 */

static void testArrays(void) {
  footfall_environment* level = makeLevel();
  CHECK(footfall_environment_vertices(level).count == 12);
  CHECK(memcmp(footfall_environment_vertices(level).data, kVertices, sizeof kVertices) == 0);
  CHECK(memcmp(footfall_environment_triangles(level).data, kTriangles, sizeof kTriangles) == 0);
  CHECK(footfall_environment_metres_per_unit(level) == 1);

  footfall_result* result = runOn(level);
  footfall_free_environment(level); /* the result keeps what it needs */
  const footfall_points points = footfall_result_vertices(result);
  const footfall_triangles triangles = footfall_result_triangles(result);
  CHECK(fabs(footfall_result_area(result) - 28) < 1e-12);
  CHECK(triangles.count > 0 && footfall_result_sources(result).count == triangles.count);
  double area = 0;
  for (size_t t = 0; t < triangles.count; ++t) {
    const double* corner[3];
    for (int k = 0; k < 3; ++k) {
      CHECK(triangles.data[3 * t + k] < points.count);
      corner[k] = points.data + 3 * triangles.data[3 * t + k];
    }
    area += ((corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
             (corner[1][1] - corner[0][1]) * (corner[2][0] - corner[0][0])) /
            2;
    CHECK(footfall_result_sources(result).data[t] < 4);
  }
  CHECK(fabs(area - 28) < 1e-12);
  CHECK(footfall_result_layers(result).count == triangles.count && footfall_result_layer_count(result) == 1);
  CHECK(footfall_result_obstacle_edges(result).count == 0 && footfall_result_connections(result).count == 0);
  CHECK(footfall_result_links(result).count == 0 && footfall_result_links(NULL).count == 0);
  CHECK(footfall_result_drops(result).count == 0 && footfall_result_drops(NULL).count == 0);
  char* json = NULL;
  CHECK_OK(footfall_result_statistics(result, &json));
  CHECK(json != NULL && strstr(json, "\"area\": 28.0") != NULL);
  footfall_free_text(json);
  footfall_free_result(result);
}

static void testBadArrays(void) {
  footfall_environment* level = NULL;
  double vertices[sizeof kVertices / sizeof *kVertices];
  uint32_t triangles[sizeof kTriangles / sizeof *kTriangles];
  memcpy(vertices, kVertices, sizeof vertices);
  memcpy(triangles, kTriangles, sizeof triangles);
  const footfall_points points = {vertices, 12}, noPoints = {NULL, 12};
  const footfall_triangles faces = {triangles, 6}, noFaces = {NULL, 6}, empty = {NULL, 0};
  CHECK_FAILS(footfall_make_environment(noPoints, faces, 1, &level), FOOTFALL_INPUT_ERROR, "vertices is NULL");
  CHECK_FAILS(footfall_make_environment(points, noFaces, 1, &level), FOOTFALL_INPUT_ERROR, "triangles is NULL");
  CHECK_FAILS(footfall_make_environment(points, empty, 1, &level), FOOTFALL_INPUT_ERROR, "no triangles");
  CHECK_FAILS(footfall_make_environment(points, faces, 0, &level), FOOTFALL_INPUT_ERROR, "metresPerUnit");
  CHECK_FAILS(footfall_make_environment(points, faces, NAN, &level), FOOTFALL_INPUT_ERROR, "metresPerUnit");
  CHECK_FAILS(footfall_make_environment(points, faces, 1, NULL), FOOTFALL_INPUT_ERROR, "environment is NULL");
  vertices[5] = NAN;
  CHECK_FAILS(footfall_make_environment(points, faces, 1, &level), FOOTFALL_INPUT_ERROR, "vertex 1 ");
  vertices[5] = HUGE_VAL;
  CHECK_FAILS(footfall_make_environment(points, faces, 1, &level), FOOTFALL_INPUT_ERROR, "not finite");
  vertices[5] = 0;
  triangles[4] = 12;
  CHECK_FAILS(footfall_make_environment(points, faces, 1, &level), FOOTFALL_INPUT_ERROR, "triangle 1 names vertex 12");
  CHECK(level == NULL);
}

static void testNull(void) {
  footfall_result* result = NULL;
  footfall_environment* level = makeLevel();
  char* text = NULL;
  CHECK_FAILS(footfall_load(NULL, NULL, NULL, &level), FOOTFALL_INPUT_ERROR, "path is NULL");
  CHECK_FAILS(footfall_walkable_area(NULL, NULL, NULL, 0, &result), FOOTFALL_INPUT_ERROR, "environment is NULL");
  CHECK_FAILS(footfall_walkable_area(level, NULL, NULL, 0, NULL), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK_FAILS(footfall_run(NULL, "", NULL, NULL, 0, &result), FOOTFALL_INPUT_ERROR, "environment is NULL");
  CHECK_FAILS(footfall_save(NULL, "a.obj", NULL), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK_FAILS(footfall_result_statistics(NULL, &text), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK_FAILS(footfall_find_components(NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK_FAILS(footfall_make_path_finder(NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK_FAILS(footfall_find_path(NULL, NULL, NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "finder is NULL");
  CHECK_FAILS(footfall_make_inspector(NULL, NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK_FAILS(footfall_explain(NULL, NULL, NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "inspector is NULL");
  CHECK_FAILS(footfall_compare(NULL, NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "first is NULL");
  CHECK_FAILS(footfall_make_level(NULL, NULL), FOOTFALL_INPUT_ERROR, "environment is NULL");
  CHECK_FAILS(footfall_level_environment(NULL, NULL), FOOTFALL_INPUT_ERROR, "level is NULL");
  CHECK_FAILS(footfall_add_obstacle(NULL, kPoints, kFaces, NULL), FOOTFALL_INPUT_ERROR, "level is NULL");
  CHECK_FAILS(footfall_make_context(NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "context is NULL");
  CHECK_FAILS(footfall_make_cache(0, NULL), FOOTFALL_INPUT_ERROR, "cache is NULL");
  CHECK_FAILS(footfall_check_pipeline(NULL), FOOTFALL_INPUT_ERROR, "pipeline is NULL");
  CHECK_FAILS(footfall_pipeline_for(level, NULL, NULL), FOOTFALL_INPUT_ERROR, "pipeline is NULL");
  CHECK(result == NULL && text == NULL);
  CHECK(footfall_result_vertices(NULL).count == 0 && footfall_result_triangles(NULL).data == NULL);
  CHECK(footfall_result_layers(NULL).count == 0 && footfall_result_layer_count(NULL) == 0);
  CHECK(footfall_environment_vertices(NULL).count == 0 && footfall_environment_triangles(NULL).count == 0);
  CHECK(footfall_component_count(NULL) == 0 && footfall_component_of_triangles(NULL).count == 0);
  CHECK(footfall_path_points(NULL).count == 0 && footfall_path_barrier(NULL, NULL) == 0);
  footfall_cancel(NULL);
  footfall_free_context(NULL);
  footfall_free_environment(NULL);
  footfall_free_level(NULL);
  footfall_free_cache(NULL);
  footfall_free_result(NULL);
  footfall_free_components(NULL);
  footfall_free_path(NULL);
  footfall_free_path_finder(NULL);
  footfall_free_inspector(NULL);
  footfall_free_text(NULL);
  footfall_free_environment(level);
}

static void testPipelines(void) {
  footfall_environment* level = makeLevel();
  footfall_result* result = NULL;
  char* text = NULL;
  const footfall_agent standard = footfall_default_agent();
  CHECK(standard.max_slope == 45 && standard.height == 2 && standard.minimum_area == 1 && standard.step == 0.4 &&
        standard.gap == 0.05 && standard.radius == 0 && standard.drop == 0);
  CHECK_OK(footfall_pipeline_for(level, &kAgent, &text));
  CHECK(text != NULL && strstr(text, "SlopeFilter 45\nVerticalClearanceFilter 1.8\nAreaFilter 1\n") != NULL);
  CHECK_OK(footfall_check_pipeline(text));
  CHECK_OK(footfall_run(level, text, NULL, NULL, 1, &result));
  footfall_free_text(text);
  footfall_result* same = runOn(level);
  CHECK(footfall_result_triangles(result).count == footfall_result_triangles(same).count);
  footfall_free_result(same);
  footfall_free_result(result);

  result = NULL;
  CHECK_FAILS(footfall_check_pipeline("SlopeFilter 45\nNoFilter 2\n"), FOOTFALL_INPUT_ERROR, "pipeline:2:1:");
  CHECK_FAILS(footfall_check_pipeline("SlopeFilter 91"), FOOTFALL_INPUT_ERROR, "pipeline:1:13:");
  CHECK_FAILS(footfall_run(level, "SlopeFilter", NULL, NULL, 0, &result), FOOTFALL_INPUT_ERROR, "pipeline:1:");
  CHECK_OK(footfall_check_pipeline("ReachableFilter 1 2 3 4 5 6"));
  CHECK_FAILS(footfall_check_pipeline("ReachableFilter 1 2 3 4 5"), FOOTFALL_INPUT_ERROR, "pipeline:1:23:");
  CHECK_FAILS(footfall_run(level, "ReachableFilter 2000 0 0", NULL, NULL, 0, &result), FOOTFALL_INPUT_ERROR,
              "column 17: seed 1 at 2000 0 0 has no walkable place");
  CHECK_FAILS(footfall_check_pipeline("DropFilter 1"), FOOTFALL_INPUT_ERROR,
              "pipeline:1:1: DropFilter needs VerticalClearance");
  CHECK_OK(footfall_run(level, "VerticalClearanceFilter 1.8\nDropFilter 0.5", NULL, NULL, 0, &result));
  const footfall_drops drops = footfall_result_drops(result);
  CHECK(drops.count == 1);
  if (drops.count == 1) {
    const footfall_drop* drop = drops.data;
    CHECK(drop->depth == 0.5 && drop->width == 4 && drop->start[0][2] == 0.5 && drop->landing[1][2] == 0);
    CHECK(drop->start[0][0] == 4 && drop->landing[0][0] == 4 && drop->from_triangle != drop->to_triangle);
  }
  const double above[3] = {6, 2, 0.5}, below[3] = {3, 3, 0};
  footfall_path_finder* jumps = NULL;
  footfall_path* jump = NULL;
  CHECK_OK(footfall_make_path_finder(result, NULL, &jumps));
  CHECK_OK(footfall_find_path(jumps, above, below, NULL, &jump));
  CHECK(footfall_path_found(jump) == FOOTFALL_PATH_FOUND && footfall_path_drop_count(jump) == 1);
  CHECK(footfall_path_drop_count(NULL) == 0);
  footfall_free_path(jump);
  footfall_free_path_finder(jumps);
  footfall_free_result(result);
  result = NULL;
  footfall_agent climbs = kAgent;
  climbs.step = 0.25;
  CHECK_OK(footfall_pipeline_for(level, &climbs, &text));
  CHECK(strstr(text, "VerticalClearanceFilter 1.8\nStepFilter 0.25\nAreaFilter 1\n") != NULL);
  footfall_free_text(text);
  climbs.radius = 0.3;
  CHECK_OK(footfall_pipeline_for(level, &climbs, &text));
  CHECK(strstr(text, "StepFilter 0.25\nRadiusFilter 0.3\nAreaFilter 1\n") != NULL);
  footfall_free_text(text);
  climbs.radius = 0;
  climbs.drop = 1.25;
  CHECK_OK(footfall_pipeline_for(level, &climbs, &text));
  CHECK(strstr(text, "\nDropFilter 1.25\n") != NULL);
  footfall_free_text(text);
  footfall_agent wrong = kAgent;
  wrong.step = -1;
  CHECK_FAILS(footfall_walkable_area(level, &wrong, NULL, 0, &result), FOOTFALL_INPUT_ERROR, "agent: step");
  wrong = kAgent;
  wrong.height = -1;
  CHECK_FAILS(footfall_walkable_area(level, &wrong, NULL, 0, &result), FOOTFALL_INPUT_ERROR, "agent: ");
  wrong = kAgent;
  wrong.max_slope = NAN;
  CHECK_FAILS(footfall_walkable_area(level, &wrong, NULL, 0, &result), FOOTFALL_INPUT_ERROR, "not a finite number");
  CHECK(result == NULL);
  footfall_free_environment(level);
}

typedef struct Progress {
  footfall_context* context;
  int cancels;
  volatile int events;
} Progress;

/* Cancels from inside: the run goes no further, on whatever thread this is called. */
static void onProgress(void* user, size_t step, const char* name, double fraction) {
  Progress* progress = (Progress*)user;
  progress->events = progress->events + 1;
  if (name == NULL || step > 6 || !(fraction >= 0 && fraction <= 1)) progress->events = -1000;
  if (progress->cancels) footfall_cancel(progress->context);
}

static void testProgressAndCancelling(void) {
  footfall_environment* level = makeLevel();
  footfall_result* result = NULL;
  Progress progress = {NULL, 0, 0};
  CHECK_OK(footfall_make_context(onProgress, &progress, &progress.context));
  CHECK_OK(footfall_walkable_area(level, &kAgent, progress.context, 1, &result));
  CHECK(progress.events >= 14); /* each of seven steps begins and ends */
  footfall_free_result(result);

  result = NULL;
  progress.cancels = 1;
  CHECK_FAILS(footfall_walkable_area(level, &kAgent, progress.context, 1, &result), FOOTFALL_CANCELLED, "cancelled");
  CHECK_STATUS(footfall_run(level, NULL, NULL, progress.context, 0, &result), FOOTFALL_CANCELLED);
  CHECK(result == NULL);
  footfall_free_context(progress.context);
  footfall_free_environment(level);
}

static size_t countComponents(const footfall_level* level, footfall_cache* cache) {
  footfall_environment* now = NULL;
  footfall_result* result = NULL;
  footfall_components* components = NULL;
  CHECK_OK(footfall_level_environment(level, &now));
  CHECK_OK(footfall_run(now, "SlopeFilter 45\nVerticalClearanceFilter 0.9\nAreaFilter 0\n", cache, NULL, 0, &result));
  CHECK_OK(footfall_find_components(result, NULL, &components));
  const size_t count = footfall_component_count(components);
  CHECK(footfall_component_of_triangles(components).count == footfall_result_triangles(result).count);
  footfall_component component;
  CHECK_OK(footfall_get_component(components, 0, &component));
  CHECK(component.area > 0 && component.triangles > 0 && component.lower[0] < component.upper[0]);
  CHECK_FAILS(footfall_get_component(components, count, &component), FOOTFALL_INPUT_ERROR, "no component");
  footfall_free_components(components);
  footfall_free_result(result);
  footfall_free_environment(now);
  return count;
}

static void testObstacles(void) {
  static const double wall[] = {5, -1, 0, 5, 5, 0, 5, 5, 2, 5, -1, 2}, thinner[] = {9, 0, 0, 9, 4, 0, 9, 4, 2, 9, 0, 2};
  static const uint32_t sides[] = {0, 1, 2, 0, 2, 3}, outOfRange[] = {0, 1, 4};
  const footfall_points points = {wall, 4}, away = {thinner, 4};
  const footfall_triangles faces = {sides, 2}, wrong = {outOfRange, 1};
  footfall_environment* environment = makeLevel();
  footfall_level* level = NULL;
  footfall_cache* cache = NULL;
  uint32_t id = 99;
  CHECK_OK(footfall_make_level(environment, &level));
  CHECK_OK(footfall_make_cache(0, &cache));
  CHECK(countComponents(level, cache) == 2);
  CHECK_OK(footfall_add_obstacle(level, points, faces, &id));
  CHECK(countComponents(level, cache) == 3);
  CHECK_FAILS(footfall_replace_obstacle(level, id, points, wrong), FOOTFALL_INPUT_ERROR, "vertex 4 of 4");
  CHECK(countComponents(level, cache) == 3);
  CHECK_OK(footfall_replace_obstacle(level, id, away, faces));
  CHECK(countComponents(level, cache) == 2);
  CHECK_FAILS(footfall_remove_obstacle(level, id + 7), FOOTFALL_INPUT_ERROR, "no obstacle");
  CHECK_OK(footfall_remove_obstacle(level, id));
  CHECK_FAILS(footfall_remove_obstacle(level, id), FOOTFALL_INPUT_ERROR, "no obstacle");
  footfall_free_cache(cache);
  footfall_free_level(level);
  footfall_free_environment(environment);
}

static void testPaths(void) {
  footfall_environment* level = makeLevel();
  footfall_result* result = runOn(level);
  footfall_path_finder* finder = NULL;
  footfall_path* path = NULL;
  footfall_barrier barrier;
  footfall_path_finder* before = NULL;
  CHECK_OK(footfall_make_path_finder(result, NULL, &before));
  CHECK_FAILS(footfall_follow_path_finder(result, NULL, NULL, &finder), FOOTFALL_INPUT_ERROR, "before is NULL");
  CHECK_OK(footfall_follow_path_finder(result, before, NULL, &finder));
  footfall_free_path_finder(before);
  footfall_free_result(result);
  footfall_free_environment(level);

  /* Around the corner of what lies under the ceiling. */
  const double from[] = {3, 1, 0}, behind[] = {1, 3, 0}, above[] = {6, 2, 0.5}, under[] = {1, 1, 0},
               nan[] = {NAN, 0, 0};
  CHECK_OK(footfall_find_path(finder, from, behind, NULL, &path));
  CHECK(footfall_path_found(path) == FOOTFALL_PATH_FOUND && footfall_path_failure(path)[0] == '\0');
  CHECK(fabs(footfall_path_length(path) - 2 * sqrt(2.0)) < 1e-12);
  CHECK(footfall_path_plan_length(path) == footfall_path_length(path));
  CHECK(footfall_path_least_plan_length(path) == footfall_path_plan_length(path));
  CHECK(footfall_path_triangles(path).count + 1 == footfall_path_points(path).count);
  CHECK(memcmp(footfall_path_points(path).data, from, sizeof from) == 0);
  CHECK(footfall_path_barrier(path, &barrier) == 0);
  footfall_free_path(path);

  CHECK_OK(footfall_find_path(finder, from, above, NULL, &path));
  CHECK(footfall_path_found(path) == FOOTFALL_PATH_NOT_CONNECTED);
  CHECK(strstr(footfall_path_failure(path), "a step of 0.5 up") != NULL);
  CHECK(footfall_path_barrier(path, &barrier) == 1);
  CHECK(barrier.kind == FOOTFALL_LINK_OPEN && barrier.gap == 0 && barrier.rise == 0.5 && barrier.from[0] == 4);
  footfall_free_path(path);

  CHECK_OK(footfall_find_path(finder, from, under, NULL, &path));
  CHECK(footfall_path_found(path) == FOOTFALL_PATH_TARGET_NOT_WALKABLE);
  footfall_free_path(path);

  path = NULL;
  CHECK_FAILS(footfall_find_path(finder, nan, from, NULL, &path), FOOTFALL_INPUT_ERROR, "not finite");
  CHECK_FAILS(footfall_find_path(finder, from, NULL, NULL, &path), FOOTFALL_INPUT_ERROR, "to is NULL");
  CHECK(path == NULL);
  footfall_free_path_finder(finder);
}

/* Both results have the same arrays, byte by byte. */
static int isSameMesh(const footfall_result* first, const footfall_result* second) {
  const footfall_points a = footfall_result_vertices(first), b = footfall_result_vertices(second);
  const footfall_triangles s = footfall_result_triangles(first), t = footfall_result_triangles(second);
  return a.count == b.count && s.count == t.count && s.count > 0 &&
         memcmp(a.data, b.data, 3 * a.count * sizeof *a.data) == 0 &&
         memcmp(s.data, t.data, 3 * s.count * sizeof *s.data) == 0;
}

static void testAgents(void) {
  footfall_environment* level = makeLevel();
  footfall_agent agents[3] = {
      {45, 1.8, 1, 0, 0.05, 0, 0}, {45, 0.9, 1, 0, 0.05, 0.3, 0}, {45, 1.8, 1, 0.5, 0.05, 0, 0}};
  footfall_result* results[3] = {NULL, NULL, NULL};
  CHECK_OK(footfall_run_agents(level, agents, 3, NULL, NULL, 0, results));
  for (int i = 0; i < 3; ++i) {
    footfall_result* alone = NULL;
    CHECK_OK(footfall_walkable_area(level, &agents[i], NULL, 0, &alone));
    CHECK(isSameMesh(results[i], alone));
    CHECK(footfall_result_computed_steps(results[i]) > 0);
    CHECK(i == 0 ? footfall_result_computed_steps(results[i]) == footfall_result_computed_steps(alone)
                 : footfall_result_computed_steps(results[i]) < footfall_result_computed_steps(alone));
    footfall_free_result(alone);
    footfall_free_result(results[i]);
    results[i] = NULL;
  }
  CHECK(footfall_result_computed_steps(NULL) == 0);
  CHECK_OK(footfall_run_agents(level, agents, 0, NULL, NULL, 0, results));
  agents[1].height = -1;
  CHECK_FAILS(footfall_run_agents(level, agents, 3, NULL, NULL, 0, results), FOOTFALL_INPUT_ERROR,
              "agents[1]: agent: ");
  CHECK_FAILS(footfall_run_agents(level, NULL, 3, NULL, NULL, 0, results), FOOTFALL_INPUT_ERROR, "agents is NULL");
  CHECK_FAILS(footfall_run_agents(level, agents, 3, NULL, NULL, 0, NULL), FOOTFALL_INPUT_ERROR, "results is NULL");
  CHECK(results[0] == NULL && results[1] == NULL && results[2] == NULL);
  footfall_free_environment(level);
}

static void testBodyPaths(void) {
  footfall_environment* level = makeLevel();
  footfall_result* result = runOn(level);
  footfall_body_path_finder* finder = NULL;
  footfall_body_path* path = NULL;
  footfall_passage passage;
  footfall_barrier barrier;
  double place[3] = {0, 0, 0};
  CHECK_OK(footfall_make_body_path_finder(result, NULL, &finder));
  footfall_free_result(result);
  footfall_free_environment(level);

  /* The path goes round the corner of what lies under the ceiling: two tangents and an arc, in a corridor 2 wide. */
  const double from[] = {3, 1, 0}, behind[] = {1, 3, 0}, above[] = {6, 2, 0.5}, under[] = {1, 1, 0},
               edge[] = {3.9, 1, 0};
  const double radius = 0.5, length = 2 * sqrt(2 - 0.25) + radius * (acos(-1.0) - 2 * acos(radius / sqrt(2.0)));
  CHECK_OK(footfall_find_body_path(finder, from, behind, radius, 0, NULL, &path));
  CHECK(footfall_body_path_found(path) == FOOTFALL_BODY_PATH_FOUND && footfall_body_path_failure(path)[0] == '\0');
  const footfall_path* way = footfall_body_path_way(path);
  CHECK(footfall_path_found(way) == FOOTFALL_PATH_FOUND && footfall_path_failure(way)[0] == '\0');
  CHECK(footfall_path_plan_length(way) >= length && footfall_path_plan_length(way) < length + 1e-3);
  CHECK(footfall_path_points(way).count == footfall_path_triangles(way).count + 1);
  CHECK(memcmp(footfall_path_points(way).data, from, sizeof from) == 0);
  CHECK(footfall_body_path_start_distance(path) == 1 && footfall_body_path_target_distance(path) == 1);
  CHECK(footfall_body_path_lacking(path) == 0 && footfall_body_path_admissible(path, place) == 0);
  CHECK(footfall_body_path_narrowest(path, &passage) == 1 && fabs(passage.width - 2) < 1e-9);
  footfall_free_body_path(path);

  /* There is no other way, so that the widest one is the same. */
  CHECK_OK(footfall_find_body_path(finder, from, behind, radius, HUGE_VAL, NULL, &path));
  CHECK(footfall_path_plan_length(footfall_body_path_way(path)) < length + 1e-3);
  footfall_free_body_path(path);

  CHECK_OK(footfall_find_body_path(finder, from, edge, radius, 0, NULL, &path));
  CHECK(footfall_body_path_found(path) == FOOTFALL_BODY_PATH_TARGET_TOO_NEAR);
  CHECK(fabs(footfall_body_path_lacking(path) - 0.4) < 1e-9 && footfall_body_path_way(path) == NULL);
  CHECK(strstr(footfall_body_path_failure(path), "the target is 0.1 away") != NULL);
  CHECK(footfall_body_path_admissible(path, place) == 1 && fabs(place[0] - 3.5) < 1e-9 && place[1] == 1);
  CHECK(footfall_body_path_narrowest(path, &passage) == 0);
  footfall_free_body_path(path);

  CHECK_OK(footfall_find_body_path(finder, edge, from, radius, 0, NULL, &path));
  CHECK(footfall_body_path_found(path) == FOOTFALL_BODY_PATH_START_TOO_NEAR);
  footfall_free_body_path(path);

  CHECK_OK(footfall_find_body_path(finder, from, above, radius, 0, NULL, &path));
  CHECK(footfall_body_path_found(path) == FOOTFALL_BODY_PATH_NONE);
  CHECK(footfall_path_found(footfall_body_path_way(path)) == FOOTFALL_PATH_NOT_CONNECTED);
  CHECK(strstr(footfall_body_path_failure(path), "a step of 0.5 up") != NULL);
  CHECK(footfall_path_barrier(footfall_body_path_way(path), &barrier) == 1 && barrier.rise == 0.5);
  footfall_free_body_path(path);

  CHECK_OK(footfall_find_body_path(finder, from, under, radius, 0, NULL, &path));
  CHECK(footfall_path_found(footfall_body_path_way(path)) == FOOTFALL_PATH_TARGET_NOT_WALKABLE);
  footfall_free_body_path(path);

  path = NULL;
  CHECK_FAILS(footfall_find_body_path(finder, from, behind, 0, 0, NULL, &path), FOOTFALL_INPUT_ERROR, "the radius");
  CHECK_FAILS(footfall_find_body_path(finder, from, behind, radius, NAN, NULL, &path), FOOTFALL_INPUT_ERROR,
              "the width");
  CHECK_FAILS(footfall_find_body_path(finder, NULL, behind, radius, 0, NULL, &path), FOOTFALL_INPUT_ERROR,
              "from is NULL");
  CHECK_FAILS(footfall_find_body_path(NULL, from, behind, radius, 0, NULL, &path), FOOTFALL_INPUT_ERROR,
              "finder is NULL");
  CHECK_FAILS(footfall_make_body_path_finder(NULL, NULL, NULL), FOOTFALL_INPUT_ERROR, "result is NULL");
  CHECK(path == NULL && footfall_body_path_way(NULL) == NULL && footfall_body_path_found(NULL) != 0);
  footfall_free_body_path(NULL);
  footfall_free_body_path_finder(NULL);
  footfall_free_body_path_finder(finder);
}

/* A wheelchair of 1.1 m at the front door of the house, which is 1 m wide; one of 0.9 m gets in. */
static void testDoor(const char* sample) {
  footfall_environment* level = NULL;
  footfall_result* result = NULL;
  footfall_body_path_finder* finder = NULL;
  footfall_body_path* path = NULL;
  footfall_passage passage;
  const double from[] = {2.5, 20, 0}, to[] = {20, 20, 0};
  CHECK_OK(footfall_load(sample, NULL, NULL, &level));
  CHECK_OK(footfall_walkable_area(level, NULL, NULL, 0, &result));
  CHECK_OK(footfall_make_body_path_finder(result, NULL, &finder));
  CHECK_OK(footfall_find_body_path(finder, from, to, 0.55, 0, NULL, &path));
  CHECK(footfall_body_path_found(path) == FOOTFALL_BODY_PATH_TOO_NARROW && footfall_body_path_way(path) == NULL);
  CHECK(fabs(footfall_body_path_lacking(path) - 0.1) < 1e-6);
  CHECK(footfall_body_path_narrowest(path, &passage) == 1 && fabs(passage.width - 1) < 1e-6);
  CHECK(fabs(passage.place[0] - 18.5) < 1e-6 && fabs(passage.place[1] - 19) < 1e-6);
  CHECK(fabs(fabs(passage.left[0] - passage.right[0]) - 1) < 1e-6 && fabs(passage.left[1] - 19) < 1e-6);
  CHECK(strstr(footfall_body_path_failure(path), "18.5 0.5 -19") != NULL); /* in the frame of the file */
  footfall_free_body_path(path);
  CHECK_OK(footfall_find_body_path(finder, from, to, 0.45, 0, NULL, &path));
  CHECK(footfall_body_path_found(path) == FOOTFALL_BODY_PATH_FOUND);
  CHECK(footfall_body_path_narrowest(path, &passage) == 1 && fabs(passage.width - 1) < 1e-6);
  footfall_free_body_path(path);
  footfall_free_body_path_finder(finder);
  footfall_free_result(result);
  footfall_free_environment(level);
}

static void testGround(void) {
  footfall_environment* level = makeLevel();
  footfall_result* result = runOn(level);
  footfall_path_finder* finder = NULL;
  CHECK_OK(footfall_make_path_finder(result, NULL, &finder));
  const double start[3] = {1, 3, 0}, corner[3] = {3, 3, 0}, under[3] = {1, 1, 0}, above[3] = {3, 3, 1},
               far[3] = {9, 3, 7};
  const double wrong[3] = {NAN, 1, 0};
  footfall_place place;
  CHECK_OK(footfall_place_at(finder, above, &place));
  CHECK(place.triangle != FOOTFALL_NONE && place.position[0] == 3 && place.position[2] == 0 && place.distance == 1);
  CHECK_OK(footfall_place_at(finder, far, &place));
  CHECK(place.triangle == FOOTFALL_NONE && place.position[0] == 0);
  CHECK_OK(footfall_nearest_place(finder, far, &place));
  CHECK(place.triangle != FOOTFALL_NONE && place.position[0] == 8 && place.position[2] == 0.5);
  CHECK_FAILS(footfall_place_at(finder, wrong, &place), FOOTFALL_INPUT_ERROR, "not finite");
  CHECK_FAILS(footfall_place_at(NULL, start, &place), FOOTFALL_INPUT_ERROR, "finder is NULL");
  CHECK_FAILS(footfall_nearest_place(finder, start, NULL), FOOTFALL_INPUT_ERROR, "place is NULL");

  footfall_place places[20], fewer[5];
  CHECK_OK(footfall_random_places(finder, 20, 7, places));
  CHECK_OK(footfall_random_places(finder, 5, 7, fewer));
  for (int i = 0; i < 20; ++i) {
    CHECK(i >= 5 || memcmp(places[i].position, fewer[i].position, sizeof fewer[i].position) == 0);
    CHECK_OK(footfall_place_at(finder, places[i].position, &place));
    CHECK(place.triangle != FOOTFALL_NONE && place.distance == 0);
  }

  footfall_ray ray, next;
  CHECK_OK(footfall_cast_ray(finder, start, corner, NULL, &ray));
  CHECK(ray.reached != 0 && ray.plan_length == 2 && ray.end.position[0] == 3 && ray.border[0] == FOOTFALL_NONE);
  CHECK_OK(footfall_cast_ray_from(finder, &ray.end, far, NULL, &next));
  CHECK(next.reached == 0 && next.plan_length == 1 && next.end.position[0] == 4 && next.end.distance == 5);
  CHECK(next.border[0] != FOOTFALL_NONE && next.border[1] != FOOTFALL_NONE);
  CHECK(next.start.triangle == ray.end.triangle);
  CHECK_OK(footfall_cast_ray(finder, under, corner, NULL, &ray)); /* under the low ceiling */
  CHECK(ray.start.triangle == FOOTFALL_NONE && ray.reached == 0);
  CHECK_FAILS(footfall_cast_ray_from(finder, &ray.start, far, NULL, &next), FOOTFALL_INPUT_ERROR, "no triangle");
  CHECK_FAILS(footfall_cast_ray_from(finder, NULL, far, NULL, &next), FOOTFALL_INPUT_ERROR, "start is NULL");
  CHECK_FAILS(footfall_cast_ray(finder, start, NULL, NULL, &next), FOOTFALL_INPUT_ERROR, "to is NULL");
  footfall_free_path_finder(finder);
  footfall_free_result(result);
  footfall_free_environment(level);
}

static void testWhy(void) {
  footfall_environment* level = makeLevel();
  footfall_result* result = runOn(level);
  footfall_inspector* inspector = NULL;
  footfall_explanation why;
  char* text = NULL;
  CHECK_OK(footfall_make_inspector(result, NULL, NULL, &inspector));
  const double free_[] = {3, 3, 0}, low[] = {1, 0.5, 0.5}, beside[] = {100, 0, 0};
  CHECK_OK(footfall_explain(inspector, free_, NULL, &why, NULL));
  CHECK(why.verdict == FOOTFALL_WALKABLE && why.step == FOOTFALL_NONE && why.layer == 0 && isinf(why.headroom));
  CHECK_OK(footfall_explain(inspector, low, NULL, &why, &text));
  CHECK(why.verdict == FOOTFALL_TOO_LOW && why.step == 3 && why.limit == 1.8 && why.headroom == 1);
  CHECK(why.triangle < 2 && why.obstacle >= 4 && why.component == FOOTFALL_NONE && why.point[2] == 0);
  CHECK(text != NULL && strstr(text, "VerticalClearanceFilter") != NULL);
  footfall_free_text(text);
  CHECK_FAILS(footfall_explain(inspector, beside, NULL, &why, NULL), FOOTFALL_INPUT_ERROR, "no triangle");
  footfall_free_inspector(inspector);
  footfall_free_result(result);
  footfall_free_environment(level);
}

static void testComparing(void) {
  footfall_environment* level = makeLevel();
  footfall_result *first = runOn(level), *second = NULL, *none = NULL;
  footfall_comparison difference;
  CHECK_OK(footfall_run(level, "SlopeFilter 45\nVerticalClearanceFilter 0.5\n", NULL, NULL, 0, &second));
  CHECK_OK(footfall_run(level, "AreaFilter 1000\n", NULL, NULL, 0, &none));
  CHECK_OK(footfall_compare(first, first, NULL, &difference));
  CHECK(difference.equal && difference.only_first == 0 && difference.distance_most == 0);
  CHECK_OK(footfall_compare(first, second, NULL, &difference));
  CHECK(!difference.equal && difference.only_first == 0 && fabs(difference.only_second - 4) < 1e-12);
  CHECK(difference.distance_least > 0 && difference.distance_least <= difference.distance_most);
  CHECK_OK(footfall_compare(first, none, NULL, &difference));
  CHECK(!difference.equal && isnan(difference.distance_least));
  footfall_free_result(none);
  footfall_free_result(second);
  footfall_free_result(first);
  footfall_free_environment(level);
}

static char* contentsOf(const char* path, size_t* size) {
  FILE* file = fopen(path, "rb");
  CHECK(file != NULL);
  if (file == NULL) return NULL;
  fseek(file, 0, SEEK_END);
  *size = (size_t)ftell(file);
  rewind(file);
  char* contents = (char*)malloc(*size + 1);
  CHECK(contents != NULL && fread(contents, 1, *size, file) == *size);
  fclose(file);
  return contents;
}

static void testFiles(const char* sample, const char* folder, const char* expected) {
  char path[4096];
  footfall_environment *level = NULL, *none = NULL;
  footfall_result* result = NULL;
  CHECK_OK(footfall_load(sample, NULL, NULL, &level));
  const int noThreads[] = {-1, 1025, 1000000, INT_MAX, INT_MIN};
  for (size_t i = 0; i < sizeof noThreads / sizeof noThreads[0]; ++i) {
    CHECK_FAILS(footfall_run(level, NULL, NULL, NULL, noThreads[i], &result), FOOTFALL_INPUT_ERROR, "threads are out");
    CHECK_FAILS(footfall_walkable_area(level, NULL, NULL, noThreads[i], &result), FOOTFALL_INPUT_ERROR, "1 to 1024");
    CHECK(result == NULL);
  }
  CHECK_OK(footfall_run(level, NULL, NULL, NULL, 0, &result));
  snprintf(path, sizeof path, "%s/c.obj", folder);
  CHECK_OK(footfall_save(result, path, NULL));
  size_t size = 0, expectedSize = 1;
  char *bytes = contentsOf(path, &size), *expectedBytes = contentsOf(expected, &expectedSize);
  CHECK(size == expectedSize && memcmp(bytes, expectedBytes, size) == 0);
  free(bytes);
  free(expectedBytes);

  footfall_export_options options = {1, 1, 1, FOOTFALL_UP_Z, 0, 1, 1, 0, 0, 0, NULL};
  CHECK_OK(footfall_save(result, path, &options));
  bytes = contentsOf(path, &size);
  bytes[size] = '\0';
  CHECK(strstr(bytes, "\ng walkable\n") != NULL && strstr(bytes, "Z up") != NULL && strstr(bytes, "\nl ") == NULL);
  free(bytes);
  options.scale = -1;
  CHECK_FAILS(footfall_save(result, path, &options), FOOTFALL_INPUT_ERROR, "scale");
  options.scale = 1;
  options.up = (footfall_up_axis)17;
  CHECK_FAILS(footfall_save(result, path, &options), FOOTFALL_INPUT_ERROR, "up axis 17");
  const footfall_export_options godot = {.godot = 3};
  CHECK_FAILS(footfall_save(result, path, &godot), FOOTFALL_INPUT_ERROR, "a version of Godot");
  snprintf(path, sizeof path, "%s/c.tres", folder);
  CHECK_OK(footfall_save(result, path, &godot));
  bytes = contentsOf(path, &size);
  bytes[size] = '\0';
  CHECK(strstr(bytes, "format=2") != NULL);
  free(bytes);
  snprintf(path, sizeof path, "%s/c.gltf", folder);
  const footfall_export_options node = {.navmesh_node = 1};
  CHECK_OK(footfall_save(result, path, &node));
  bytes = contentsOf(path, &size);
  bytes[size] = '\0';
  CHECK(strstr(bytes, "walkable-navmesh") != NULL);
  free(bytes);
  snprintf(path, sizeof path, "%s/c.geojson", folder);
  footfall_export_options polygons = {.part = 1, .coordinate_system = "EPSG:25832"};
  CHECK_OK(footfall_save(result, path, &polygons));
  bytes = contentsOf(path, &size);
  bytes[size] = '\0';
  CHECK(strstr(bytes, "EPSG::25832") != NULL && strstr(bytes, "\"part\": 2") == NULL);
  free(bytes);
  polygons.part = 100000;
  CHECK_FAILS(footfall_save(result, path, &polygons), FOOTFALL_INPUT_ERROR, "no connected part 100000");
  snprintf(path, sizeof path, "%s/nowhere/c.obj", folder);
  CHECK_FAILS(footfall_save(result, path, NULL), FOOTFALL_RUN_ERROR, "folder");
  snprintf(path, sizeof path, "%s/c.txt", folder);
  CHECK_FAILS(footfall_save(result, path, NULL), FOOTFALL_INPUT_ERROR, ".glb");
  snprintf(path, sizeof path, "%s/none.obj", folder);
  CHECK_FAILS(footfall_load(path, NULL, NULL, &none), FOOTFALL_INPUT_ERROR, "none.obj");
  CHECK_FAILS(footfall_load("/dev", NULL, NULL, &none), FOOTFALL_INPUT_ERROR, "footfall_load: /dev: a folder without");
  CHECK(none == NULL);
  const footfall_import_options import = {FOOTFALL_UP_Z, 0.5, 0, FOOTFALL_GRID_ON, 0, 0};
  const footfall_import_options noStep = {FOOTFALL_UP_Z, 0.5, 0, FOOTFALL_GRID_STEP, 0, 0};
  CHECK_FAILS(footfall_load(sample, &noStep, NULL, &none), FOOTFALL_INPUT_ERROR, "grid");
  CHECK_OK(footfall_load(sample, &import, NULL, &none));
  CHECK(footfall_environment_metres_per_unit(none) == 0.5);
  footfall_free_environment(none);
  footfall_free_result(result);
  footfall_free_environment(level);
}

/* A thread that has not failed has no message. */
static void* failElsewhere(void* unused) {
  (void)unused;
  CHECK(strcmp(footfall_message(), "") == 0);
  CHECK_FAILS(footfall_check_pipeline("Elsewhere"), FOOTFALL_INPUT_ERROR, "Elsewhere");
  return NULL;
}

static void testMessagesOfThreads(void) {
  pthread_t thread;
  CHECK_FAILS(footfall_check_pipeline("Here"), FOOTFALL_INPUT_ERROR, "Here");
  CHECK(pthread_create(&thread, NULL, failElsewhere, NULL) == 0);
  pthread_join(thread, NULL);
  checkMessage("Here", __LINE__);
}

int main(int count, char** arguments) {
  if (count != 4) return 2;
  CHECK(strchr(footfall_version(), '.') != NULL);
  testArrays();
  testBadArrays();
  testNull();
  testPipelines();
  testProgressAndCancelling();
  testObstacles();
  testPaths();
  testBodyPaths();
  testDoor(arguments[1]);
  testAgents();
  testGround();
  testWhy();
  testComparing();
  testFiles(arguments[1], arguments[2], arguments[3]);
  testMessagesOfThreads();
  if (failures > 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures > 0;
}
