// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "app/agents_run.hpp"
#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "app/export_options.hpp"
#include "app/run_program.hpp"
#include "app/tile_command.hpp"
#include "core/base/background_release.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/inspect/parameter_check.hpp"
#include "core/io/export.hpp"
#include "core/report/bottleneck_statistics.hpp"
#include "core/report/html_report.hpp"
#include "core/report/run_trace.hpp"
#include "core/report/speed_up.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct RunOptions {
  EnvironmentOptions environment;
  PipelineOptions pipeline;
  int threads = 0;
  ExportCommandOptions exported;
  std::uint64_t memory = 0;  ///< bytes that may be held at once; 0: as many as it takes
  std::string slice;         ///< "K/N", or empty
  std::string statistics, trace, report;
  std::string agents;        ///< names or a file; empty: the pipeline's agent
  bool bottlenecks = false;  ///< in statistics and report
  bool speedUp = false;
  bool quiet = false;
};

/// The targets include the export's own files as far as they are known. The number of layer files is known only after
/// the run.
WriteTargets checkTargets(const RunOptions& options) {
  options.exported.check();
  checkEnding(options.statistics, "--stats", ".json");
  checkEnding(options.trace, "--trace", ".json");
  checkEnding(options.report, "--report", ".html");
  if (options.bottlenecks && options.statistics.empty() && options.report.empty())
    throw InputError("--bottlenecks: are written into the report and the statistics; give --report or --stats too");
  WriteTargets targets = targetsBeside(options.environment, options.pipeline);
  targets.add(options.exported.output, FOOTFALL_TEXT("the export"));
  targets.add(options.statistics, FOOTFALL_TEXT("the statistics"));
  targets.add(options.trace, FOOTFALL_TEXT("the timeline"));
  targets.add(options.report, FOOTFALL_TEXT("the report"));
  return targets;
}

/// Prints notes on stderr about parameters whose effect on the level is probably not intended.
void printNotes(const Environment& environment, const Pipeline& pipeline, CommandSession& session) {
  session.begin("checking");
  const std::vector<ParameterNote> notes = checkParameters(measureLevel(environment, session.context()), pipeline);
  session.end();
  for (const ParameterNote& note : notes) {
    const std::string about = note.step       ? formatStep(pipeline.steps[*note.step])
                              : note.isOnGrid ? std::string("--grid")
                                              : std::string("--scale");
    std::cerr << "footfall: note: " << about << ": " << note.text.str() << '\n';
  }
}

/// Empty unless bottlenecks are asked for.
std::optional<CorridorMap> corridorsOf(const RunOptions& options, const NavigationMesh& mesh, CommandSession& session) {
  if (!options.bottlenecks) return std::nullopt;
  session.begin("making the corridor map");
  std::optional<CorridorMap> map = makeCorridorMap(mesh, {}, &session.context());
  session.end();
  return map;
}

/// Returns the summary for stdout, empty when quiet.
std::string runAndExport(const RunOptions& options, CommandSession& session, RunProgram& program) {
  keepFreedMemory();
  const Stopwatch total;
  ProgramTimes times;
  const WriteTargets targets = program.writes() ? checkTargets(options) : WriteTargets();
  std::optional<Pipeline> pipeline = options.pipeline.given(&session.context());
  RunContext& context = session.context();

  const Stopwatch loading;
  const std::shared_ptr<const Environment> environment = session.load(options.environment);
  times.loadMs = loading.wallMs();
  if (!pipeline) pipeline = defaultPipeline(*environment);
  if (!options.quiet) printNotes(*environment, *pipeline, session);
  const RunResult result = program.run(session, environment, *pipeline, options.pipeline, times.loadMs);
  if (!program.writes()) return {};

  if (!options.exported.output.empty()) {
    const Stopwatch exporting;
    session.begin("exporting");
    context.checkCancelled();
    const double error = writeExport(options.exported, *result.mesh, *pipeline, targets, context);
    times.exportMs = exporting.wallMs();
    session.end();
    if (!options.quiet) printLosses(*result.mesh, options.exported, error);
  }
  times.totalMs = total.wallMs();
  if (options.speedUp) {
    session.begin("measuring the speed-up");
    times.speedUp = measureSpeedUp(environment, *pipeline, context, options.threads);
  }
  const std::optional<CorridorMap> corridors = corridorsOf(options, *result.mesh, session);
  const auto write = [&context](const std::string& path, const auto& format) {
    if (path.empty()) return;
    context.checkCancelled();
    writeFileSafely(path, format(), context);
  };
  write(options.statistics, [&] {
    const std::string statistics = program.statistics(formatStatistics(*environment, result, times));
    return corridors ? addBottlenecks(statistics, *corridors) : statistics;
  });
  write(options.report, [&] {
    return formatHtmlReport(*environment, *pipeline, result, times,
                            {reportDate(), {}, {}, corridors ? &*corridors : nullptr});
  });
  write(options.trace, [&] { return program.trace(formatTrace(result)); });
  session.end();
  return options.quiet ? std::string() : program.summary(formatSummary(*environment, result, times));
}

