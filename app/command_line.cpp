// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "app/cells_command.hpp"
#include "app/command_files.hpp"
#include "app/compare_command.hpp"
#include "app/path_command.hpp"
#include "app/run_command.hpp"
#include "app/why_command.hpp"
#include "core/environment/up_axis.hpp"
#include "core/filters/descriptor_text.hpp"
#include "core/report/info.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

CLI::IsMember upAxisNames() {
  std::vector<std::string> names;
  for (const UpAxis up : kUpAxes) names.emplace_back(nameOf(up));
  return CLI::IsMember(names, CLI::ignore_case);
}

struct EnvironmentArguments {
  std::string path;
  std::string up;
  std::optional<double> metresPerUnit;
  bool bothSides = false;
  std::vector<std::string> ignored, obstacleOnly;

  [[nodiscard]] EnvironmentChoice choice() const {
    ImportOptions options;
    options.up = upAxisFrom(up);
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
  command.add_option("--up", arguments.up, "The file's up axis; guessed from the format when left out")
      ->check(upAxisNames())
      ->type_name(kUpAxisNames);
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
  command.add_option("--up", arguments.up, "The up axis of both files; what they state, else y, when left out")
      ->check(upAxisNames())
      ->type_name(kUpAxisNames);
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

void addWhyArguments(CLI::App& command, WhyArguments& arguments) {
  command
      .add_option("--at", arguments.place,
                  "The place, in the file's frame and units: the highest triangle at or under this point counts")
      ->required()
      ->type_name("X Y Z");
  CLI::Option* pipelineFile = command.add_option("-p,--pipeline", arguments.pipelineFile, "A pipeline file");
  pipelineFile->type_name("FILE");
  command
      .add_option("--filter", arguments.filters,
                  "One step of the pipeline; give it once for each step. Without steps and file the default pipeline "
                  "runs")
      ->allow_extra_args(false)
      ->excludes(pipelineFile)
      ->type_name("STEP");
  command
      .add_option("--threads", arguments.threads, "Threads to use at most; as many as there are processors by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command.add_flag("--json", arguments.json, "Print one JSON object");
}

void checkOutput() {
  if (!std::cout.flush()) throw RunError("standard output cannot be written; check where it leads");
}

void addExportArguments(CLI::App& command, RunArguments& run) {
  const auto leaveOut = [&command](const char* name, bool& option, const char* help) {
    command.add_flag_callback(
        name, [&option] { option = false; }, help);
  };
  ExportOptions& options = run.exportOptions;
  leaveOut("--no-layers", options.layers, "Export one group of triangles in place of one for each layer");
  leaveOut("--no-connections", options.connections, "Leave out the lines where two layers meet");
  leaveOut("--no-obstacle-edges", options.obstacleEdges, "Leave out the lines of obstacle edges");
  command
      .add_option_function<std::string>(
          "--export-up", [&options](const std::string& up) { options.up = upAxisFrom(up); },
          "Up axis of an OBJ export; the environment's when left out. glTF is always Y up")
      ->check(upAxisNames())
      ->type_name(kUpAxisNames);
  command
      .add_option("--export-scale", options.scale,
                  "Multiply the coordinates of the export; 1 (the default) keeps the environment's units, in which OBJ "
                  "is exact. glTF is in metres before that")
      ->type_name("S");
}

struct PathCommand {
  PathArguments arguments;
  std::vector<double> from, to;
};

void addPathArguments(CLI::App& command, PathCommand& path) {
  PathArguments& arguments = path.arguments;
  command.add_option("--from", path.from, "Where to start, in the file's own coordinates")
      ->expected(3)
      ->required()
      ->type_name("X Y Z");
  command.add_option("--to", path.to, "Where to go")->expected(3)->required()->type_name("X Y Z");
  command
      .add_option("--reach", arguments.reach,
                  "How far above or below a place the walkable area may lie, in the file's units; less than the "
                  "clearance by default, so that a place on an obstacle is not walkable")
      ->type_name("H");
  CLI::Option* file = command.add_option("-p,--pipeline", arguments.pipelineFile, "A pipeline file");
  file->type_name("FILE");
  command.add_option("--filter", arguments.filters, "One step of the pipeline; give it once for each step")
      ->allow_extra_args(false)
      ->excludes(file)
      ->type_name("STEP");
  command
      .add_option("--threads", arguments.threads, "Threads to use at most; as many as there are processors by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command.add_option("-o,--output", arguments.output, "Write the path as a polyline to this OBJ file")
      ->type_name("PATH.obj");
  command.add_flag("--json", arguments.json, "The report as JSON");
  command.add_flag("--quiet", arguments.quiet, "No progress bar");
}

/// Prints the report; a path that ends before its target is an error all the same.
void runPathCommand(PathCommand& path, const EnvironmentArguments& environment) {
  std::copy_n(path.from.begin(), 3, path.arguments.from.begin());
  std::copy_n(path.to.begin(), 3, path.arguments.to.begin());
  path.arguments.environment = environment.choice();
  const PathOutcome outcome = findPath(path.arguments);
  std::cout << outcome.report;
  checkOutput();
  if (!outcome.failure.empty()) throw RunError(outcome.failure);
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
  runCommand->add_option("-o,--output", run.output, "Write the walkable area to this OBJ, glTF or GLB file")
      ->type_name("OUT.obj|OUT.gltf|OUT.glb");
  addExportArguments(*runCommand, run);
  runCommand->add_option("--stats", run.statistics, "Write times and counts to this file")->type_name("FILE.json");
  runCommand
      ->add_option("--trace", run.trace,
                   "Write the timeline of the run to this file, for Perfetto (ui.perfetto.dev) or chrome://tracing")
      ->type_name("FILE.json");
  runCommand->add_option("--report", run.report, "Write figures and times as one HTML file")->type_name("FILE.html");
  runCommand->add_flag("--speed-up", run.speedUp,
                       "Also run everything three times more, and three times on one thread without parallel blocks, "
                       "to tell the speed-up");
  runCommand->add_flag("--quiet", run.quiet, "No progress bar and no summary");

  WhyArguments why;
  CLI::App* whyCommand = app.add_subcommand("why", "Tell why a place is walkable, or which filter rejected it");
  addEnvironmentArguments(*whyCommand, environment);
  addWhyArguments(*whyCommand, why);

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

  PathCommand path;
  CLI::App* pathCommand = app.add_subcommand("path", "Find the shortest path between two places");
  addEnvironmentArguments(*pathCommand, environment);
  addPathArguments(*pathCommand, path);

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
  if (pathCommand->parsed()) return runPathCommand(path, environment);
  if (whyCommand->parsed()) {
    why.environment = environment.choice();
    std::cout << explainPlace(why);
  } else if (runCommand->parsed()) {
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

}  // namespace footfall::app
