// `footfall path`: the shortest path between two places of the walkable area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/command_files.hpp"

namespace footfall::app {

struct PathArguments {
  EnvironmentChoice environment;
  std::array<double, 3> from{}, to{};  ///< in the file's own coordinates
  std::optional<double> reach;         ///< empty: just below the pipeline's clearance
  std::string pipelineFile;            ///< empty: `filters`, or the default pipeline when they are empty as well
  std::vector<std::string> filters;    ///< one line of a pipeline file each
  int threads = 0;                     ///< 0: as many as the machine has
  std::string output;                  ///< empty: no OBJ
  bool json = false;
  bool quiet = false;
};

struct PathOutcome {
  std::string report;   ///< for stdout
  std::string failure;  ///< why there is no path; empty when there is one
};

/// SIGINT and SIGTERM cancel while it runs. Where the target cannot be reached, the path leads to the nearest place
/// that can, and is reported and written as well. Throws InputError, RunError or Cancelled.
PathOutcome findPath(const PathArguments& arguments);

}  // namespace footfall::app
