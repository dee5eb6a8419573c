// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/io/output_files.hpp"
#include "core/report/floor_plan.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct PlanCommandOptions {
  EnvironmentOptions environment;
  PipelineOptions pipeline;
  int threads = 0;
  std::string output;
  std::string scale, paper;  ///< empty: what fits
  std::uint32_t part = 0;    ///< number from 1; 0: all
  std::string coordinateSystem;
  std::optional<double> narrowerThan, widerThan;  ///< in the file's units
  bool corridors = false;
  bool storeys = false, blackAndWhite = false;
  bool quiet = false;
};

/// "100" or "1:100".
double scaleFrom(const std::string& text) {
  const std::string digits = text.starts_with("1:") ? text.substr(2) : text;
  std::size_t read = 0;
  double scale = 0;
  try {
    scale = std::stod(digits, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  if (read == 0 || read != digits.size() || !std::isfinite(scale) || scale < 1)
    throw InputError("--plan-scale: must be like 1:100 or 100, and 1 at least");
  return scale;
}

PlanOptions planOptions(const PlanCommandOptions& options) {
  PlanOptions plan;
  if (options.storeys) plan.pages = PlanPages::Storeys;
  if (options.blackAndWhite) plan.colours = PlanColours::BlackAndWhite;
  if (!options.scale.empty()) plan.scale = scaleFrom(options.scale);
  plan.paper = paperFrom(options.paper);
  if (options.part > 0) plan.part = options.part - 1;
  plan.coordinateSystem = options.coordinateSystem;
  if (options.narrowerThan && !(std::isfinite(*options.narrowerThan) && *options.narrowerThan > 0))
    throw InputError("--narrower-than: must be a width in the file's units; give a number above 0");
  if (options.widerThan && !(std::isfinite(*options.widerThan) && *options.widerThan >= 0))
    throw InputError("--wider-than: must be a width in the file's units; give a number that is not negative");
  const PlanFormat format = planFormatOf(options.output);
  if ((options.narrowerThan || options.corridors) && format != PlanFormat::Svg && format != PlanFormat::Pdf)
    throw InputError(options.output +
                     ": --narrower-than and --corridors are drawn on plans; give a name that ends in .svg or .pdf, or "
                     "write the map by footfall corridors -o");
  plan.narrowerThan = options.narrowerThan;
  plan.widerThan = options.widerThan;
  plan.hasCorridors = options.corridors;
  return plan;
}

/// Returns what was written, for stdout.
std::string drawPlan(const PlanCommandOptions& options) {
  planFormatOf(options.output);
  const PlanOptions plan = planOptions(options);
  WriteTargets targets = targetsBeside(options.environment, options.pipeline);
  targets.add(options.output, FOOTFALL_TEXT("the floor plan"));
  std::optional<Pipeline> pipeline = options.pipeline.given();
  CommandSession session(options.threads, options.quiet);
  const std::shared_ptr<const Environment> environment = session.load(options.environment);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  const RunResult run = session.run(environment, *pipeline, options.pipeline);

  session.begin("drawing");
  const std::vector<OutputFile> files =
      makePlanFiles(*environment, *pipeline, *run.mesh, options.output, plan, session.context());
  std::string written;
  for (const OutputFile& file : files) {
    targets.check(file.path);
    written += file.path + '\n';
  }
  writeFilesSafely(files, session.context());
  session.end();
  return options.quiet ? std::string() : written;
}

}  // namespace

void addPlanCommand(CLI::App& app) {
  const auto options = std::make_shared<PlanCommandOptions>();
  CLI::App& command = *app.add_subcommand("plan", "Draw floor plans to scale, or write them as polygons");
  options->environment.addTo(command);
  options->pipeline.addTo(command, "A pipeline file", "One step of the pipeline; give it once for each step");
  addThreads(command, options->threads);
  command
      .add_option(
          "-o,--output", options->output,
          "Write all pages to this PDF, or each to an SVG file: plan-0.svg, plan-1.svg and so on; or the walkable "
          "area as polygons: one file of well-known text for each layer and plan-links.wkt, or one GeoJSON file")
      ->required()
      ->check(hasName())
      ->type_name("PLAN.svg|.pdf|.wkt|.geojson");
  command.add_flag("--storeys", options->storeys, "Draw one page for each storey instead of one for each layer");
  command
      .add_option("--plan-scale", options->scale, "Draw at this scale; the largest usual one that fits when left out")
      ->type_name("1:N");
  command
      .add_option("--paper", options->paper,
                  "The size of the paper; when left out A4, or A3 where A4 is too small for 1:100, and with a scale "
                  "the smallest that holds it")
      ->check(CLI::IsMember({"A4", "A3", "A2", "A1", "A0"}, CLI::ignore_case))
      ->type_name(kPaperNames);
  CLI::Option* narrower =
      command
          .add_option("--narrower-than", options->narrowerThan,
                      "Draw passages narrower than this as dimension lines with their widths, in the file's units")
          ->type_name("W");
  command
      .add_option("--wider-than", options->widerThan,
                  "Draw only those wider than this, in the file's units; 0.1 m by default")
      ->needs(narrower)
      ->type_name("W");
  command.add_flag("--corridors", options->corridors, "Draw the corridor map: lines in the middle of passages");
  addPolygonOptions(command, options->part, options->coordinateSystem);
  command.add_flag("--black-and-white", options->blackAndWhite, "Draw without colours, for printing");
  command.add_flag("--quiet", options->quiet, "No progress bar, and no list of files");
  command.callback([options] { print(drawPlan(*options)); });
}

}  // namespace footfall::app
