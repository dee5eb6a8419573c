// Reports about results: the header of an export, figures of a run, paths and places, in words and as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "footfall/environment.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"

namespace footfall {

// --- Exports
// ----------------------------------------------------------------------------------------------------------

/// The agent that can walk wherever the enabled steps leave: "slope 45 degrees, height 2, step 0.4" (the environment's
/// units). Where a filter occurs more than once, the strictest counts; "any" where there is no such filter, and nothing
/// about steps where none are climbed.
std::string describeAgent(const Pipeline& pipeline);

/// The same as numbers. Where a filter occurs more than once, the smallest slope and the largest of all others count.
AgentNumbers agentNumbers(const Pipeline& pipeline);

/// The header of an export: the enabled steps and the agent, in words and as numbers.
ExportHeader makeExportHeader(const Pipeline& pipeline);

// --- Runs
// -------------------------------------------------------------------------------------------------------------

/// Speed-up S and efficiency E against one thread (thesis 5.4 and 5.6): medians of several runs, in milliseconds.
struct SpeedUp {
  double oneThreadMs = 0;  ///< the same filters without parallel blocks, on one thread
  double parallelMs = 0;   ///< time of the run as given

  [[nodiscard]] double speedUp() const { return parallelMs > 0 ? oneThreadMs / parallelMs : 1; }
  [[nodiscard]] double efficiency(int threads) const { return speedUp() / threads; }
};

/// Times around the run that the runner does not see, in milliseconds.
struct ProgramTimes {
  double loadMs = 0;
  double exportMs = 0;             ///< 0 when nothing was exported
  double totalMs = 0;              ///< load, run and export
  std::optional<SpeedUp> speedUp;  ///< set if it was measured
};

/// JSON text with `environment`, `steps` (a list; each with `name`, `parameters` (an object by parameter name),
/// `start_ms`, `wall_ms`, `cpu_ms`, `triangles_in`, `triangles_out`, `area_in`, `area_out`, `note`), `load_ms`,
/// `start_ms`, `finish_ms`, `export_ms`, `total_ms`, `run_ms`, `cpu_ms` (of the run), `threads`, `peak_rss_bytes`,
/// `triangles`, `area`, `layers`, `layers_at_least`, `connections`, `links` (steps, as pairs of edges), `link_length`
/// (in the plan), `highest_link` (null without any), `obstacle_edges`, `components` (connected over edges and steps,
/// largest first: a list; each with `area`, `share` of all area, `triangles`, `layers` (their numbers)),
/// `connected_share` (Components::connectedShare()), `exact_fallbacks` (all steps together) and
/// `exact_fallbacks_by_kind`. Areas are in the square of the environment's unit.
///
/// About parallel blocks: `times` (thesis 5.4: `preprocessing_ms`, `partitioning_ms`, `parallel_ms`, `merging_ms`,
/// `postprocessing_ms`, `overhead_ms`, `total_ms`), `speed_up` (S; an object with `one_thread_ms`, `parallel_ms`,
/// `speed_up` and `efficiency` where it was measured, else null), `speed_up_estimate` (CPU time over wall time of the
/// run) and `blocks`: a list with `first_step`, `last_step`, `strategy`, `reason`, `start_ms`, `partitioning_ms`,
/// `parallel_ms`, `merging_ms`, `imbalance` (the busiest thread over the mean), `busy_ms` (by thread), `shared`
/// (filters that worked on all cells together) and `cells`. Each cell has `lower` and `upper` (x, y, z with Z up; null:
/// no end on that side), `cost`, `triangles_in`, `triangles_out`, `thread`, `start_ms`, `end_ms`, `work_ms`, `filters`
/// (time of each in milliseconds) and `spans` (`filter`, `thread`, `start_ms`, `end_ms`). All `start_ms` and `end_ms`
/// count from the beginning of the run.
std::string formatStatistics(const Environment& environment, const RunResult& result, const ProgramTimes& times = {});

/// A table of the steps and a few lines on the result, for a terminal or a log.
std::string formatSummary(const Environment& environment, const RunResult& result, const ProgramTimes& times = {});

/// The part of formatStatistics() that needs a mesh alone: `program`, `source`, and from `vertices` to
/// `connected_share`. `area` is the sum of the components.
std::string formatMeshStatistics(const NavigationMesh& mesh);

/// The lines of formatSummary() on what is connected and how.
std::string formatMeshSummary(const NavigationMesh& mesh);

// --- Paths
// ------------------------------------------------------------------------------------------------------------

/// describeFailure(), and what keeps start and target apart: "...; the parts are nearest at 4 1 -3: a step of 0.43 up".
/// `up` is the up axis of the frame in which places are written.
std::string formatFailure(const PathResult& path, UpAxis up);

/// A few lines for a terminal or a log; places in the frame of a file with that up axis, lengths in its units.
std::string formatPath(const PathResult& path, UpAxis up);

/// One JSON object: `status` ("found", "nothing_walkable", "start_not_walkable", "target_not_walkable",
/// "not_connected"), `message` (formatFailure(); empty when found), `from`, `to` (as given), `start`, `end` (null or
/// `position`, `distance` from the given point, `layer` or null), `length`, `plan_length`, `layers`, `connections`,
/// `bends` and `points` (lists of points), `max_slope_degrees`, `max_incline_degrees`, and `separation`, null unless
/// start and target are on separate parts: `largest` (the place in the list of what to overcome first, from 0),
/// `links`, from start to target, each with `kind` (linkWord()), `from`, `to`, `gap`, `rise`, `obstacle` and `headroom`
/// (null where the kind has none), `excess` and `triangles` (BorderLink), `others` (other places, each as in `links`),
/// and the agent's `height` and `step`. Points are [x, y, z] in the frame of the mesh's file.
std::string formatPathJson(const NavigationMesh& mesh, const PathResult& path);

// --- Places
// -----------------------------------------------------------------------------------------------------------

/// A text for people: the place in the file's frame and units, its triangle, the slope, the free height, and the
/// verdict with the filter and the triangle responsible. Triangles are numbered from 0 in the order of the environment:
/// triangles that import left out do not count.
std::string formatExplanation(const Inspector& inspector, const PlaceExplanation& explanation);

/// The same as JSON: `point`, `triangle`, `mesh`, `material`, `slope` (null: no area), `headroom` (null: unlimited),
/// `above`, `walkable`, `verdict` (a word), `step` (place in the pipeline, from 1), `filter`, `limit`, `obstacle`,
/// `obstacle_height`, `region_area`, `walls`, `floor`, `layer`, `component` (from 1), `component_area`; null where
/// there is none.
std::string formatExplanationJson(const Inspector& inspector, const PlaceExplanation& explanation);

/// The word for a verdict in JSON, e.g. "too_low"; for a verdict of a filter, the word of its descriptor. `pipeline` is
/// that of the run.
std::string_view verdictWord(const Pipeline& pipeline, const PlaceExplanation& explanation);

}  // namespace footfall
