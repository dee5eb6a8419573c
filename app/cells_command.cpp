// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cells_command.hpp"

#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "app/command_files.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress_bar.hpp"
#include "core/partitioning/cut_export.hpp"
#include "core/partitioning/cutting.hpp"
#include "core/pipeline/runner.hpp"
#include "core/report/cells_report.hpp"
#include "core/report/export_header.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

void checkTarget(const CellsArguments& arguments) {
  checkEnding(arguments.output, "-o", ".obj");
  targetsBeside(arguments.environment, arguments.pipelineFile).add(arguments.output, FOOTFALL_TEXT("the cells"));
}

std::optional<PipelineStep> givenStrategy(const CellsArguments& arguments) {
  if (arguments.strategy.empty()) return std::nullopt;
  const std::string& text = arguments.strategy;
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
    block.steps.push_back({findFilter("AutoStrategy"), {}});
  if (first == steps.end()) first = steps.begin();
  std::copy_if(first, last, std::back_inserter(block.steps), [&](const PipelineStep& step) {
    return isEnabled(FilterKind::Filter)(step) && step.filter->scope == Scope::Local;
  });
  block.steps.push_back({findFilter("Collapse"), {}});
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
CutCounts exportCut(const CellsArguments& arguments, const Environment& environment, const Partition& partition,
                    const Pipeline& block, RunContext& context) {
  const auto poll = [&context] { context.checkCancelled(); };
  const SourceMesh mesh =
      makeSourceMesh(SourceSoupView(environment.vertices, environment.triangles), environment.bothSides, nullptr, poll);
  const CutEnvironment cut = cutEnvironment(mesh, partition, {}, isRounding(block.steps[0]), poll);
  poll();
  writeCutObj(arguments.output, cut, partition.cells.size(), environment, makeExportHeader(block));
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

}  // namespace

std::string previewCells(const CellsArguments& arguments) {
  checkTarget(arguments);
  const std::optional<PipelineStep> strategy = givenStrategy(arguments);
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
  const Pipeline block = blockOf(*pipeline, strategy);

  bar.begin("dividing", 0);
  const Partition partition = previewPartition(environment, block, 0, context, arguments.threads);
  const auto threads =
      static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  CellsReport report{*environment, partition, threads, std::nullopt};
  if (!arguments.output.empty()) {
    bar.begin("exporting", 0);
    report.cut = exportCut(arguments, *environment, partition, block, context);
  }
  bar.clear();
  return arguments.json ? formatCellsJson(report) : formatCells(report);
}

}  // namespace footfall::app
