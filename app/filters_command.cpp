// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/filters/descriptor_text.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"

namespace footfall::app {
using namespace detail;

void addFiltersCommand(CLI::App& app) {
  struct Options {
    std::string name;
    bool markdown = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("filters", "List the filters, or describe one");
  CLI::Option* name = command.add_option("NAME", options->name, "A filter's name");
  command.add_flag("--markdown", options->markdown, "The whole reference as Markdown")->excludes(name);
  command.callback([options] {
    if (options->markdown) return print(filtersMarkdown());
    if (options->name.empty()) return print(listFilters());
    if (const FilterDescriptor* filter = findFilter(options->name)) return print(describeFilter(*filter));
    throw InputError("unknown filter \"" + options->name + "\"; did you mean " +
                     std::string(nearestFilterName(options->name)) + '?');
  });
}

}  // namespace footfall::app
