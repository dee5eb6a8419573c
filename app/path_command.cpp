// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/path_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "app/command_files.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress_bar.hpp"
#include "core/base/worker_arena.hpp"
#include "core/environment/up_axis.hpp"
#include "core/navigation/path_finder.hpp"
#include "core/navigation/place_reach.hpp"
#include "core/pipeline/runner.hpp"
#include "core/report/export_header.hpp"
#include "core/report/path_report.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

void checkArguments(const PathArguments& arguments) {
  checkEnding(arguments.output, "-o", ".obj");
  targetsBeside(arguments.environment, arguments.pipelineFile).add(arguments.output, FOOTFALL_TEXT("the path"));
  for (const auto& [option, p] : {std::pair{"--from", arguments.from}, std::pair{"--to", arguments.to}})
    for (const double x : p)
      if (!std::isfinite(x)) throw InputError(std::string(option) + ": takes three finite numbers; give X Y Z");
  if (arguments.reach && !(*arguments.reach >= 0))
    throw InputError("--reach: must be a height in the file's units; give a number that is not negative");
}

Vec3 turned(const std::array<double, 3>& p, UpAxis up) { return fromFileFrame({p[0], p[1], p[2]}, up); }

}  // namespace

PathOutcome findPath(const PathArguments& arguments) {
  checkArguments(arguments);
  std::optional<Pipeline> pipeline = givenPipeline(arguments.pipelineFile, arguments.filters);
  ProgressBar bar(!arguments.quiet && isatty(STDERR_FILENO) != 0);
  RunContext context([&bar](const RunEvent& event) { bar.show(event); });
  const InterruptWatcher watcher(context);

  bar.begin("loading", 0);
  const std::shared_ptr<const Environment> environment =
      onThreads(arguments.threads, [&](int) { return loadEnvironment(arguments.environment, &context); });
  if (!pipeline) pipeline = defaultPipeline(*environment);
  bar.begin("starting", static_cast<std::size_t>(std::ranges::count(pipeline->steps, true, &PipelineStep::enabled)));
  const RunResult run = runNamingFile(arguments.pipelineFile, environment, *pipeline, context, arguments.threads);

  bar.begin("looking for the path", 0);
  const auto poll = [&context] { context.checkCancelled(); };
  const PathFinder finder(run.mesh, poll);
  PathResult path = finder.find(turned(arguments.from, environment->up), turned(arguments.to, environment->up),
                                arguments.reach.value_or(placeReach(*pipeline)), poll);
  if (path.status == PathStatus::NotConnected) {
    bar.begin("looking for what keeps the parts apart", 0);
    const SeparationFinder separations(*run.mesh, finder.topology(), environment,
                                       agentHeight(*pipeline, environment->metresPerUnit), poll);
    addSeparation(path, finder.topology(), separations, poll);
  }
  if (!arguments.output.empty() && path.hasPath())
    writeFileSafely(arguments.output, formatPathObj(*environment, makeExportHeader(*pipeline), path));
  bar.clear();
  return {arguments.json ? formatPathJson(*run.mesh, *environment, path) : formatPath(*environment, path),
          path.reached() ? std::string() : environment->source + ": " + formatFailure(path, environment->up)};
}

}  // namespace footfall::app
