// The figures of one run for other programs and for people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/pipeline/runner.hpp"
#include "core/report/speed_up.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Times around the run that the runner does not see, in milliseconds.
struct ProgramTimes {
  double loadMs = 0;
  double exportMs = 0;             ///< 0 when nothing was exported
  double totalMs = 0;              ///< load, run and export
  std::optional<SpeedUp> speedUp;  ///< where it was measured
};

/// JSON text with `environment`, `steps` (a list; each with `name`, `parameters` (an object by parameter name),
/// `start_ms`, `wall_ms`, `cpu_ms`, `triangles_in`, `triangles_out`, `area_in`, `area_out`, `note`), `load_ms`,
/// `start_ms`, `finish_ms`, `export_ms`, `total_ms`, `run_ms`, `cpu_ms` (of the run), `threads`, `peak_rss_bytes`,
/// `triangles`, `area`, `layers`, `connections`, `obstacle_edges`, `exact_fallbacks` (all steps together) and
/// `exact_fallbacks_by_kind`. Areas are in the square of the environment's unit.
///
/// Of parallel blocks: `times` (thesis 5.4: `preprocessing_ms`, `partitioning_ms`, `parallel_ms`, `merging_ms`,
/// `postprocessing_ms`, `overhead_ms`, `total_ms`), `speed_up` (S; an object with `one_thread_ms`, `parallel_ms`,
/// `speed_up` and `efficiency` where it was measured, else null), `speed_up_estimate` (CPU time over wall time of the
/// run) and `blocks`: a list with `first_step`, `last_step`, `strategy`, `reason`, `start_ms`, `partitioning_ms`,
/// `parallel_ms`, `merging_ms`, `imbalance` (the busiest thread over the mean), `busy_ms` (by thread), `shared`
/// (filters that worked on all cells together) and `cells`. Each cell has `lower` and `upper` (x, y, z with Z up; null:
/// no end on that side), `cost`, `triangles_in`, `triangles_out`, `thread`, `start_ms`, `end_ms`, `work_ms`, `filters`
/// (time of each in milliseconds) and `spans` (`filter`, `thread`, `start_ms`, `end_ms`). All `start_ms` and `end_ms`
/// count from the beginning of the run.
std::string formatStatistics(const Environment& environment, const RunResult& result, const ProgramTimes& times);

/// A table of the steps and a few lines on the result, for a terminal or a log.
std::string formatSummary(const Environment& environment, const RunResult& result, const ProgramTimes& times);

}  // namespace footfall::detail
