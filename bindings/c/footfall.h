/* Footfall for C and for every language that calls C: exact walkable areas of 3D environments.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     footfall_environment* level = NULL;
 *     footfall_result* result = NULL;
 *     if (footfall_load("level.glb", NULL, NULL, &level) != FOOTFALL_OK ||
 *         footfall_walkable_area(level, NULL, NULL, 0, &result) != FOOTFALL_OK ||
 *         footfall_save(result, "level.obj", NULL) != FOOTFALL_OK)
 *       fprintf(stderr, "%s\n", footfall_message());
 *     footfall_free_result(result);
 *     footfall_free_environment(level);
 *
 * Frame and units. Inside, Z is up and lengths are in the units of the file; footfall_agent is in metres. Triangles are
 * counter-clockwise seen from the front, their numbers and those of vertices count from 0.
 *
 * Errors. Functions that can fail return a footfall_status; results go to the last arguments, which are written only
 * when FOOTFALL_OK is returned. footfall_message() then says in one line what, where and what to do. No exception
 * leaves the library, and it never prints.
 *
 * Ownership. What a function gives through a pointer to a handle, or as char**, is the caller's, to be freed by the
 * function of its name, footfall_free_...; these take NULL as well. Handles keep what they need: an environment may be
 * freed before the results that were made of it. Arrays and texts that are returned belong to the handle that they were
 * asked of and live as long. What is handed in is copied.
 *
 * Threads. All functions may be called from several threads at the same time. A handle may be used by several threads
 * that only read it; footfall_level is changed by one thread at a time. footfall_cancel() may be called at any time.
 *
 * Stability. Before version 1.0 a new minor version may change this header, and with it the number in the library's
 * soname; a new patch version does not. */
#ifndef FOOTFALL_H
#define FOOTFALL_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define FOOTFALL_API __attribute__((visibility("default")))
#else
#define FOOTFALL_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- Errors --------------------------------------------------------------------------------------------------------
 */

typedef enum footfall_status {
  FOOTFALL_OK = 0,
  FOOTFALL_INPUT_ERROR = 1, /* a file, a pipeline, an array or another argument is wrong */
  FOOTFALL_RUN_ERROR = 2,   /* a result cannot be written, or memory or disk ran out */
  FOOTFALL_CANCELLED = 3,   /* footfall_cancel() was called */
  FOOTFALL_INTERNAL = 4     /* a fault of the library */
} footfall_status;

/* Why the last function that failed on this thread did, in one line; "" when none has. Lives until the next call on
 * this thread that fails. */
FOOTFALL_API const char* footfall_message(void);

/* "0.1.0" */
FOOTFALL_API const char* footfall_version(void);

/* Frees what was given as char**. */
FOOTFALL_API void footfall_free_text(char* text);

/* --- Spans: arrays that belong to somebody else. -------------------------------------------------------------------
 */

/* `count` points of three doubles each: x, y, z. */
typedef struct footfall_points {
  const double* data;
  size_t count;
} footfall_points;

/* `count` triangles of three vertex numbers each. */
typedef struct footfall_triangles {
  const uint32_t* data;
  size_t count;
} footfall_triangles;

/* `count` edges of two vertex numbers each. */
typedef struct footfall_edges {
  const uint32_t* data;
  size_t count;
} footfall_edges;

typedef struct footfall_numbers {
  const uint32_t* data;
  size_t count;
} footfall_numbers;

/* Stands where there is no number. */
#define FOOTFALL_NONE UINT32_MAX

/* --- Progress and cancelling ---------------------------------------------------------------------------------------
 */

typedef struct footfall_context footfall_context;

/* Called from worker threads, perhaps from several at once, so it must be quick: the step with that number (from 0) and
 * filter name is done up to `fraction` in [0, 1]. `name` lives during the call only, and is "" while a step goes on. */
typedef void (*footfall_progress)(void* user, size_t step, const char* name, double fraction);

/* `progress` may be NULL. One context serves any number of calls; once cancelled it stays so. */
FOOTFALL_API footfall_status footfall_make_context(footfall_progress progress, void* user, footfall_context** context);
/* Every call that has this context returns FOOTFALL_CANCELLED, within 50 ms. From any thread. */
FOOTFALL_API void footfall_cancel(footfall_context* context);
FOOTFALL_API void footfall_free_context(footfall_context* context);

