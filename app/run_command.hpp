// `footfall run`: load, run the pipeline, export.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/command_files.hpp"
#include "core/io/export.hpp"

namespace footfall::app {
using namespace detail;

struct RunArguments {
  EnvironmentChoice environment;
  std::string pipelineFile;          ///< empty: `filters`, or the default pipeline when they are empty as well
  std::vector<std::string> filters;  ///< one line of a pipeline file each
  int threads = 0;                   ///< 0: as many as the machine has
  std::string output;                ///< empty: nothing is exported; else .obj, .gltf or .glb
  ExportOptions exportOptions;
  std::string statistics;  ///< empty: no statistics are written
  std::string trace;       ///< empty: no timeline is written
  std::string report;      ///< empty: no HTML report is written
  bool speedUp = false;    ///< also measure the speed-up against one thread
  bool quiet = false;
};

/// Returns the summary for stdout, empty when quiet. SIGINT and SIGTERM cancel while it runs: each file is written as
/// a whole or stays as it was. Throws InputError, RunError or Cancelled.
std::string runAndExport(const RunArguments& arguments);

}  // namespace footfall::app
