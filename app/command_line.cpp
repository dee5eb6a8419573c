// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "app/cells_command.hpp"
#include "app/command_files.hpp"
#include "app/compare_command.hpp"
#include "app/run_command.hpp"
#include "core/environment/info.hpp"
#include "core/errors.hpp"
#include "core/filters/descriptor_text.hpp"

namespace footfall {
namespace {

struct EnvironmentArguments {
  std::string path;
  std::string up;
  std::optional<double> metresPerUnit;
  bool bothSides = false;
  std::vector<std::string> ignored, obstacleOnly;

  [[nodiscard]] EnvironmentChoice choice() const {
    ImportOptions options;
    if (!up.empty()) options.up = up == "y" ? UpAxis::Y : UpAxis::Z;
    if (metresPerUnit && !(std::isfinite(*metresPerUnit) && *metresPerUnit > 0)) {
      throw InputError("--scale: must be the metres in one unit of the file; give a number above 0");
    }
    options.metresPerUnit = metresPerUnit;
    options.bothSides = bothSides;
    return {path, options, ignored, obstacleOnly};
  }
};

void addEnvironmentArguments(CLI::App& command, EnvironmentArguments& arguments) {
  command.add_option("ENV", arguments.path, "The environment: OBJ, glTF, FBX, PLY, STL or another mesh file")
      ->required();
  command.add_option("--up", arguments.up, "The file's up axis, y or z; guessed from the format when left out")
      ->check(CLI::IsMember({"y", "z"}, CLI::ignore_case))
      ->type_name("y|z");
  command.add_option("--scale", arguments.metresPerUnit, "Metres in one unit of the file; guessed when left out")
      ->type_name("METRES");
  command.add_flag("--both-sides", arguments.bothSides,
                   "Take both sides of every triangle as its upper side, for files with unreliable winding");
  command
      .add_option("--ignore", arguments.ignored,
                  "A mesh, a material or MESH/MATERIAL to leave out altogether; give it once for each. `footfall info` "
                  "lists the names")
      ->allow_extra_args(false)
      ->type_name("NAME");
  command
      .add_option("--obstacle-only", arguments.obstacleOnly,
                  "A mesh, a material or MESH/MATERIAL that is an obstacle, but never walkable; give it once for each")
      ->allow_extra_args(false)
      ->type_name("NAME");
}

void printFilters(const std::string& name, bool markdown) {
  if (markdown) {
    std::cout << filtersMarkdown();
  } else if (name.empty()) {
    std::cout << listFilters();
  } else if (const FilterDescriptor* filter = findFilter(name)) {
    std::cout << describeFilter(*filter);
  } else {
    throw InputError("unknown filter \"" + name + "\"; did you mean " + std::string(nearestFilterName(name)) + '?');
  }
}

void printInfo(const EnvironmentArguments& arguments) {
  const auto environment = loadEnvironment(arguments.choice());
  std::cout << formatInfo(*environment, inspectEnvironment(*environment));
}

void addCompareArguments(CLI::App& command, CompareArguments& arguments) {
  command
      .add_option("A", arguments.files[0], "The ground truth: an OBJ file that `footfall run -o` wrote, or any other")
      ->required();
  command.add_option("B", arguments.files[1], "The OBJ file to hold against it")->required();
  command
      .add_option("--height", arguments.options.height,
                  "How far apart in height two surfaces still cover each other, in the files' units; nearly nothing "
                  "by default")
      ->type_name("H");
  command
      .add_option("--error", arguments.options.error,
                  "How exactly to bound the Hausdorff distances, in the files' units; a thousandth of the diagonal "
                  "by default")
      ->type_name("E");
  command.add_option("--up", arguments.up, "The up axis of both files, y or z; what they state, else y, when left out")
      ->check(CLI::IsMember({"y", "z"}, CLI::ignore_case))
      ->type_name("y|z");
  command.add_flag("--json", arguments.json, "Print one JSON object");
  command.add_flag("--fail-if-different", arguments.failIfDifferent,
                   "Exit with 1 unless both are the same set of points, exactly");
  command
      .add_option("--fail-above", arguments.failAbove,
                  "Exit with 1 when more than this area of one, in the plan, is not covered by the other")
      ->type_name("AREA");
  command
      .add_option("--threads", arguments.threads, "Threads to use at most; as many as there are processors by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command.add_flag("--quiet", arguments.quiet, "No progress bar");
}

void checkOutput() {
  if (!std::cout.flush()) throw RunError("standard output cannot be written; check where it leads");
}

}  // namespace

void runCommandLine(int argc, const char* const* argv) {
  CLI::App app("Computes the exact walkable area of 3D environments.", "footfall");
  app.set_version_flag("--version", "footfall " FOOTFALL_VERSION, "Print the version and exit");
  app.require_subcommand(1);

  EnvironmentArguments environment;
  RunArguments run;
  CLI::App* runCommand = app.add_subcommand("run", "Run a pipeline over an environment");
  addEnvironmentArguments(*runCommand, environment);
  CLI::Option* pipelineFile = runCommand->add_option("-p,--pipeline", run.pipelineFile, "A pipeline file");
  pipelineFile->type_name("FILE");
  runCommand
      ->add_option("--filter", run.filters,
                   "One step, such as \"SlopeFilter 45\"; give it once for each step. Without steps and file the "
                   "default pipeline runs")
      ->allow_extra_args(false)
      ->excludes(pipelineFile)
      ->type_name("STEP");
  runCommand->add_option("--threads", run.threads, "Threads to use at most; as many as there are processors by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  runCommand->add_option("-o,--output", run.output, "Write the walkable area to this OBJ file")->type_name("OUT.obj");
  runCommand->add_option("--stats", run.statistics, "Write times and counts to this file")->type_name("FILE.json");
  runCommand
      ->add_option("--trace", run.trace,
                   "Write the timeline of the run to this file, for Perfetto (ui.perfetto.dev) or chrome://tracing")
      ->type_name("FILE.json");
  runCommand->add_flag("--speed-up", run.speedUp,
                       "Also run everything three times more, and three times on one thread without parallel blocks, "
                       "to tell the speed-up");
  runCommand->add_flag("--quiet", run.quiet, "No progress bar and no summary");

  CLI::App* infoCommand = app.add_subcommand("info", "Tell what an environment holds");
  addEnvironmentArguments(*infoCommand, environment);

  CellsArguments cells;
  CLI::App* cellsCommand =
      app.add_subcommand("cells", "Tell into which cells a strategy divides an environment, without running filters");
  addEnvironmentArguments(*cellsCommand, environment);
  cellsCommand
      ->add_option("--strategy", cells.strategy,
                   "The strategy, such as \"GridStrategy 3 2\"; the pipeline's first, else AutoStrategy, when left out")
      ->type_name("STEP");
  CLI::Option* cellsPipeline = cellsCommand->add_option(
      "-p,--pipeline", cells.pipelineFile, "A pipeline file: strategies look at the clearance of its filters");
  cellsPipeline->type_name("FILE");
  cellsCommand->add_option("--filter", cells.filters, "One step of the pipeline; give it once for each step")
      ->allow_extra_args(false)
      ->excludes(cellsPipeline)
      ->type_name("STEP");
  cellsCommand
      ->add_option("--threads", cells.threads, "Threads to plan for; as many as there are processors by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  cellsCommand->add_option("-o,--output", cells.output, "Write the environment, cut along the cells, to this OBJ file")
      ->type_name("CELLS.obj");
  cellsCommand->add_flag("--json", cells.json, "The report as JSON");

  CompareArguments compare;
  CLI::App* compareCommand = app.add_subcommand("compare", "Tell how two navigation meshes differ");
  addCompareArguments(*compareCommand, compare);

  std::string filterName;
  bool markdown = false;
  CLI::App* filtersCommand = app.add_subcommand("filters", "List the filters, or tell all about one");
  CLI::Option* filterNameOption = filtersCommand->add_option("NAME", filterName, "A filter's name");
  filtersCommand->add_flag("--markdown", markdown, "The whole reference as Markdown")->excludes(filterNameOption);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) {
      throw InputError(std::string(error.what()) + "; `footfall --help` tells what can be given");
    }
    app.exit(error);  // --help and --version
    checkOutput();
    return;
  }

  if (compareCommand->parsed()) {
    const CompareOutcome outcome = compareFiles(compare);
    std::cout << outcome.report;
    checkOutput();
    if (!outcome.difference.empty()) throw RunError(outcome.difference);
    return;
  }
  if (runCommand->parsed()) {
    run.environment = environment.choice();
    std::cout << runAndExport(run);
  } else if (cellsCommand->parsed()) {
    cells.environment = environment.choice();
    std::cout << previewCells(cells);
  } else if (infoCommand->parsed()) {
    printInfo(environment);
  } else {
    printFilters(filterName, markdown);
  }
  checkOutput();
}

}  // namespace footfall
