// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/parallel_block.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "core/base/counted_text.hpp"
#include "core/filters/face_filter.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/pipeline/block_run.hpp"
#include "core/pipeline/result_cache.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {
namespace {

class Block {
 public:
  Block(const BlockRequest& request, const Stopwatch& clock, RunContext& context)
      : request_(request), clock_(clock), context_(context), state_(request.state) {
    outcome_.summary = request.summary;
    outcome_.report.firstStep = request.firstStep;
    outcome_.report.lastStep = request.firstStep + request.steps.size() - 1;
    outcome_.report.startMs = clock.wallMs();
  }

  BlockOutcome run() {
    makeCells();
    const std::size_t last = request_.steps.size() - 1;
    for (std::size_t k = 1; k < last; ++k) context_.beginStep(request_.firstStep + k, nameOf(k));
    for (std::size_t k = 1; k < last && state_;) k = runPhase(k);
    if (!state_) return std::move(outcome_);
    collapse();
    outcome_.state = std::move(state_);
    return std::move(outcome_);
  }

 private:
  [[nodiscard]] std::string nameOf(std::size_t k) const { return std::string(request_.steps[k]->filter->name); }

  StepStatistics& addStep(std::size_t k, double startMs, double wallMs, double cpuMs) {
    StepStatistics step;
    step.name = nameOf(k);
    step.parameters = request_.steps[k]->values;
    step.startMs = startMs;
    step.wallMs = wallMs;
    step.cpuMs = cpuMs;
    step.in = outcome_.summary;
    step.out = outcome_.summary;
    outcome_.steps.push_back(std::move(step));
    return outcome_.steps.back();
  }

  void makeCells() {
    const Stopwatch watch;
    context_.beginStep(request_.firstStep, nameOf(0));
    const StrategyInput input = strategyInput(
        *state_, request_.steps, request_.exchange != nullptr ? kThreadsOfAll : request_.threads, context_);
    partition_ = makePartition(request_.steps[0]->filter->type, request_.steps[0]->values, input);
    floors_ = assignFloors(partition_, input);
    mesh_ = state_->kernel->sharedMesh();
    BlockReport& report = outcome_.report;
    report.strategy = partition_.strategy;
    report.reason = partition_.reason;
    for (const Cell& cell : partition_.cells) {
      CellReport& entry = report.cells.emplace_back();
      entry.bounds = cell.bounds;
      entry.cost = cell.cost;
      entry.trianglesIn = cell.floors + cell.obstacles;
    }
    report.partitioningMs = watch.wallMs();
    StepStatistics& step = addStep(0, report.startMs, report.partitioningMs, watch.cpuMs());
    const std::size_t cells = partition_.cells.size();
    step.note = countedText(cells, FOOTFALL_TEXT("1 cell"), FOOTFALL_TEXT("%1 cells"));
    if (!partition_.reason.empty())
      step.note = Text(Pattern{"%1; %2: %3"}, step.note, partition_.strategy, partition_.reason);
    context_.cellsMade(std::make_shared<const BlockReport>(report));
    context_.endStep(request_.firstStep, nullptr);
  }

  // Runs as many filters as one pass over the cells can hold: tests of single faces, then a clearance. Returns the step
  // after them.
  std::size_t runPhase(std::size_t k) {
    std::vector<FaceTest> tests;
    const std::size_t end = request_.steps.size() - 1;
    std::size_t next = k;
    // Each filter has to cut the mesh if there is one; and it must see all floors if there is something to recall.
    const bool canTest = !state_->mesh && !request_.recall.before;
    for (; canTest && next < end; ++next) {
      const PipelineStep& step = *request_.steps[next];
      FaceTest test = makeFaceTest(*step.filter, step.values, state_->kernel);
      if (!test) break;
      tests.push_back(std::move(test));
    }
    const bool hasClearance = next < end && request_.steps[next]->filter->type == FilterType::VerticalClearance;
    if (tests.empty() && !hasClearance) return runShared(k);
    runCells(k, std::move(tests), hasClearance ? request_.steps[next] : nullptr);
    return next + (hasClearance ? 1 : 0);
  }

