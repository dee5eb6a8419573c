// `footfall why`: why a place of an environment is walkable, or why not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/command_files.hpp"

namespace footfall::app {

struct WhyArguments {
  EnvironmentChoice environment;
  std::array<double, 3> place{};     ///< in the file's frame and units
  std::string pipelineFile;          ///< empty: `filters`, or the default pipeline when they are empty as well
  std::vector<std::string> filters;  ///< one line of a pipeline file each
  int threads = 0;                   ///< 0: as many as the machine has
  bool json = false;
};

/// Runs the pipeline and returns what to say of the highest place at or under the point. SIGINT and SIGTERM cancel
/// while it runs. Throws InputError (also where nothing is under the point), RunError or Cancelled.
std::string explainPlace(const WhyArguments& arguments);

}  // namespace footfall::app
