// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <optional>

#include "app/command_files.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress_bar.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/worker_arena.hpp"
#include "core/io/export.hpp"
#include "core/io/gltf_export.hpp"
#include "core/pipeline/runner.hpp"
#include "core/report/export_header.hpp"
#include "core/report/html_report.hpp"
#include "core/report/run_statistics.hpp"
#include "core/report/run_trace.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::app {
using namespace detail;
namespace {

void checkTargets(const RunArguments& arguments) {
  if (!arguments.output.empty()) exportFormatOf(arguments.output);
  checkEnding(arguments.statistics, "--stats", ".json");
  checkEnding(arguments.trace, "--trace", ".json");
  checkEnding(arguments.report, "--report", ".html");
  WriteTargets targets = targetsBeside(arguments.environment, arguments.pipelineFile);
  targets.add(arguments.output, FOOTFALL_TEXT("the export"));
  targets.add(arguments.statistics, FOOTFALL_TEXT("the statistics"));
  targets.add(arguments.trace, FOOTFALL_TEXT("the timeline"));
  targets.add(arguments.report, FOOTFALL_TEXT("the report"));
  checkScale(arguments.exportOptions, {});
}

}  // namespace

std::string runAndExport(const RunArguments& arguments) {
  const Stopwatch total;
  ProgramTimes times;
  checkTargets(arguments);
  std::optional<Pipeline> pipeline = givenPipeline(arguments.pipelineFile, arguments.filters);

  ProgressBar bar(!arguments.quiet && isatty(STDERR_FILENO) != 0);
  RunContext context([&bar](const RunEvent& event) { bar.show(event); });
  const InterruptWatcher watcher(context);

  const Stopwatch loading;
  bar.begin("loading", 0);
  const std::shared_ptr<const Environment> environment =
      onThreads(arguments.threads, [&](int) { return loadEnvironment(arguments.environment, &context); });
  times.loadMs = loading.wallMs();
  if (!pipeline) pipeline = defaultPipeline(*environment);

  bar.begin("starting", static_cast<std::size_t>(std::ranges::count(pipeline->steps, true, &PipelineStep::enabled)));
  const RunResult result = runNamingFile(arguments.pipelineFile, environment, *pipeline, context, arguments.threads);

  if (!arguments.output.empty()) {
    const Stopwatch exporting;
    bar.begin("exporting", 0);
    context.checkCancelled();
    writeExport(arguments.output, *result.mesh, *environment, makeExportHeader(*pipeline), arguments.exportOptions);
    times.exportMs = exporting.wallMs();
  }
  times.totalMs = total.wallMs();
  if (arguments.speedUp) {
    bar.begin("measuring the speed-up", 0);
    times.speedUp = measureSpeedUp(environment, *pipeline, context, arguments.threads);
  }
  if (!arguments.statistics.empty()) {
    context.checkCancelled();
    writeFileSafely(arguments.statistics, formatStatistics(*environment, result, times));
  }
  if (!arguments.report.empty()) {
    context.checkCancelled();
    writeFileSafely(arguments.report, formatHtmlReport(*environment, *pipeline, result, times, {reportDate(), {}, {}}));
  }
  if (!arguments.trace.empty()) {
    context.checkCancelled();
    writeFileSafely(arguments.trace, formatTrace(result));
  }
  bar.clear();
  return arguments.quiet ? std::string() : formatSummary(*environment, result, times);
}

}  // namespace footfall::app