/* --- Environments --------------------------------------------------------------------------------------------------
 */

typedef struct footfall_environment footfall_environment;

typedef enum footfall_up_axis {
  FOOTFALL_UP_GUESSED = 0, /* import: by what the file says, or its format; export: that of the source */
  FOOTFALL_UP_X = 1,
  FOOTFALL_UP_Y = 2,
  FOOTFALL_UP_Z = 3,
  FOOTFALL_UP_NEGATIVE_X = 4,
  FOOTFALL_UP_NEGATIVE_Y = 5,
  FOOTFALL_UP_NEGATIVE_Z = 6
} footfall_up_axis;

typedef enum footfall_grid {
  FOOTFALL_GRID_AUTO = 0, /* files of floats, such as glTF */
  FOOTFALL_GRID_ON = 1,   /* all files */
  FOOTFALL_GRID_OFF = 2,
  FOOTFALL_GRID_STEP = 3 /* all files, with a step of your own */
} footfall_grid;

typedef struct footfall_import_options {
  footfall_up_axis up;
  double metres_per_unit; /* 0: guessed */
  int both_sides;         /* not 0: both sides of every triangle are its upper side */
  footfall_grid grid;     /* which coordinates are rounded to a grid (docs/explanation/coordinates.md) */
  double grid_step;       /* of FOOTFALL_GRID_STEP, in units of the file */
  int no_limits;          /* not 0: foreign formats are read without limits of time and memory */
} footfall_import_options;

/* Reads OBJ at double precision, and glTF, FBX, DAE, PLY, STL and others at single precision. `options` (NULL: all
 * guessed) and `context` may be NULL. */
FOOTFALL_API footfall_status footfall_load(const char* path, const footfall_import_options* options,
                                           footfall_context* context, footfall_environment** environment);
/* From arrays, Z up. Coordinates must be finite and vertex numbers in range. */
FOOTFALL_API footfall_status footfall_make_environment(footfall_points vertices, footfall_triangles triangles,
                                                       double metres_per_unit, footfall_environment** environment);
FOOTFALL_API footfall_points footfall_environment_vertices(const footfall_environment* environment);
FOOTFALL_API footfall_triangles footfall_environment_triangles(const footfall_environment* environment);
FOOTFALL_API double footfall_environment_metres_per_unit(const footfall_environment* environment);
FOOTFALL_API void footfall_free_environment(footfall_environment* environment);

/* --- Levels: environments with obstacles that are moved about
 * --------------------------------------------------------- */

typedef struct footfall_level footfall_level;

FOOTFALL_API footfall_status footfall_make_level(const footfall_environment* environment, footfall_level** level);
/* `obstacle` is for the next two; vertices are in the level's units, Z up. */
FOOTFALL_API footfall_status footfall_add_obstacle(footfall_level* level, footfall_points vertices,
                                                   footfall_triangles triangles, uint32_t* obstacle);
FOOTFALL_API footfall_status footfall_replace_obstacle(footfall_level* level, uint32_t obstacle,
                                                       footfall_points vertices, footfall_triangles triangles);
FOOTFALL_API footfall_status footfall_remove_obstacle(footfall_level* level, uint32_t obstacle);
/* The level as it is now. A run over it with the cache of earlier runs computes only what changed. */
FOOTFALL_API footfall_status footfall_level_environment(const footfall_level* level,
                                                        footfall_environment** environment);
FOOTFALL_API void footfall_free_level(footfall_level* level);

/* --- Pipelines -----------------------------------------------------------------------------------------------------
 */

typedef struct footfall_agent {
  double max_slope;    /* degrees, above 0 and below 90 */
  double height;       /* metres, above 0 */
  double minimum_area; /* square metres: connected parts that are no larger are left out */
  double step;         /* metres, at least 0: how high it climbs at once; 0: it does not lift its feet */
  double gap;          /* metres, at least 0: how wide a gap it steps over, seen from above */
  double radius;       /* metres, at least 0: how far it stays away from walls and ledges; 0: it is a point */
  double drop;         /* metres, at least 0: how deep it drops from a ledge, one way; 0: it drops nowhere */
} footfall_agent;

