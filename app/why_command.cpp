// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/base/number_text.hpp"
#include "core/report/path_report.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct WhyOptions {
  EnvironmentOptions environment;
  /// One place, or two, in the file's frame and units.
  std::array<double, 3> place{}, from{}, to{};
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

Vec3 placeGiven(const char* option, const std::array<double, 3>& p) {
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    throw InputError(std::string(option) +
                     ": takes three finite numbers; give x, y and z in the file's frame and units");
  return {p[0], p[1], p[2]};
}

/// Why no way leads from one place to another, or the one that does.
std::string explainPair(const WhyOptions& options) {
  const Vec3 from = placeGiven("--from", options.from), to = placeGiven("--to", options.to);
  std::optional<Pipeline> pipeline = options.pipeline.given();
  CommandSession session(options.threads);
  const auto environment = session.load(options.environment);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  const RunResult result = session.run(environment, *pipeline, options.pipeline);
  session.begin("looking for a way");
  RunContext& context = session.context();
  const PathFinder finder(result.mesh, &context);
  const UpAxis up = environment->up;
  PathResult path = finder.find(fromFileFrame(from, up), fromFileFrame(to, up), placeReach(*pipeline), &context);
  if (path.status == PathStatus::NotConnected) {
    session.begin("looking for what keeps the parts apart");
    const SeparationFinder separations(finder, environment, agentHeight(*pipeline, environment->metresPerUnit),
                                       agentStep(*pipeline), &context, agentGap(*pipeline));
    addSeparation(path, separations, &context);
  }
  session.end();
  if (options.json) return formatPathJson(*result.mesh, path);
  if (path.reached()) return "a way leads from the start to the target\n" + formatPath(path, up);
  std::string text = formatSeparation(*environment, path);
  if (path.status == PathStatus::StartNotWalkable)
    text += "`footfall why --at` explains why the start is not walkable\n";
  if (path.status == PathStatus::TargetNotWalkable)
    text += "`footfall why --at` explains why the target is not walkable\n";
  return text;
}

/// The text about the highest place at or under the point.
std::string explainPlace(const WhyOptions& options) {
  const Vec3 given = placeGiven("--at", options.place);
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
  CLI::App& command = *app.add_subcommand(
      "why",
      "Explain why a place is walkable or which filter rejected it, or why no way leads from one place to another");
  options->environment.addTo(command);
  CLI::Option* at =
      addPlace(command, "--at", options->place,
               "The place, in the file's frame and units: the highest triangle at or under this point counts");
  CLI::Option* from =
      addPlace(command, "--from", options->from,
               "With --to, in place of --at: report the least that is missing for a way between two places");
  CLI::Option* to = addPlace(command, "--to", options->to, "The place that no way leads to from there");
  at->required(false)->excludes(from)->excludes(to);
  from->required(false)->needs(to);
  to->required(false)->needs(from);
  options->pipeline.addTo(command, "A pipeline file",
                          "One step of the pipeline; give it once for each step. Without steps and file the default "
                          "pipeline runs");
  addThreads(command, options->threads);
  command.add_flag("--json", options->json, "Print one JSON object");
  command.callback([options, at, from] {
    if (at->empty() && from->empty()) throw InputError("--at is required, or --from and --to; give a place or two");
    print(from->empty() ? explainPlace(*options) : explainPair(*options));
  });
}

}  // namespace footfall::app
