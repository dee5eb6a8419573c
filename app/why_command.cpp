// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/why_command.hpp"

#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/command_files.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress_bar.hpp"
#include "core/base/number_text.hpp"
#include "core/environment/up_axis.hpp"
#include "core/pipeline/runner.hpp"
#include "core/report/inspection_report.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

std::string coordinates(const Vec3& place) {
  std::string text;
  for (const double value : {place.x, place.y, place.z}) {
    if (!text.empty()) text += ' ';
    appendNumber(text, value);
  }
  return text;
}

std::string nothingBelow(const Environment& environment, const Vec3& place) {
  Vec3 low = inFileFrame(environment.vertices.front(), environment.up), high = low;
  for (const Vec3& vertex : environment.vertices) {
    const Vec3 p = inFileFrame(vertex, environment.up);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return "--at: nothing is at or under " + coordinates(place) + "; " + environment.source + " goes from " +
         coordinates(low) + " to " + coordinates(high) + ", and " + std::string(nameOf(environment.up)) +
         " is up; give a point above a floor";
}

}  // namespace

std::string explainPlace(const WhyArguments& arguments) {
  const Vec3 given{arguments.place[0], arguments.place[1], arguments.place[2]};
  if (!std::isfinite(given.x) || !std::isfinite(given.y) || !std::isfinite(given.z))
    throw InputError("--at: takes three finite numbers; give x, y and z in the file's frame and units");
  std::optional<Pipeline> pipeline = givenPipeline(arguments.pipelineFile, arguments.filters);

  ProgressBar bar(isatty(STDERR_FILENO) != 0);
  RunContext context([&bar](const RunEvent& event) { bar.show(event); });
  const InterruptWatcher watcher(context);
  std::optional<tbb::global_control> fewerThreads;
  if (arguments.threads > 0)
    fewerThreads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(arguments.threads));

  bar.begin("loading", 0);
  const auto environment = loadEnvironment(arguments.environment, &context);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  const auto enabled = std::count_if(pipeline->steps.begin(), pipeline->steps.end(),
                                     [](const PipelineStep& step) { return step.enabled; });
  bar.begin("starting", static_cast<std::size_t>(enabled));
  ResultCache cache(pipeline->steps.size() + 1);
  const RunResult result = runPipeline(environment, *pipeline, context, &cache, arguments.threads);
  const Inspector inspector(environment, *pipeline,
                            stepStates(environment, *pipeline, context, cache, arguments.threads), result.mesh,
                            context);
  const auto place = inspector.placeBelow(fromFileFrame(given, environment->up));
  if (!place) throw InputError(nothingBelow(*environment, given));
  const PlaceExplanation told = inspector.explain(*place, context);
  bar.clear();
  return arguments.json ? formatExplanationJson(inspector, told) : formatExplanation(inspector, told);
}

}  // namespace footfall::app