/* 45 degrees, 2 m, 1 square metre, steps of 0.4 m, gaps of 0.05 m, no radius, no drops. */
FOOTFALL_API footfall_agent footfall_default_agent(void);
/* The pipeline for an agent (NULL: the default one) as text, one filter a line, in the environment's units. */
FOOTFALL_API footfall_status footfall_pipeline_for(const footfall_environment* environment, const footfall_agent* agent,
                                                   char** pipeline);
/* Whether a text is a pipeline; the message of an error names line and column. */
FOOTFALL_API footfall_status footfall_check_pipeline(const char* pipeline);

/* --- Runs ----------------------------------------------------------------------------------------------------------
 */

typedef struct footfall_cache footfall_cache;
typedef struct footfall_result footfall_result;

/* Keeps states of recent runs, of about `bytes` (0: an eighth of the machine's memory). */
FOOTFALL_API footfall_status footfall_make_cache(size_t bytes, footfall_cache** cache);
FOOTFALL_API void footfall_free_cache(footfall_cache* cache);

/* The exact walkable area for an agent (NULL: the default one). `context` may be NULL; `threads` 0: as many as the
 * machine has, at most 1024; the result does not depend on it. */
FOOTFALL_API footfall_status footfall_walkable_area(const footfall_environment* environment,
                                                    const footfall_agent* agent, footfall_context* context, int threads,
                                                    footfall_result** result);
/* Runs a pipeline: its text, or NULL for the default one. `cache` and `context` may be NULL. */
FOOTFALL_API footfall_status footfall_run(const footfall_environment* environment, const char* pipeline,
                                          footfall_cache* cache, footfall_context* context, int threads,
                                          footfall_result** result);
/* Runs the pipelines of `count` agents, one after the other, and computes a step that several pipelines begin with
 * once. results[i] belongs to agents[i] and has the bytes of a run of its own. `cache` (NULL: one for this call alone)
 * and `context` may be NULL. After an error, no result is left behind. */
FOOTFALL_API footfall_status footfall_run_agents(const footfall_environment* environment, const footfall_agent* agents,
                                                 size_t count, footfall_cache* cache, footfall_context* context,
                                                 int threads, footfall_result** results);
FOOTFALL_API void footfall_free_result(footfall_result* result);

/* How many steps of the pipeline the run computed. It took the others from its cache, or from the agents before. */
FOOTFALL_API size_t footfall_result_computed_steps(const footfall_result* result);

/* The navigation mesh: vertices are shared by number exactly where an agent can cross. */
FOOTFALL_API footfall_points footfall_result_vertices(const footfall_result* result);
FOOTFALL_API footfall_triangles footfall_result_triangles(const footfall_result* result);
/* The layer of each triangle, from 0; none when no layer filter ran. */
FOOTFALL_API footfall_numbers footfall_result_layers(const footfall_result* result);
FOOTFALL_API uint32_t footfall_result_layer_count(const footfall_result* result);
/* For each triangle one of the environment in whose plane it lies. */
FOOTFALL_API footfall_numbers footfall_result_sources(const footfall_result* result);
/* Edges that an agent cannot cross although walkable area lies on both sides; each once. */
FOOTFALL_API footfall_edges footfall_result_obstacle_edges(const footfall_result* result);
/* Edges on which two layers meet. */
FOOTFALL_API footfall_edges footfall_result_connections(const footfall_result* result);
typedef enum footfall_step_kind { FOOTFALL_STEP = 0, FOOTFALL_GAP = 1 } footfall_step_kind;

typedef struct footfall_link {
  uint32_t from[2], to[2];
  uint32_t from_triangle, to_triangle;
  double height;
  double width;
  uint32_t kind; /* footfall_step_kind */
} footfall_link;

typedef struct footfall_links {
  const footfall_link* data;
  size_t count;
} footfall_links;

/* Steps and gaps, where the pipeline has a StepFilter: two edges, as vertex numbers, each with the walkable area of its
 * triangle on its left. Those of a step lie over each other in the plan, from[0] at to[1]; those of a gap lie beside
 * each other, and no way over it is longer than `width`, seen from above. `height` is the largest difference. */
