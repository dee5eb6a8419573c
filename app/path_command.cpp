// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/io/export.hpp"
#include "core/pipeline/runner.hpp"
#include "core/report/path_report.hpp"
#include "footfall/body_path.hpp"
#include "footfall/errors.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct PathOptions {
  EnvironmentOptions environment;
  std::array<double, 3> from{}, to{};  ///< places in the file's own coordinates
  std::optional<double> reach;         ///< empty: just below the pipeline's clearance
  std::optional<double> radius;        ///< of the agent; empty: a point
  double preferredWidth = 0;           ///< BodyPathOptions::preferredWidth
  bool isWidest = false;
  PipelineOptions pipeline;
  int threads = 0;
  std::string output;  ///< empty: no OBJ
  bool json = false;
  bool quiet = false;
};

void checkOptions(const PathOptions& options) {
  checkEnding(options.output, "-o", ".obj");
  targetsBeside(options.environment, options.pipeline).add(options.output, FOOTFALL_TEXT("the path"));
  for (const auto& [option, p] : {std::pair{"--from", options.from}, std::pair{"--to", options.to}})
    for (const double x : p)
      if (!std::isfinite(x)) throw InputError(std::string(option) + ": takes three finite numbers; give X Y Z");
  if (options.reach && !(*options.reach >= 0))
    throw InputError("--reach: must be a height in the file's units; give a number that is not negative");
  if (options.radius && !(std::isfinite(*options.radius) && *options.radius > 0))
    throw InputError("--radius: must be a length in the file's units; give a number above 0");
  if (!(options.preferredWidth >= 0))
    throw InputError("--prefer-width: must be a width in the file's units; give a number that is not negative");
}

Vec3 turned(const std::array<double, 3>& p, UpAxis up) { return fromFileFrame({p[0], p[1], p[2]}, up); }

void writePath(const PathOptions& options, const Environment& environment, const Pipeline& pipeline,
               const PathResult& path, RunContext& context) {
  if (!options.output.empty() && path.hasPath())
    writeFileSafely(options.output, formatPathObj(environment.frame(), makeExportHeader(pipeline), path), context);
}

/// The path of an agent with a radius, on the corridor map.
void findBodyPath(const PathOptions& options, const Environment& environment, const Pipeline& pipeline,
                  const RunResult& run, CommandSession& session) {
  session.begin("making the corridor map");
  RunContext& context = session.context();
  const BodyPathFinder finder(run.mesh, &context);
  session.begin("looking for the path");
  const double widest = std::numeric_limits<double>::infinity();
  const BodyPath path =
      finder.find(turned(options.from, environment.up), turned(options.to, environment.up),
                  {.radius = *options.radius, .preferredWidth = options.isWidest ? widest : options.preferredWidth},
                  options.reach.value_or(placeReach(pipeline)), &context);
  if (path.reached()) writePath(options, environment, pipeline, path.path, context);
  session.end();
  print(options.json ? formatPathJson(*run.mesh, path) : formatPath(path, environment.up));
  if (!path.reached()) throw RunError(environment.source + ": " + formatFailure(path, environment.up));
}

/// Prints the report; a path that ends before its target is an error all the same.
void findPath(const PathOptions& options) {
  checkOptions(options);
  std::optional<Pipeline> pipeline = options.pipeline.given();
  CommandSession session(options.threads, options.quiet);
  const std::shared_ptr<const Environment> environment = session.load(options.environment);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  const RunResult run = session.run(environment, *pipeline, options.pipeline);

  if (options.radius) {
    findBodyPath(options, *environment, *pipeline, run, session);
    return;
  }
  session.begin("looking for the path");
  RunContext& context = session.context();
  const PathFinder finder(run.mesh, &context);
  PathResult path = finder.find(turned(options.from, environment->up), turned(options.to, environment->up),
                                options.reach.value_or(placeReach(*pipeline)), &context);
  if (path.status == PathStatus::NotConnected) {
    session.begin("looking for what keeps the parts apart");
    const SeparationFinder separations(finder, environment, agentHeight(*pipeline, environment->metresPerUnit),
                                       agentStep(*pipeline), &context, agentGap(*pipeline));
    addSeparation(path, separations, &context);
  }
  writePath(options, *environment, *pipeline, path, context);
  session.end();
  print(options.json ? formatPathJson(*run.mesh, path) : formatPath(path, environment->up));
  if (!path.reached()) throw RunError(environment->source + ": " + formatFailure(path, environment->up));
}

}  // namespace

void addPathCommand(CLI::App& app) {
  const auto options = std::make_shared<PathOptions>();
  CLI::App& command = *app.add_subcommand("path", "Find the shortest path between two places");
  options->environment.addTo(command);
  addPlace(command, "--from", options->from, "Where to start, in the file's own coordinates");
  addPlace(command, "--to", options->to, "Where to go");
  command
      .add_option("--reach", options->reach,
                  "The largest height of the walkable area above or below a place, in the file's units; less than the "
                  "clearance by default, so that a place on an obstacle is not walkable")
      ->type_name("H");
  CLI::Option* const radius =
      command
          .add_option(
              "--radius", options->radius,
              "The agent's radius, in the file's units: the path keeps this distance from every border. Needs no "
              "RadiusFilter, and takes no drops")
          ->type_name("R");
  CLI::Option* const preferred =
      command
          .add_option("--prefer-width", options->preferredWidth,
                      "With --radius: keep to passages as wide as possible, up to this width, in the file's units")
          ->type_name("W")
          ->needs(radius);
  command.add_flag("--widest", options->isWidest, "With --radius: take the way whose narrowest passage is widest")
      ->needs(radius)
      ->excludes(preferred);
  options->pipeline.addTo(command, "A pipeline file", "One step of the pipeline; give it once for each step");
  addThreads(command, options->threads);
  command.add_option("-o,--output", options->output, "Write the path as a polyline to this OBJ file")
      ->check(hasName())
      ->type_name("PATH.obj");
  command.add_flag("--json", options->json, "Print the report as JSON");
  command.add_flag("--quiet", options->quiet, "No progress bar");
  command.callback([options] { findPath(*options); });
}

}  // namespace footfall::app
