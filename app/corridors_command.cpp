// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/number_text.hpp"
#include "core/io/export.hpp"
#include "core/navigation/bottleneck_list.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct CorridorsOptions {
  EnvironmentOptions environment;
  PipelineOptions pipeline;
  std::optional<double> narrowerThan;          ///< in the file's units
  std::optional<double> widerThan;             ///< in the file's units; empty: kNarrowestPassage
  double prominence = 100 * kUsualProminence;  ///< in percent
  CorridorOptions map;
  std::string output;  ///< empty: no file
  int threads = 0;
  bool quiet = false;
};

bool isGeoJson(const std::string& path) { return path.ends_with(".geojson"); }
bool isGlb(const std::string& path) { return path.ends_with(".glb"); }

std::string contentFor(const std::string& path, const CorridorMap& map) {
  if (isGlb(path)) return formatCorridorsGlb(map);
  return isGeoJson(path) ? formatCorridorsGeoJson(map) : formatCorridorsJson(map);
}

void checkCorridors(const CorridorsOptions& options) {
  if (!options.output.empty() && !isGeoJson(options.output) && !isGlb(options.output))
    checkEnding(options.output, "-o", ".json");
  targetsBeside(options.environment, options.pipeline).add(options.output, FOOTFALL_TEXT("the corridor map"));
  if (options.narrowerThan && !(std::isfinite(*options.narrowerThan) && *options.narrowerThan > 0))
    throw InputError("--narrower-than: must be a width in the file's units; give a number above 0");
  if (options.widerThan && !(std::isfinite(*options.widerThan) && *options.widerThan >= 0))
    throw InputError("--wider-than: must be a width in the file's units; give a number that is not negative");
  if (!(std::isfinite(options.prominence) && options.prominence >= 0))
    throw InputError("--prominence: must be a share in percent; give a number that is not negative");
}

/// Lengths to six digits, which are enough to read.
std::string shownNumber(double x) {
  std::string text;
  appendNumber(text, std::fabs(x) < 1e9 ? std::round(x * 1e6) / 1e6 : x);
  return text;
}

std::string shownAt(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  return shownNumber(q.x) + ' ' + shownNumber(q.y) + ' ' + shownNumber(q.z);
}

/// One line: how wide, where, between which places, and what is behind it on either side.
std::string lineOf(const Bottleneck& b, const CorridorMap& map) {
  const UpAxis up = map.frame.up;
  std::string text = "width " + shownNumber(b.width) + " at " + shownAt(b.place, up) + ", from " + shownAt(b.left, up) +
                     " to " + shownAt(b.right, up) + "; leads to widths of " +
                     shownNumber(map.vertices[b.sides[0].widest].width) + " and " +
                     shownNumber(map.vertices[b.sides[1].widest].width);
  if (b.isOnlyWay)
    text += "; the only way between areas of " + shownNumber(b.sides[0].area) + " and " + shownNumber(b.sides[1].area);
  return text + '\n';
}

/// Says how many bottlenecks the list leaves out, and why; empty where it leaves out none.
std::string leftOut(std::size_t slits, const std::string& least, std::size_t shallow, const std::string& percent) {
  std::string text;
  if (slits > 0) text += "; left out: " + std::to_string(slits) + ", at most " + least + " wide";
  if (shallow > 0)
    text += (text.empty() ? "; left out: " : "; ") + std::to_string(shallow) +
            ", behind which the way gets wider by less than " + percent + " %";
  return text;
}

void findCorridors(const CorridorsOptions& options) {
  checkCorridors(options);
  std::optional<Pipeline> pipeline = options.pipeline.given();
  CommandSession session(options.threads, options.quiet);
  const std::shared_ptr<const Environment> environment = session.load(options.environment);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  const RunResult run = session.run(environment, *pipeline, options.pipeline);
  session.begin("making the corridor map");
  const CorridorMap map = makeCorridorMap(*run.mesh, options.map, &session.context());
  if (!options.output.empty()) writeFileSafely(options.output, contentFor(options.output, map));
  session.end();
  BottleneckRule rule = usualBottlenecks(environment->metresPerUnit);
  rule.widerThan = options.widerThan.value_or(rule.widerThan);
  rule.narrowerThan = options.narrowerThan.value_or(rule.narrowerThan);
  rule.leastProminence = options.prominence / 100;
  const BottleneckList list = listBottlenecks(map, rule);
  std::string lines;
  for (const std::size_t i : list.listed) lines += lineOf(map.bottlenecks[i], map);
  print("corridor map of " + counted(map.vertices.size(), "vertex", "vertices") + " and " +
        counted(map.edges.size(), "edge", "edges") + "; " + counted(list.listed.size(), "bottleneck", "bottlenecks") +
        (options.narrowerThan ? " narrower than " + shownNumber(*options.narrowerThan) : "") +
        leftOut(list.slits, shownNumber(rule.widerThan), list.shallow, shownNumber(options.prominence)) + '\n' + lines);
}

}  // namespace

void addCorridorsCommand(CLI::App& app) {
  const auto options = std::make_shared<CorridorsOptions>();
  CLI::App& command =
      *app.add_subcommand("corridors", "Find how wide passages are: the corridor map and its bottlenecks");
  options->environment.addTo(command);
  options->pipeline.addTo(command, "A pipeline file", "One step of the pipeline; give it once for each step");
  command
      .add_option("--narrower-than", options->narrowerThan,
                  "List only bottlenecks narrower than this, in the file's units")
      ->type_name("W");
  command
      .add_option("--wider-than", options->widerThan,
                  "List only bottlenecks wider than this, in the file's units; 0.1 m by default, and 0 lists all")
      ->type_name("W");
  command
      .add_option(
          "--prominence", options->prominence,
          "List only bottlenecks from which the way gets wider by at least this share on both sides, in percent; "
          "0 lists all")
      ->type_name("PERCENT")
      ->capture_default_str();
  command.add_flag("--full", options->map.full, "Keep the pieces of the map that lead into convex corners");
  command
      .add_option("-o,--output", options->output,
                  "Write the map to this file: .json, which the library reads back, .geojson in metres, or .glb: lines "
                  "coloured by width")
      ->type_name("MAP");
  addThreads(command, options->threads);
  command.add_flag("--quiet", options->quiet, "No progress bar");
  command.callback([options] { findCorridors(*options); });
}

}  // namespace footfall::app
