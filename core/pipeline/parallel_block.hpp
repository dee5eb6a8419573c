// A parallel block of a pipeline: cells by a strategy, local filters on each of them, and Collapse (thesis 4.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/distributed/cell_exchange.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/partitioning/strategies.hpp"
#include "core/pipeline/cell_reuse.hpp"
#include "core/pipeline/runner.hpp"

namespace footfall::detail {

struct BlockRequest {
  std::vector<const PipelineStep*> steps;  ///< steps from the strategy to Collapse
  std::size_t firstStep = 0;               ///< the strategy's number among the enabled steps of the run
  StatePtr state;                          ///< state before the block
  StateSummary summary;                    ///< summary of that state
  Recall recall;                           ///< `before`: what an earlier run had after the block
  int threads = 1;

  // A run that several processes share has these:
  CellExchange* exchange = nullptr;
  std::string key;                           ///< key of the environment and the steps before
  std::size_t phasesBefore = 0, phases = 0;  ///< countPhases() before this block, and in all
};

struct BlockOutcome {
  StatePtr state;  ///< null: other processes have the shares of this one, and go on without it
  StateSummary summary;
  std::vector<StepStatistics> steps;
  BlockReport report;
  std::vector<CellReuse> reuse;  ///< of the cells; empty without a clearance filter
};

/// Runs the block on the threads of the present arena. The state is, byte for byte, the one that the block's filters
/// give one after the other without cells. Throws as applyFilter() does.
BlockOutcome runBlock(const BlockRequest& request, const Stopwatch& clock, RunContext& context);

/// The number of passes in the first `count` enabled steps whose shares processes exchange: clearance filters in
/// blocks.
std::size_t countPhases(const std::vector<const PipelineStep*>& steps, std::size_t count);

/// The threads for which AutoStrategy makes cells where several processes share a run: whatever their number, the cells
/// are the same, so that shares of another number of processes are of use.
constexpr int kThreadsOfAll = 64;

/// The input of a strategy for a state. `steps`: from the strategy to Collapse.
StrategyInput strategyInput(const WalkableState& state, const std::vector<const PipelineStep*>& steps, int threads,
                            RunContext& context);

}  // namespace footfall::detail