void runWithin(const RunOptions& options, RunProgram& program, CommandSession& session) {
  runIntoFolder({options.environment, options.pipeline, options.exported.output, options.statistics, options.memory,
                 options.slice, options.threads, options.quiet},
                program, session);
}

void runAs(RunProgram& program, RunOptions& options, bool isWithin) {
  options.exported.finish();
  program.begin(options.threads);
  options.quiet = options.quiet || !program.writes();
  CommandSession session(options.threads, options.quiet, program.showsProgress());
  program.setContext(&session.context());
  const auto forget = [](RunProgram* running) { running->setContext(nullptr); };
  const std::unique_ptr<RunProgram, decltype(forget)> forgotten(&program, forget);
  if (!options.agents.empty())
    print(
        runAgents({options.environment, options.agents, options.exported, options.statistics, options.quiet}, session));
  else if (isWithin)
    runWithin(options, program, session);
  else
    print(runAndExport(options, session, program));
  program.end();
}

/// The other options that say what runs, or show one run, mean nothing with several.
void addAgents(CLI::App& command, RunOptions& options) {
  CLI::Option* agents =
      command
          .add_option(
              "--agents", options.agents,
              "Write a result for each of several agents, OUT-NAME: names of known agents, separated by commas "
              "(Human, Wheelchair, ...), or a JSON file that lists agents, such as a session of the editor. What "
              "they have in common is computed once; --stats says what each added")
          ->check(hasName())
          ->type_name("FILE|NAME,...");
  for (const char* name : {"--pipeline", "--filter", "--trace", "--report", "--bottlenecks", "--speed-up", "--memory"})
    agents->excludes(command.get_option(name));
}

/// Tiles are no export: what is said of one is said when they are joined.
CLI::Option* addMemory(CLI::App& command, RunOptions& options) {
  CLI::Option* memory =
      command
          .add_option("--memory", options.memory,
                      "Use at most this much memory in each process (K, M and G behind the number mean 2^10, 2^20 and "
                      "2^30 bytes), and write tiles into the folder OUT, for `footfall join`. The pipeline may have "
                      "local filters, then a StepFilter, AreaFilters, SimplificationFilter and LayerSubdivisionFilter, "
                      "as the default pipeline does")
          ->transform(CLI::AsSizeValue(false))
          ->type_name("BYTES");
  command
      .add_option("--slice", options.slice,
                  "With --memory: run only the K-th of N slices, as one job of a queue; `footfall join` takes the "
                  "folders of all slices")
      ->needs(memory)
      ->type_name("K/N");
  for (const std::string& name : ExportCommandOptions::names()) memory->excludes(command.get_option(name));
  for (const char* name : {"--trace", "--report", "--bottlenecks", "--speed-up"})
    memory->excludes(command.get_option(name));
  return memory;
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
  options->exported.addTo(command, ". With --memory, the folder of the tiles");
  command.add_option("--stats", options->statistics, "Write times, counts and components to this file")
      ->check(hasName())
      ->type_name("FILE.json");
  command
      .add_option("--trace", options->trace,
                  "Write the timeline of the run to this file, for Perfetto (ui.perfetto.dev) or chrome://tracing")
      ->check(hasName())
      ->type_name("FILE.json");
  command.add_option("--report", options->report, "Write figures and times as one HTML file")
      ->check(hasName())
      ->type_name("FILE.html");
  command.add_flag("--bottlenecks", options->bottlenecks,
                   "Write the narrowest passages into the report and the statistics; the corridor map, which `footfall "
                   "corridors` writes, takes a while on large levels");
  command.add_flag("--speed-up", options->speedUp,
                   "Also run everything three more times, and three times on one thread without parallel blocks, and "
                   "report the speed-up");
  command.add_flag("--quiet", options->quiet, "No progress bar, no notes and no summary");
  const CLI::Option* memory = addMemory(command, *options);
  if (!program.isForOnePipeline()) addAgents(command, *options);
  program.addOptions(command);
  command.callback([options, &program, memory] { runAs(program, *options, memory->count() > 0); });
}

}  // namespace footfall::app