  void runCells(std::size_t k, std::vector<FaceTest> tests, const PipelineStep* clearance) {
    const double startMs = clock_.wallMs();
    const Stopwatch watch;
    if (mesh_ != state_->kernel->sharedMesh()) {  // a filter of the block moved vertices
      floors_ = assignFloors(partition_, strategyInput(*state_, request_.steps, request_.threads, context_));
      mesh_ = state_->kernel->sharedMesh();
    }
    CellFilters filters{{}, tests, nullptr};
    for (std::size_t i = 0; i < tests.size() + (clearance != nullptr ? 1 : 0); ++i)
      filters.names.push_back(nameOf(k + i));
    std::optional<ClearancePass> pass;
    if (clearance != nullptr) {
      pass.emplace(state_, clearance->values[0], tests, partition_.borders, request_.recall, context_);
      filters.clearance = &*pass;
    }
    CellsElsewhere elsewhere;
    if (pass && request_.exchange != nullptr) elsewhere = divideCells(k + tests.size(), tests, *pass);
    BlockRun cells(partition_, floors_, *mesh_, state_->walkable, std::move(filters), outcome_.report.cells, clock_,
                   context_, elsewhere);
    cells.run();
    if (elsewhere.exchange != nullptr && !elsewhere.exchange->merges()) {
      state_ = nullptr;
      return;
    }
    const double wallMs = watch.wallMs();
    outcome_.report.parallelMs += wallMs;

    for (std::size_t i = 0; i < tests.size(); ++i) {
      applyTest(k + i, i + 1, cells);
      finishCellStep(k + i, startMs, wallMs, i, cells);
    }
    if (tests.size() > 0) outcome_.steps.back().fallbacks = cells.fallbacks();
    if (!pass) return;
    outcome_.reuse = cells.reuse();
    const Stopwatch merging;
    mergingStartMs_ = clock_.wallMs();
    FilterOutcome outcome = pass->finish(state_->walkable, state_->removed, true);
    outcome_.report.mergingMs += merging.wallMs();
    mergingCpuMs_ += merging.cpuMs();
    state_ = std::move(outcome.state);
    finishCellStep(k + tests.size(), startMs, wallMs, tests.size(), cells);
    outcome_.steps.back().fallbacks = outcome.fallbacks;
  }

  // The cells of the pass of step k that this process runs. `tests` and `pass` must outlive the result.
  CellsElsewhere divideCells(std::size_t k, const std::vector<FaceTest>& tests, const ClearancePass& pass) {
    const auto reader =
        std::make_shared<const CellShareReader>(floors_, state_->walkable, tests, pass, tests.size() + 1);
    CellPhase phase;
    phase.check = [&reader](Index cell, std::string_view bytes) { static_cast<void>(reader->read(cell, bytes)); };
    phase.number = request_.phasesBefore + countPhases(request_.steps, k);
    phase.count = request_.phases;
    Digest digest;
    digest.add(request_.key).add(prefixKey(request_.steps, k + 1));
    for (const std::vector<double>& borders : partition_.borders) digest.add(std::span<const double>(borders));
    for (const Partition::Node& node : partition_.nodes)
      digest.add(node.axis).add(node.coordinate).add(node.below).add(node.above);
    phase.key = digest.value();
    for (const Cell& cell : partition_.cells) phase.costs.push_back(cell.cost);
    phase.nowMs = clock_.wallMs();
    return {request_.exchange, request_.exchange->begin(phase, context_), reader};
  }

