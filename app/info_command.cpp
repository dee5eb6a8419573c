// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/command_session.hpp"
#include "app/commands.hpp"
#include "core/report/info.hpp"

namespace footfall::app {
using namespace detail;

void addInfoCommand(CLI::App& app) {
  const auto options = std::make_shared<EnvironmentOptions>();
  CLI::App& command = *app.add_subcommand("info", "Print what an environment holds");
  options->addTo(command);
  command.callback([options] {
    CommandSession session;
    const auto environment = session.load(*options);
    session.end();
    print(formatInfo(*environment, inspectEnvironment(*environment)));
  });
}

}  // namespace footfall::app
