// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/base/poll.hpp"
#include "core/base/worker_arena.hpp"
#include "core/partitioning/cut_export.hpp"
#include "core/partitioning/cutting.hpp"
#include "core/pipeline/runner.hpp"
#include "core/report/cells_report.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct CellsOptions {
  EnvironmentOptions environment;
  std::string strategy;  ///< strategy as in a pipeline file; empty: the pipeline's first, or AutoStrategy
  PipelineOptions pipeline;
  int threads = 0;
  std::string output;  ///< empty: the cut environment is not exported
  bool json = false;
};

void checkTarget(const CellsOptions& options) {
  checkEnding(options.output, "-o", ".obj");
  targetsBeside(options.environment, options.pipeline).add(options.output, FOOTFALL_TEXT("the cells"));
}

std::optional<PipelineStep> givenStrategy(const CellsOptions& options) {
  if (options.strategy.empty()) return std::nullopt;
  const std::string& text = options.strategy;
  const std::size_t start = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t stop = std::min(text.find_first_of(" \t\r\n#", start), text.size());
  const FilterDescriptor* filter = findFilter(std::string_view(text).substr(start, stop - start));
  if (start == stop || text.find_first_of("\r\n") != std::string::npos ||
      (filter != nullptr && filter->kind != FilterKind::Strategy))
    throw InputError("--strategy: takes one strategy with its parameters; give one such as \"GridStrategy 3 2\"");
  return parsePipeline(text + "\nCollapse\n", "--strategy").steps.at(0);
}

/// One parallel block: the strategy, and the pipeline's filters that may run in its cells.
Pipeline blockOf(const Pipeline& pipeline, const std::optional<PipelineStep>& strategy) {
  const auto isEnabled = [](FilterKind kind) {
    return [kind](const PipelineStep& step) { return step.enabled && step.filter->kind == kind; };
  };
  const auto& steps = pipeline.steps;
  auto first = std::find_if(steps.begin(), steps.end(), isEnabled(FilterKind::Strategy));
  auto last = std::find_if(first, steps.end(), isEnabled(FilterKind::Collapse));
  Pipeline block;
  if (strategy)
    block.steps.push_back(*strategy);
  else if (first != steps.end())
    block.steps.push_back(*first);
  else
    block.steps.push_back({&filterDescriptor(FilterType::AutoStrategy), {}});
  if (first == steps.end()) first = steps.begin();
  std::copy_if(first, last, std::back_inserter(block.steps), [&](const PipelineStep& step) {
    return isEnabled(FilterKind::Filter)(step) && step.filter->scope == Scope::Local;
  });
  block.steps.push_back({&filterDescriptor(FilterType::Collapse), {}});
  return block;
}

/// The strategy's parameter of that name, where it has one.
bool isRounding(const PipelineStep& strategy) {
  const auto& parameters = strategy.filter->parameters;
  for (std::size_t i = 0; i < std::min(parameters.size(), strategy.values.size()); ++i)
    if (parameters[i].name == "round") return strategy.values[i] != 0;
  return false;
}

/// Cuts the environment, writes it, and counts what came out.
CutCounts exportCut(const CellsOptions& options, const Environment& environment, const Partition& partition,
                    const Pipeline& block, RunContext& context) {
  const Poll poll(context);
  const SourceMesh mesh =
      makeSourceMesh(SoupView(environment.vertices, environment.triangles), environment.bothSides, nullptr, poll);
  const CutEnvironment cut = cutEnvironment(mesh, partition, {}, isRounding(block.steps[0]), poll);
  poll();
  writeCutObj(options.output, cut, partition.cells.size(), environment, makeExportHeader(block));
  std::vector<char> isUsed(cut.vertices.size(), 0);
  for (const CutTriangle& t : cut.triangles)
    for (const Index v : t.corners) isUsed[static_cast<std::size_t>(v)] = 1;
  CutCounts counts;
  for (std::size_t v = 0; v < isUsed.size(); ++v) {
    if (isUsed[v] == 0) continue;
    ++counts.vertices;
    if (cut.vertices[v].kind != CutVertex::Source) ++counts.cutVertices;
  }
  counts.triangles = cut.triangles.size();
  counts.closedTriangles = cut.closedTriangles;
  return counts;
}

std::string previewCells(const CellsOptions& options) {
  checkTarget(options);
  const std::optional<PipelineStep> strategy = givenStrategy(options);
  std::optional<Pipeline> pipeline = options.pipeline.given();
  CommandSession session(options.threads);
  const auto environment = session.load(options.environment);
  if (!pipeline) pipeline = defaultPipeline(*environment);
  const Pipeline block = blockOf(*pipeline, strategy);

  session.begin("dividing");
  const Partition partition = previewPartition(environment, block, 0, session.context(), options.threads);
  CellsReport report{*environment, partition, allowedThreads(), std::nullopt};
  if (!options.output.empty()) {
    session.begin("exporting");
    report.cut = exportCut(options, *environment, partition, block, session.context());
  }
  session.end();
  return options.json ? formatCellsJson(report) : formatCells(report);
}

}  // namespace

void addCellsCommand(CLI::App& app) {
  const auto options = std::make_shared<CellsOptions>();
  CLI::App& command = *app.add_subcommand(
      "cells", "Show the cells into which a strategy divides an environment, without running filters");
  options->environment.addTo(command);
  command
      .add_option("--strategy", options->strategy,
                  "The strategy, such as \"GridStrategy 3 2\"; the pipeline's first, else AutoStrategy, when left out")
      ->type_name("STEP");
  options->pipeline.addTo(command, "A pipeline file: strategies look at the clearance of its filters",
                          "One step of the pipeline; give it once for each step");
  addThreads(command, options->threads, "Threads to plan for; as many as there are processors by default");
  command.add_option("-o,--output", options->output, "Write the environment, cut along the cells, to this OBJ file")
      ->check(hasName())
      ->type_name("CELLS.obj");
  command.add_flag("--json", options->json, "Print the report as JSON");
  command.callback([options] { print(previewCells(*options)); });
}

}  // namespace footfall::app
