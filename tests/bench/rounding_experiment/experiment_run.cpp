// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/rounding_experiment/experiment_run.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/parallel.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/worker_arena.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/partitioning/strategies.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

using Steps = std::span<const PipelineStep>;

/// The pipeline's three blocks (thesis 4.1).
struct Blocks {
  Steps before;
  const PipelineStep* strategy = nullptr;
  Steps inside, behind;
};

Blocks blocksOf(const Pipeline& pipeline) {
  const auto& steps = pipeline.steps;
  const auto isKind = [](FilterKind kind) {
    return [kind](const PipelineStep& step) { return step.filter->kind == kind; };
  };
  const auto strategy = std::ranges::find_if(steps, isKind(FilterKind::Strategy));
  const auto collapse = std::ranges::find_if(steps, isKind(FilterKind::Collapse));
  if (strategy == steps.end() || collapse == steps.end())
    throw InputError("the rounding experiment: the pipeline has no parallel block; give one with a strategy");
  const Steps all(steps);
  const auto first = static_cast<std::size_t>(strategy - steps.begin());
  const auto last = static_cast<std::size_t>(collapse - steps.begin());
  return {all.first(first), &*strategy, all.subspan(first + 1, last - first - 1), all.subspan(last + 1)};
}

StatePtr applyAll(Steps steps, StatePtr state, RunContext& context) {
  for (const PipelineStep& step : steps) state = applyFilter(*step.filter, step.values, state, context).state;
  return state;
}

double clearanceOf(Steps steps) {
  for (const PipelineStep& step : steps)
    if (step.filter->type == FilterType::VerticalClearance) return step.values[0];
  return 0;
}

Partition partitionFor(const Blocks& blocks, const WalkableState& state, int threads) {
  const StrategyInput input{state.kernel->mesh(), state.walkable, state.removed, clearanceOf(blocks.inside), threads};
  return makePartition(blocks.strategy->filter->type, blocks.strategy->values, input);
}

CutEnvironment cutAll(const WalkableState& state, const Partition& partition) {
  std::vector<char> included(state.removed.size());
  std::ranges::transform(state.removed, included.begin(), [](char removed) { return removed == 0 ? 1 : 0; });
  return cutEnvironment(state.kernel->mesh(), partition, included, false);
}

/// A cell as an environment: what was rejected before the cuts stays an obstacle.
std::shared_ptr<Environment> cellEnvironment(const RoundedCut& cut, std::span<const std::size_t> members,
                                             const WalkableState& state, const Environment& whole) {
  auto cell = std::make_shared<Environment>();
  cell->source = whole.source;
  cell->up = whole.up;
  cell->metresPerUnit = whole.metresPerUnit;
  std::vector<Index> used;
  for (const std::size_t i : members)
    used.insert(used.end(), cut.triangles[i].corners.begin(), cut.triangles[i].corners.end());
  std::ranges::sort(used);
  const auto repeated = std::ranges::unique(used);
  used.erase(repeated.begin(), repeated.end());
  for (const Index v : used) cell->vertices.push_back(cut.vertices[static_cast<std::size_t>(v)]);
  const auto numberOf = [&](Index v) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(used, v) - used.begin());
  };
  for (const std::size_t i : members) {
    const CutTriangle& t = cut.triangles[i];
    cell->triangles.push_back({numberOf(t.corners[0]), numberOf(t.corners[1]), numberOf(t.corners[2])});
    cell->obstacleOnly.push_back(state.walkable[static_cast<std::size_t>(t.source)] != 0 ? 0 : 1);
  }
  return cell;
}

using MeshPtr = std::shared_ptr<const NavigationMesh>;

std::vector<MeshPtr> runCells(const RoundedCut& cut, std::size_t cellCount, Steps filters, const WalkableState& state) {
  std::vector<std::vector<std::size_t>> members(cellCount);
  for (std::size_t i = 0; i < cut.triangles.size(); ++i)
    members[static_cast<std::size_t>(cut.triangles[i].cell)].push_back(i);
  std::vector<MeshPtr> meshes(cellCount);
  forRanges(cellCount, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t cell = first; cell < last; ++cell) {
      if (members[cell].empty()) continue;
      RunContext context;
      const auto environment = cellEnvironment(cut, members[cell], state, *state.environment);
      const StatePtr result = applyAll(filters, makeInitialState(environment, context), context);
      meshes[cell] = makeNavigationMesh(result, context);
    }
  });
  return meshes;
}

