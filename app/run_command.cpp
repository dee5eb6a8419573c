// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "app/command_session.hpp"
#include "app/commands.hpp"
#include "app/run_program.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/inspect/parameter_check.hpp"
#include "core/io/export.hpp"
#include "core/io/formats/save.hpp"
#include "core/report/html_report.hpp"
#include "core/report/run_trace.hpp"
#include "core/report/speed_up.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct RunOptions {
  EnvironmentOptions environment;
  PipelineOptions pipeline;
  int threads = 0;
  std::string output;  ///< in one of exportFormats(); empty, as the next ones: not written
  ExportOptions exported;
  std::string exportUp;
  std::uint32_t part = 0;  ///< from 1; 0: all
  std::string statistics, trace, report;
  bool speedUp = false;
  bool quiet = false;
};

void addExportOptions(CLI::App& command, RunOptions& options) {
  ExportOptions& exported = options.exported;
  const auto leaveOut = [&command](const char* name, bool& part, const char* help) {
    command.add_flag_callback(
        name, [&part] { part = false; }, help);
  };
  leaveOut("--no-layers", exported.layers, "Export one group of triangles in place of one for each layer");
  leaveOut("--no-connections", exported.connections, "Leave out the lines where two layers meet");
  leaveOut("--no-obstacle-edges", exported.obstacleEdges, "Leave out the lines of obstacle edges");
  leaveOut("--no-steps", exported.steps, "Leave out the faces of steps");
  leaveOut("--no-drops", exported.drops, "Leave out the lines of drops");
  addUpAxis(command, "--export-up", options.exportUp,
            "Up axis of an OBJ export; the environment's when left out. All other formats have one");
  command
      .add_option("--export-scale", exported.scale,
                  "Multiply the coordinates of the export; 1 (the default) keeps the environment's units, in which OBJ "
                  "is exact. All other formats are in metres before that")
      ->type_name("S");
  command.add_option("--godot", exported.godot, "The version of Godot that is to read a .tres: 4 (the default) or 3")
      ->check(CLI::IsMember({3, 4}))
      ->type_name("VERSION");
  command.add_flag("--navmesh-node", exported.navmeshNode,
                   "Of glTF: one mesh, whose node is \"walkable-navmesh\", which Godot imports as a navigation region");
  addPolygonOptions(command, options.part, exported.coordinateSystem);
}

/// ".obj: OBJ, ...", a line for each format.
std::string formatHelp() {
  std::string help = "Write the walkable area to this file; its ending chooses the format:";
  for (const FormatDescriptor& format : exportFormats())
    help.append(&format == &exportFormats().front() ? "\n" : ";\n")
        .append(format.ending)
        .append("  ")
        .append(Text(format.name).str());
  return help;
}

/// What is in the result and the file does not hold, in one line on stderr.
void printLosses(const NavigationMesh& mesh, const RunOptions& options, double error) {
  const Text lost = lossesOf(exportFormatOf(options.output), mesh, options.exported);
  std::string line = lost.empty() ? std::string() : "the format cannot hold " + lost.str();
  // What nobody sees is not told: floats are a tenth of a millimetre apart at 1 km.
  if (error > 0.0005) {
    line += line.empty() ? "" : "; ";
    line += formatted(error * 1000, "rounding to floats moved coordinates by up to %.3g mm");
  }
  if (!line.empty()) std::cerr << "footfall: note: " << options.output << ": " << line << '\n';
}

/// The export's own files among them, as far as they are known: layers of polygons are counted by the run.
WriteTargets checkTargets(const RunOptions& options) {
  if (!options.output.empty()) {
    checkReplaced(options.output);
    checkOptions(exportFormatOf(options.output), options.exported);
  }
  checkEnding(options.statistics, "--stats", ".json");
  checkEnding(options.trace, "--trace", ".json");
  checkEnding(options.report, "--report", ".html");
  WriteTargets targets = targetsBeside(options.environment, options.pipeline);
  targets.add(options.output, FOOTFALL_TEXT("the export"));
  targets.add(options.statistics, FOOTFALL_TEXT("the statistics"));
  targets.add(options.trace, FOOTFALL_TEXT("the timeline"));
  targets.add(options.report, FOOTFALL_TEXT("the report"));
  checkScale(options.exported, {});
  return targets;
}

/// Returns by how much rounding moved coordinates, in metres.
double writeExport(const RunOptions& options, const NavigationMesh& mesh, const Pipeline& pipeline,
                   const WriteTargets& targets, const RunContext& context) {
  const ExportFiles made = formatExport(exportFormatOf(options.output), options.output, mesh,
                                        makeExportHeader(pipeline), options.exported, {}, context);
  for (const OutputFile& file : made.files) targets.check(file.path);
  checkReplaced(options.output);
  writeFilesSafely(made.files, context);
  return made.largestError;
}

