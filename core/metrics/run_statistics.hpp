// The figures of one run for other programs and for people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/environment/environment.hpp"
#include "core/pipeline/runner.hpp"

namespace footfall {

/// Times around the run that the runner does not see, in milliseconds.
struct ProgramTimes {
  double loadMs = 0;
  double exportMs = 0;  ///< 0 when nothing was exported
  double totalMs = 0;   ///< load, run and export
};

/// JSON text with `environment`, `steps` (a list; each with `name`, `parameters` (an object by parameter name),
/// `wall_ms`, `cpu_ms`, `triangles_in`, `triangles_out`, `area_in`, `area_out`, `note`), `load_ms`, `start_ms`,
/// `finish_ms`, `export_ms`, `total_ms`, `threads`, `peak_rss_bytes`, `triangles`, `area`, `layers`, `connections`,
/// `obstacle_edges`, `exact_fallbacks` (all steps together) and `exact_fallbacks_by_kind`. Areas are in the square of
/// the environment's unit.
std::string formatStatistics(const Environment& environment, const RunResult& result, const ProgramTimes& times);

/// A table of the steps and a few lines on the result, for a terminal or a log.
std::string formatSummary(const Environment& environment, const RunResult& result, const ProgramTimes& times);

}  // namespace footfall