  // Turns the findings of the cells into the filter's own state.
  void applyTest(std::size_t k, std::size_t passed, const BlockRun& cells) {
    if (request_.steps[k]->filter->type == FilterType::Degeneracy) {
      FilterOutcome outcome = applyDegeneracy(state_, context_);
      state_ = std::move(outcome.state);
      note_ = std::move(outcome.note);
      return;
    }
    auto result = std::make_shared<WalkableState>(*state_);
    for (std::size_t t = 0; t < result->walkable.size(); ++t)
      result->walkable[t] = static_cast<char>(result->walkable[t] != 0 && cells.passed()[t] >= passed);
    state_ = std::move(result);
  }

  // A step that ran on all cells: its share of the time is the one that it had of the threads.
  void finishCellStep(std::size_t k, double startMs, double wallMs, std::size_t filter, const BlockRun& cells) {
    const double own = cells.workMs(filter), all = cells.workMs();
    StepStatistics& step = addStep(k, startMs, all > 0 ? wallMs * own / all : 0, own);
    step.note = std::exchange(note_, {});
    outcome_.summary = summarize(*state_);
    step.out = outcome_.summary;
    context_.endStep(request_.firstStep + k, context_.wantsParts() ? makePreviewMesh(*state_) : nullptr);
  }

  // A filter that needs to see over the borders of cells: on the whole environment, with all threads.
  std::size_t runShared(std::size_t k) {
    const PipelineStep& step = *request_.steps[k];
    const double startMs = clock_.wallMs();
    const Stopwatch watch;
    FilterOutcome outcome = applyFilter(*step.filter, step.values, state_, context_);
    const double wallMs = watch.wallMs();
    outcome_.report.shared.push_back({nameOf(k), 0, startMs, startMs + wallMs});
    outcome_.report.parallelMs += wallMs;
    state_ = std::move(outcome.state);
    StepStatistics& statistics = addStep(k, startMs, wallMs, watch.cpuMs());
    statistics.note = std::move(outcome.note);
    statistics.fallbacks = outcome.fallbacks;
    outcome_.summary = summarize(*state_);
    statistics.out = outcome_.summary;
    context_.endStep(request_.firstStep + k, context_.wantsParts() ? makePreviewMesh(*state_) : nullptr);
    return k + 1;
  }

  // The cells were put together behind each phase; what is left is to say so.
  void collapse() {
    const std::size_t k = request_.steps.size() - 1;
    if (mergingStartMs_ == 0) mergingStartMs_ = clock_.wallMs();
    context_.beginStep(request_.firstStep + k, nameOf(k));
    addStep(k, mergingStartMs_, outcome_.report.mergingMs, mergingCpuMs_);
    context_.endStep(request_.firstStep + k, nullptr);
  }

  const BlockRequest& request_;
  const Stopwatch& clock_;
  RunContext& context_;
  StatePtr state_;
  Partition partition_;
  CellFloors floors_;
  std::shared_ptr<const SourceMesh> mesh_;  ///< mesh of floors_
  Text note_;
  double mergingStartMs_ = 0, mergingCpuMs_ = 0;
  BlockOutcome outcome_;
};

}  // namespace

std::size_t countPhases(const std::vector<const PipelineStep*>& steps, std::size_t count) {
  bool isInBlock = false;
  std::size_t phases = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (steps[i]->filter->kind != FilterKind::Filter) isInBlock = steps[i]->filter->kind == FilterKind::Strategy;
    if (isInBlock && steps[i]->filter->type == FilterType::VerticalClearance) ++phases;
  }
  return phases;
}

StrategyInput strategyInput(const WalkableState& state, const std::vector<const PipelineStep*>& steps, int threads,
                            RunContext& context) {
  double clearance = 0;
  for (const PipelineStep* step : steps)
    if (clearance == 0 && step->filter->type == FilterType::VerticalClearance) clearance = step->values[0];
  return {state.kernel->mesh(), state.walkable, state.removed, clearance, threads, context};
}

BlockOutcome runBlock(const BlockRequest& request, const Stopwatch& clock, RunContext& context) {
  return Block(request, clock, context).run();
}

}  // namespace footfall::detail
