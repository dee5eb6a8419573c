// `footfall run --memory`: a run that holds no more than a part of the environment, and writes its result in tiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/command_options.hpp"
#include "app/run_program.hpp"

namespace footfall::app {

struct TileCommandOptions {
  EnvironmentOptions environment;
  PipelineOptions pipeline;
  std::string folder;        ///< folder to be made, or empty
  std::string statistics;    ///< a file, or empty
  std::uint64_t memory = 0;  ///< bytes
  std::string slice;         ///< "K/N", or empty: all
  int threads = 0;
  bool quiet = false;
};

/// Packs the environment first where it is not packed. Throws InputError, RunError or Cancelled; then the folder is as
/// it was. All ranks of the program's group do it together, rank 0 what one alone has to do.
void runIntoFolder(const TileCommandOptions& options, RunProgram& program, CommandSession& session);

}  // namespace footfall::app
