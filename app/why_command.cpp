// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "app/command_session.hpp"
#include "app/commands.hpp"
#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct WhyOptions {
  EnvironmentOptions environment;
  std::array<double, 3> place{};  ///< in the file's frame and units
  PipelineOptions pipeline;
  int threads = 0;
  bool json = false;
};

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

/// What to say of the highest place at or under the point.
std::string explainPlace(const WhyOptions& options) {
  const Vec3 given{options.place[0], options.place[1], options.place[2]};
  if (!std::isfinite(given.x) || !std::isfinite(given.y) || !std::isfinite(given.z))
    throw InputError("--at: takes three finite numbers; give x, y and z in the file's frame and units");
  std::optional<Pipeline> pipeline = options.pipeline.given();
  CommandSession session(options.threads);
  const auto environment = session.load(options.environment);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  ResultCache cache(pipeline->steps.size() + 1);
  const RunResult result = session.run(environment, *pipeline, options.pipeline, &cache);
  RunContext& context = session.context();
  const Inspector inspector(environment, *pipeline, result.mesh, &cache, &context, options.threads);
  const auto place = inspector.placeBelow(fromFileFrame(given, environment->up));
  if (!place) throw InputError(nothingBelow(*environment, given));
  const PlaceExplanation explanation = inspector.explain(*place, &context);
  session.end();
  return options.json ? formatExplanationJson(inspector, explanation) : formatExplanation(inspector, explanation);
}

}  // namespace

void addWhyCommand(CLI::App& app) {
  const auto options = std::make_shared<WhyOptions>();
  CLI::App& command = *app.add_subcommand("why", "Tell why a place is walkable, or which filter rejected it");
  options->environment.addTo(command);
  addPlace(command, "--at", options->place,
           "The place, in the file's frame and units: the highest triangle at or under this point counts");
  options->pipeline.addTo(command, "A pipeline file",
                          "One step of the pipeline; give it once for each step. Without steps and file the default "
                          "pipeline runs");
  addThreads(command, options->threads);
  command.add_flag("--json", options->json, "Print one JSON object");
  command.callback([options] { print(explainPlace(*options)); });
}

}  // namespace footfall::app