/// What the numbers of the pipeline will do to the level that nobody wants, on stderr.
void printNotes(const Environment& environment, const Pipeline& pipeline, CommandSession& session) {
  session.begin("checking");
  const std::vector<ParameterNote> notes = checkParameters(measureLevel(environment, session.context()), pipeline);
  session.end();
  for (const ParameterNote& note : notes) {
    const std::string step = note.step ? formatStep(pipeline.steps[*note.step]) + ": " : std::string("--scale: ");
    std::cerr << "footfall: note: " << step << note.text.str() << '\n';
  }
}

/// Returns the summary for stdout, empty when quiet.
std::string runAndExport(const RunOptions& options, CommandSession& session, RunProgram& program) {
  const Stopwatch total;
  ProgramTimes times;
  const WriteTargets targets = program.writes() ? checkTargets(options) : WriteTargets();
  std::optional<Pipeline> pipeline = options.pipeline.given();
  RunContext& context = session.context();

  const Stopwatch loading;
  const std::shared_ptr<const Environment> environment = session.load(options.environment);
  times.loadMs = loading.wallMs();
  if (!pipeline) pipeline = defaultPipeline(*environment);
  if (!options.quiet) printNotes(*environment, *pipeline, session);
  const RunResult result = program.run(session, environment, *pipeline, options.pipeline, times.loadMs);
  if (!program.writes()) return {};

  if (!options.output.empty()) {
    const Stopwatch exporting;
    session.begin("exporting");
    context.checkCancelled();
    const double error = writeExport(options, *result.mesh, *pipeline, targets, context);
    times.exportMs = exporting.wallMs();
    session.end();
    if (!options.quiet) printLosses(*result.mesh, options, error);
  }
  times.totalMs = total.wallMs();
  if (options.speedUp) {
    session.begin("measuring the speed-up");
    times.speedUp = measureSpeedUp(environment, *pipeline, context, options.threads);
  }
  const auto write = [&context](const std::string& path, const auto& format) {
    if (path.empty()) return;
    context.checkCancelled();
    writeFileSafely(path, format());
  };
  write(options.statistics, [&] { return program.statistics(formatStatistics(*environment, result, times)); });
  write(options.report, [&] {
    return formatHtmlReport(*environment, *pipeline, result, times, {reportDate(), {}, {}});
  });
  write(options.trace, [&] { return program.trace(formatTrace(result)); });
  session.end();
  return options.quiet ? std::string() : program.summary(formatSummary(*environment, result, times));
}

void runAs(RunProgram& program, RunOptions& options) {
  options.exported.up = upAxisFrom(options.exportUp);
  if (options.part > 0) options.exported.part = options.part - 1;
  program.begin(options.threads);
  options.quiet = options.quiet || !program.writes();
  CommandSession session(options.threads, options.quiet, program.showsProgress());
  program.setContext(&session.context());
  const auto forget = [](RunProgram* running) { running->setContext(nullptr); };
  const std::unique_ptr<RunProgram, decltype(forget)> forgotten(&program, forget);
  print(runAndExport(options, session, program));
  program.end();
}

}  // namespace

void addRunCommand(CLI::App& app, RunProgram& program) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = *app.add_subcommand("run", "Run a pipeline over an environment");
  options->environment.addTo(command);
  options->pipeline.addTo(command, "A pipeline file",
                          "One step, such as \"SlopeFilter 45\"; give it once for each step. Without steps and file "
                          "the default pipeline runs");
  addThreads(command, options->threads);
  command.add_option("-o,--output", options->output, formatHelp())->type_name("OUT");
  addExportOptions(command, *options);
  command.add_option("--stats", options->statistics, "Write times, counts and components to this file")
      ->type_name("FILE.json");
  command
      .add_option("--trace", options->trace,
                  "Write the timeline of the run to this file, for Perfetto (ui.perfetto.dev) or chrome://tracing")
      ->type_name("FILE.json");
  command.add_option("--report", options->report, "Write figures and times as one HTML file")->type_name("FILE.html");
  command.add_flag("--speed-up", options->speedUp,
                   "Also run everything three times more, and three times on one thread without parallel blocks, to "
                   "tell the speed-up");
  command.add_flag("--quiet", options->quiet, "No progress bar, no notes and no summary");
  program.addOptions(command);
  command.callback([options, &program] { runAs(program, *options); });
}

}  // namespace footfall::app
