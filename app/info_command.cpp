// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "app/export_options.hpp"
#include "core/io/environment_text.hpp"
#include "core/io/export.hpp"
#include "core/report/info.hpp"

namespace footfall::app {
using namespace detail;

void addInfoCommand(CLI::App& app) {
  struct InfoOptions {
    EnvironmentOptions environment;
    std::string coordinates;
  };
  const auto options = std::make_shared<InfoOptions>();
  CLI::App& command = *app.add_subcommand("info", "Print what an environment holds");
  options->environment.addTo(command);
  command
      .add_option("--coordinates", options->coordinates,
                  "Write the triangles to this file, with the coordinates that runs work on: those of the grid, where "
                  "there is one")
      ->type_name("FILE.obj");
  command.callback([options] {
    checkEnding(options->coordinates, "--coordinates", ".obj");
    WriteTargets targets = targetsBeside(options->environment, {});
    targets.add(options->coordinates, FOOTFALL_TEXT("the coordinates"));
    CommandSession session;
    const auto environment = session.load(options->environment);
    session.end();
    if (!options->coordinates.empty()) writeFileSafely(options->coordinates, formatEnvironment(*environment));
    print(formatInfo(*environment, inspectEnvironment(*environment)));
  });
}

}  // namespace footfall::app