FOOTFALL_API footfall_links footfall_result_links(const footfall_result* result);
typedef struct footfall_drop {
  uint32_t from[2];
  uint32_t from_triangle, to_triangle;
  double start[2][3], landing[2][3];
  double depth, width;
} footfall_drop;

typedef struct footfall_drops {
  const footfall_drop* data;
  size_t count;
} footfall_drops;

/* Drops, where the pipeline has a DropFilter: stretches of an edge, as vertex numbers with the walkable area of its
 * triangle on the left, from which an agent drops, one way. `start` are the ends of the stretch, `landing` the places
 * in `to_triangle` to which they lead; in between both move evenly. `depth` is the largest difference in height,
 * `width` the length of the stretch in the plan. */
FOOTFALL_API footfall_drops footfall_result_drops(const footfall_result* result);
/* The surface area, in the square of the environment's unit. */
FOOTFALL_API double footfall_result_area(const footfall_result* result);
/* Counts, times and steps as JSON, as `footfall run --stats` writes them. */
FOOTFALL_API footfall_status footfall_result_statistics(const footfall_result* result, char** json);

typedef struct footfall_export_options {
  int without_layers;         /* not 0: one group "walkable" */
  int without_connections;    /* not 0: no lines for them */
  int without_obstacle_edges; /* not 0: no lines for them */
  footfall_up_axis up;
  double scale;      /* coordinates are multiplied with it; 0: 1 */
  int without_steps; /* not 0: no faces for them */
  int without_drops; /* not 0: no lines for them */
  int godot;         /* .tres: the version of Godot that is to read it, 3 or 4; 0: 4 */
  int navmesh_node;  /* not 0, .gltf and .glb: one mesh, whose node is "walkable-navmesh", for Godot's importer */
  /* .wkt and .geojson: this connected part alone, from 1 (the largest) on; 0: all */
  uint32_t part;
  /* .geojson: the coordinate system that the environment is in already, "EPSG:25832"; NULL: none is named */
  const char* coordinate_system;
} footfall_export_options;

/* Writes .obj, .gltf, .glb, .bin (Detour), .tres (Godot), .wkt or .geojson (polygons with holes) by the ending of the
 * name, beside it and renamed; OBJ is in the frame of the environment's file, polygons in metres and Z up, all others
 * in metres and Y up. The bytes are those of `footfall run -o`. An option that the format knows nothing of is an error.
 * `options` may be NULL; what is not set in it must be 0. */
FOOTFALL_API footfall_status footfall_save(const footfall_result* result, const char* path,
                                           const footfall_export_options* options);

/* --- Components: the connected parts of a result
 * ------------------------------------------------------------------------ */

typedef struct footfall_components footfall_components;

typedef struct footfall_component {
  double area; /* of the surface */
  size_t triangles;
  uint32_t first_triangle;
  double lower[3], upper[3]; /* the box around it */
} footfall_component;

FOOTFALL_API footfall_status footfall_find_components(const footfall_result* result, footfall_context* context,
                                                      footfall_components** components);
/* Largest area first. */
FOOTFALL_API size_t footfall_component_count(const footfall_components* components);
FOOTFALL_API footfall_status footfall_get_component(const footfall_components* components, size_t index,
                                                    footfall_component* component);
/* For each triangle of the result the index of its component. */
FOOTFALL_API footfall_numbers footfall_component_of_triangles(const footfall_components* components);
FOOTFALL_API void footfall_free_components(footfall_components* components);

/* --- Paths ---------------------------------------------------------------------------------------------------------
 */

typedef struct footfall_path_finder footfall_path_finder;
typedef struct footfall_path footfall_path;

typedef enum footfall_path_status {
  FOOTFALL_PATH_FOUND = 0,
  FOOTFALL_PATH_NOTHING_WALKABLE = 1,
  FOOTFALL_PATH_START_NOT_WALKABLE = 2,
  FOOTFALL_PATH_TARGET_NOT_WALKABLE = 3,
  FOOTFALL_PATH_NOT_CONNECTED = 4
} footfall_path_status;