/// The walkable parts of all cells, and the obstacle edges between them.
struct MergedCells {
  std::shared_ptr<Environment> environment;
  std::vector<std::array<std::uint32_t, 2>> obstacleEdges;
};

MergedCells mergeCells(const std::vector<MeshPtr>& meshes, const Environment& whole) {
  MergedCells merged;
  merged.environment = std::make_shared<Environment>();
  Environment& environment = *merged.environment;
  environment.source = whole.source;
  environment.up = whole.up;
  environment.metresPerUnit = whole.metresPerUnit;
  for (const MeshPtr& mesh : meshes) {
    if (!mesh) continue;
    const auto first = static_cast<std::uint32_t>(environment.vertices.size());
    environment.vertices.insert(environment.vertices.end(), mesh->vertices.begin(), mesh->vertices.end());
    for (const Triangle& t : mesh->triangles)
      environment.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    for (const auto& [u, v] : mesh->obstacleEdges) merged.obstacleEdges.push_back({u + first, v + first});
  }
  return merged;
}

/// Makes a state like makeInitialState(), with the obstacle edges.
StatePtr stateOf(const MergedCells& merged) {
  SoupView soup(merged.environment->vertices, merged.environment->triangles);
  soup.obstacleEdges = merged.obstacleEdges;
  auto mesh = std::make_shared<const SourceMesh>(makeSourceMesh(soup, false));
  auto state = std::make_shared<WalkableState>();
  state->environment = merged.environment;
  for (const std::int8_t facing : mesh->facing) state->walkable.push_back(facing > 0 ? 1 : 0);
  state->removed.assign(mesh->triangles.size(), 0);
  state->kernel = std::make_shared<PlanKernel>(std::move(mesh), std::vector<double>{});
  return state;
}

ExperimentResult run(const std::shared_ptr<const Environment>& environment, const Blocks& blocks, bool repair,
                     int threads) {
  ExperimentResult result;
  RunContext context;
  const Stopwatch whole;
  double before = 0;
  const auto lap = [&] {
    const double now = whole.wallMs();
    return now - std::exchange(before, now);
  };
  const StatePtr state = applyAll(blocks.before, makeInitialState(environment, context), context);
  result.times.preprocessing = lap();
  const Partition partition = partitionFor(blocks, *state, threads);
  const CutEnvironment cut = cutAll(*state, partition);
  RoundedCut rounded = roundCut(cut);
  if (repair) repairCut(state->kernel->mesh(), rounded);
  result.times.partitioning = lap();
  const std::vector<MeshPtr> meshes = runCells(rounded, partition.cells.size(), blocks.inside, *state);
  result.times.parallel = lap();
  const MergedCells merged = mergeCells(meshes, *environment);
  result.times.merging = lap();
  const StatePtr last = applyAll(blocks.behind, stateOf(merged), context);
  result.mesh = makeNavigationMesh(last, context);
  result.times.postprocessing = lap();
  result.times.total = before;
  result.times.cpu = whole.cpuMs();
  result.cells = partition.cells.size();
  result.triangles = environment->triangles.size();
  result.cutTriangles = rounded.triangles.size();
  result.cutVertices = cut.vertices.size() - state->kernel->mesh().vertices.size();
  return result;
}

}  // namespace

ExperimentResult runExperiment(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                               bool repair, int threads) {
  const Blocks blocks = blocksOf(pipeline);
  return onThreads(threads, [&](int workers) { return run(environment, blocks, repair, workers); });
}

CutCases countExperimentCases(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                              int threads) {
  const Blocks blocks = blocksOf(pipeline);
  return onThreads(threads, [&](int workers) {
    RunContext context;
    const StatePtr state = applyAll(blocks.before, makeInitialState(environment, context), context);
    const Partition partition = partitionFor(blocks, *state, workers);
    const CutEnvironment cut = cutAll(*state, partition);
    return countCases(state->kernel->mesh(), partition, cut, roundCut(cut));
  });
}

}  // namespace footfall::bench
