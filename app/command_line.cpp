// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "app/run_program.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall::app {

void runCommandLine(int argc, const char* const* argv) {
  CLI::App app("Computes the exact walkable area of 3D environments.", "footfall");
  app.set_version_flag("--version", "footfall " FOOTFALL_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  RunProgram run;
  addRunCommand(app, run);
  addWhyCommand(app);
  addInfoCommand(app);
  addPackCommand(app);
  addJoinCommand(app);
  addCellsCommand(app);
  addPathCommand(app);
  addCorridorsCommand(app);
  addPlanCommand(app);
  addCompareCommand(app);
  addFiltersCommand(app);
  try {
    app.parse(argc, argv);  // and runs the command
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
      throw InputError(std::string(error.what()) + "; `footfall --help` lists the commands and options");
    app.exit(error);  // --help and --version
    print({});
  }
}

}  // namespace footfall::app