typedef enum footfall_link_kind {
  FOOTFALL_LINK_OPEN = 0, /* a step, a gap, or both */
  FOOTFALL_LINK_OBSTACLE = 1,
  FOOTFALL_LINK_LOW_CEILING = 2,
  FOOTFALL_LINK_WALL = 3,
  FOOTFALL_LINK_TOUCH = 4
} footfall_link_kind;

/* What would have to be overcome between two parts: where one is near the other, and what stands there. */
typedef struct footfall_barrier {
  footfall_link_kind kind;
  double from[3], to[3];
  double gap;      /* in the plan */
  double rise;     /* upwards, from `from` to `to` */
  double obstacle; /* FOOTFALL_LINK_OBSTACLE: its height over the lower place */
  double headroom; /* FOOTFALL_LINK_LOW_CEILING: the free height over the higher place */
} footfall_barrier;

/* Prepared once for a result, then asked as often as one likes. */
FOOTFALL_API footfall_status footfall_make_path_finder(const footfall_result* result, footfall_context* context,
                                                       footfall_path_finder** finder);
/* The same finder in a fraction of the time, for a result after an edit: what the edit left as it was is taken from
 * `before`, the finder of the result before it. It stays yours, and may be freed. */
FOOTFALL_API footfall_status footfall_follow_path_finder(const footfall_result* result,
                                                         const footfall_path_finder* before, footfall_context* context,
                                                         footfall_path_finder** finder);
/* The shortest path in the plan between the walkable places straight above or below two points (x, y, z). Where both
 * are not connected, what keeps them apart is looked for too. That there is no path is no error. */
FOOTFALL_API footfall_status footfall_find_path(const footfall_path_finder* finder, const double from[3],
                                                const double to[3], footfall_context* context, footfall_path** path);
FOOTFALL_API footfall_path_status footfall_path_found(const footfall_path* path);
/* From start to end, on the surface; where the target cannot be reached, to the nearest place that can. */
FOOTFALL_API footfall_points footfall_path_points(const footfall_path* path);
/* The triangles that hold the pieces between the points. */
FOOTFALL_API footfall_numbers footfall_path_triangles(const footfall_path* path);
FOOTFALL_API double footfall_path_length(const footfall_path* path);
FOOTFALL_API double footfall_path_plan_length(const footfall_path* path);
/* What no way to the same end is shorter than in the plan: the plan length, or what is proven where drops are taken. */
FOOTFALL_API double footfall_path_least_plan_length(const footfall_path* path);
/* How often the path drops, one way down. */
FOOTFALL_API size_t footfall_path_drop_count(const footfall_path* path);
/* Why there is no path, in one line, in the frame of the environment's file; "" when there is one. */
FOOTFALL_API const char* footfall_path_failure(const footfall_path* path);
/* The largest of what keeps start and target apart. Returns 0, and writes nothing, where nothing does. */
FOOTFALL_API int footfall_path_barrier(const footfall_path* path, footfall_barrier* barrier);
FOOTFALL_API void footfall_free_path(footfall_path* path);
FOOTFALL_API void footfall_free_path_finder(footfall_path_finder* finder);

/* --- Paths for an agent with a body --------------------------------------------------------------------------------
 */

typedef struct footfall_body_path_finder footfall_body_path_finder;
typedef struct footfall_body_path footfall_body_path;

typedef enum footfall_body_path_status {
  FOOTFALL_BODY_PATH_FOUND = 0,
  FOOTFALL_BODY_PATH_NONE = 1,            /* not even a point gets there without drops */
  FOOTFALL_BODY_PATH_START_TOO_NEAR = 2,  /* the start is nearer to a border than the radius */
  FOOTFALL_BODY_PATH_TARGET_TOO_NEAR = 3, /* the target is */
  FOOTFALL_BODY_PATH_TOO_NARROW = 4       /* each way leads through a passage that is too narrow */
} footfall_body_path_status;

/* A narrow place of the walkable area. Lengths are in the plan. */
typedef struct footfall_passage {
  double place[3];
  double left[3], right[3]; /* the nearest places of the border */
  double width;             /* twice the distance to both */
} footfall_passage;

/* A finder is prepared once for a result (its corridor map), and then used any number of times, for any radius. The
 * result should be without the margins of a RadiusFilter. */
FOOTFALL_API footfall_status footfall_make_body_path_finder(const footfall_result* result, footfall_context* context,
                                                            footfall_body_path_finder** finder);
