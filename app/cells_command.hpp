// `footfall cells`: the cells of a strategy, without running the filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/command_files.hpp"

namespace footfall::app {

struct CellsArguments {
  EnvironmentChoice environment;
  std::string strategy;              ///< as in a pipeline file; empty: the pipeline's first, or AutoStrategy
  std::string pipelineFile;          ///< empty: `filters`, or the default pipeline when they are empty as well
  std::vector<std::string> filters;  ///< one line of a pipeline file each
  int threads = 0;                   ///< 0: as many as the machine has
  std::string output;                ///< empty: the cut environment is not exported
  bool json = false;
};

/// Returns the report for stdout. SIGINT and SIGTERM cancel while it runs. Throws InputError, RunError or Cancelled.
std::string previewCells(const CellsArguments& arguments);

}  // namespace footfall::app
