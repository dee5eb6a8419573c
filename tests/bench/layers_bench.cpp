// footfall-layers-bench [FILE[:CLEARANCE]...]: what LayerSubdivisionFilter costs beside VerticalClearanceFilter in the
// default pipeline, and how many layers and connections are needed at least; of files, the samples and generated levels
// with many floors above each other, as Markdown. Processor times, the least of five runs in one process; work that the
// runner does beside the filter is not in them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <string>

#include "core/assembly/walkable_state.hpp"
#include "core/base/process_usage.hpp"
#include "core/filters/apply_filter.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/inspect.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/pipeline_measurement.hpp"
#include "tests/bench/stacked_levels.hpp"
#include "tests/bench/subject.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;

double leastCpuMs(const std::function<void()>& work) {
  constexpr int kRuns = 5;
  constexpr double kLong = 1000;  // milliseconds, after which one more run is enough
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  for (int i = 0; i < kRuns && sum < kLong; ++i) {
    const Stopwatch watch;
    work();
    least = std::min(least, watch.cpuMs());
    sum += watch.cpuMs();
  }
  return least;
}

double onThreads(std::size_t threads, const std::function<void()>& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return leastCpuMs(work);
}

void measure(const std::string& name, const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
             Table& table) {
  RunContext context;
  StatePtr state = makeInitialState(environment, context);
  double clearance = 0, layers = 0, layersOnTwo = 0, kept = 0;
  for (const PipelineStep& step : pipeline.steps) {
    if (!step.enabled) continue;
    StatePtr result;
    const auto apply = [&](const Recall& recall) {
      result = applyFilter(*step.filter, step.values, state, context, recall).state;
    };
    if (step.filter->type == FilterType::VerticalClearance) {
      clearance = onThreads(1, [&] { apply({}); });
    } else if (step.filter->type == FilterType::LayerSubdivision) {
      Recall keeping;
      keeping.keep = true;
      kept = onThreads(1, [&] { apply(keeping); });
      layersOnTwo = onThreads(2, [&] { apply({}); });
      layers = onThreads(1, [&] { apply({}); });
    } else {
      apply({});
    }
    state = result;
  }
  const auto mesh = makeNavigationMesh(state, context);
  const auto count = [](std::size_t n) { return grouped(static_cast<double>(n)); };
  table.addRow({name, count(state->mesh->triangles.size()), number(clearance), number(layers),
                number(layers / clearance), number(layersOnTwo), number(kept), count(mesh->layerCount),
                count(leastLayers(*mesh)), count(mesh->connections.size()), count(leastConnections(*mesh))});
}

void run(const std::vector<std::string>& files) {
  Table table({"environment", "triangles", "VerticalClearance", "LayerSubdivision", "over it", "on two threads",
               "kept for edits", "layers", "at least", "connections", "at least"});
  std::vector<Subject> subjects;
  for (const std::string& file : files) subjects.push_back(parseSubject(file, 2));
  for (const Subject& subject : sampleSubjects()) subjects.push_back(subject);
  for (const Subject& subject : subjects) {
    const auto environment = loadSubject(subject);
    measure(subject.name, environment, pipelineFor(subject, *environment), table);
  }
  for (const StackedLevel& level : makeStackedLevels())
    measure(level.name, level.environment, defaultPipeline(*level.environment), table);
  std::cout << table.text();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run({argv + 1, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "footfall-layers-bench: " << error.what() << '\n';
    return 1;
  }
}