/* The shortest path in the plan that keeps `radius` (above 0, in the units of the file) from every border, between the
 * walkable places straight above or below two points (x, y, z). Passages narrower than `preferred_width` are taken only
 * where the way needs them; 0: width does not matter; INFINITY: the widest way. Drops are not taken. That there is no
 * path is no error. */
FOOTFALL_API footfall_status footfall_find_body_path(const footfall_body_path_finder* finder, const double from[3],
                                                     const double to[3], double radius, double preferred_width,
                                                     footfall_context* context, footfall_body_path** path);
FOOTFALL_API footfall_body_path_status footfall_body_path_found(const footfall_body_path* path);
/* The path as the functions for paths take it (points, triangles, lengths); it belongs to `path`. With
 * FOOTFALL_BODY_PATH_NONE it is that of a point, with the reason in footfall_path_found() and footfall_path_barrier().
 * NULL where a border is too near or every way too narrow. */
FOOTFALL_API const footfall_path* footfall_body_path_way(const footfall_body_path* path);
/* The reason why there is no path, in one line, in the frame of the environment's file; "" when there is one. */
FOOTFALL_API const char* footfall_body_path_failure(const footfall_body_path* path);
/* The narrowest passage of the way; with FOOTFALL_BODY_PATH_TOO_NARROW that which stops the agent, on the way whose
 * narrowest passage is widest. Returns 0, and writes nothing, where there is none. */
FOOTFALL_API int footfall_body_path_narrowest(const footfall_body_path* path, footfall_passage* passage);
/* A place that is far enough, where the start or the target is too near to the border. Returns 0, and writes nothing,
 * where there is none. */
FOOTFALL_API int footfall_body_path_admissible(const footfall_body_path* path, double place[3]);
/* The length that is missing: of the width of the passage, or of the distance of the start or the target. */
FOOTFALL_API double footfall_body_path_lacking(const footfall_body_path* path);
/* The distances from the start and from the target to the border. */
FOOTFALL_API double footfall_body_path_start_distance(const footfall_body_path* path);
FOOTFALL_API double footfall_body_path_target_distance(const footfall_body_path* path);
FOOTFALL_API void footfall_free_body_path(footfall_body_path* path);
FOOTFALL_API void footfall_free_body_path_finder(footfall_body_path_finder* finder);

/* --- Places and straight ways ---------------------------------------------------------------------------------------
 */

/* A walkable place. */
typedef struct footfall_place {
  double position[3];
  uint32_t triangle; /* of the result; FOOTFALL_NONE: there is no such place, and the other members are 0 */
  double distance;   /* from the point that was given */
} footfall_place;

/* The walkable place straight above or below a point (x, y, z) that is nearest to it, as far away as the pipeline's
 * agent is high. */
FOOTFALL_API footfall_status footfall_place_at(const footfall_path_finder* finder, const double point[3],
                                               footfall_place* place);
/* The walkable place that is nearest to a point, in space. */
FOOTFALL_API footfall_status footfall_nearest_place(const footfall_path_finder* finder, const double point[3],
                                                    footfall_place* place);
/* Writes `count` random places, evenly by the area of the surface. The same `seed` gives the same places on every
 * machine. An error where nothing is walkable. */
FOOTFALL_API footfall_status footfall_random_places(const footfall_path_finder* finder, size_t count, uint64_t seed,
                                                    footfall_place* places);

/* A straight way over the ground, seen from above. */
typedef struct footfall_ray {
  footfall_place start;
  footfall_place end; /* the last walkable place: at the target, or on the border that stops the ray; its distance is
                         that to the target in the plan */
  int reached;        /* not 0: the whole way is walkable */
  double plan_length; /* from start to end */
  uint32_t border[2]; /* the vertices of the edge that stops the ray; FOOTFALL_NONE at a corner, or where none does */
} footfall_ray;

/* Walks straight, seen from above, from the walkable place at `from` (footfall_place_at()) towards `to`, whose height
 * is not used: over edges, steps and gaps, never over drops, up to the first border. start.triangle and end.triangle
 * are FOOTFALL_NONE where no walkable place is at `from`. `context` may be NULL. */
FOOTFALL_API footfall_status footfall_cast_ray(const footfall_path_finder* finder, const double from[3],
                                               const double to[3], footfall_context* context, footfall_ray* ray);
/* The same from a place that is known, such as the end of another ray. It starts in the triangle of `start`, whatever
 * else lies there, so that rays in a row never pass a wall without thickness. */
FOOTFALL_API footfall_status footfall_cast_ray_from(const footfall_path_finder* finder, const footfall_place* start,
                                                    const double to[3], footfall_context* context, footfall_ray* ray);

/* --- Why a place is walkable or not
 * ------------------------------------------------------------------------------------- */

typedef struct footfall_inspector footfall_inspector;

typedef enum footfall_verdict {
  FOOTFALL_WALKABLE = 0,
  FOOTFALL_NO_AREA = 1,          /* the triangle is degenerate */
  FOOTFALL_VERTICAL = 2,         /* it is a wall */
  FOOTFALL_FACES_DOWN = 3,       /* no triangle in its plane that faces up is here */
  FOOTFALL_NEVER_FLOOR = 4,      /* it faces up, but is no floor before the first filter */
  FOOTFALL_TOO_STEEP = 5,        /* the slope filter rejected it */
  FOOTFALL_TOO_LOW = 6,          /* the clearance filter */
  FOOTFALL_REGION_TOO_SMALL = 7, /* the area filter */
  FOOTFALL_MOVED = 8,            /* a filter that moves vertices left nothing here */
  FOOTFALL_UNREACHABLE = 9,      /* the reachable filter */
  FOOTFALL_TOO_NEAR_WALL = 10,   /* the radius filter */
  FOOTFALL_TOO_NEAR_LEDGE = 11,  /* the radius filter, and no wall is too near */
  FOOTFALL_REMOVED = 12          /* another filter removed it: that of `step` */
} footfall_verdict;

typedef struct footfall_explanation {
  footfall_verdict verdict;
  double point[3];    /* on the triangle */
  uint32_t triangle;  /* of the environment */
  uint32_t step;      /* of the pipeline, from 0: which rejected it; or FOOTFALL_NONE */
  double limit;       /* of that step: degrees, height, area or distance */
  double slope;       /* degrees, 0 to 180 */
  double headroom;    /* the free height; infinite where nothing is above */
  double wall;        /* how far the nearest wall is, in the plan; NaN where there is none or it is not known */
  double ledge;       /* the same of the nearest ledge */
  uint32_t obstacle;  /* FOOTFALL_TOO_LOW: the triangle above; or FOOTFALL_NONE */
  uint32_t layer;     /* FOOTFALL_WALKABLE; or FOOTFALL_NONE */
  uint32_t component; /* FOOTFALL_WALKABLE: index as in footfall_get_component(); or FOOTFALL_NONE */
} footfall_explanation;

/* For a result. `cache` is that of the run, or NULL: then its steps are computed again. */
FOOTFALL_API footfall_status footfall_make_inspector(const footfall_result* result, footfall_cache* cache,
                                                     footfall_context* context, footfall_inspector** inspector);
/* Of the highest place at or under a point (x, y, z); an error where there is none. `text` (may be NULL) is the same in
 * words, some lines, in the frame of the environment's file. */
FOOTFALL_API footfall_status footfall_explain(const footfall_inspector* inspector, const double point[3],
                                              footfall_context* context, footfall_explanation* explanation,
                                              char** text);
FOOTFALL_API void footfall_free_inspector(footfall_inspector* inspector);

/* --- Comparing -----------------------------------------------------------------------------------------------------
 */

typedef struct footfall_comparison {
  int equal;             /* not 0: the same set of points, exactly */
  double only_first;     /* surface area that only the first has, */
  double only_second;    /* only the second, */
  double common;         /* and both */
  double distance_least; /* the larger of the one-sided Hausdorff distances lies between these two; NaN where one of */
  double distance_most;  /* both is empty */
} footfall_comparison;

/* Two results of one frame and unit. */
FOOTFALL_API footfall_status footfall_compare(const footfall_result* first, const footfall_result* second,
                                              footfall_context* context, footfall_comparison* comparison);

#ifdef __cplusplus
}
#endif

#endif
