// A parallel block of a pipeline: cells by a strategy, local filters on each of them, and Collapse (thesis 4.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/process_usage.hpp"
#include "core/filters/filter.hpp"
#include "core/partitioning/strategies.hpp"
#include "core/pipeline/runner.hpp"

namespace footfall::detail {

struct BlockRequest {
  std::vector<const PipelineStep*> steps;  ///< from the strategy to Collapse
  std::size_t firstStep = 0;               ///< the strategy's number among the enabled steps of the run
  StatePtr state;                          ///< before the block
  StateSummary summary;                    ///< of that state
  Recall recall;                           ///< `before`: what an earlier run had after the block
  int threads = 1;
};

struct BlockOutcome {
  StatePtr state;
  StateSummary summary;
  std::vector<StepStatistics> steps;
  BlockReport report;
};

/// Runs the block on the threads of the present arena. The state is, byte for byte, the one that the block's filters
/// give one after the other without cells. Throws as applyFilter() does.
BlockOutcome runBlock(const BlockRequest& request, const Stopwatch& clock, RunContext& context);

/// What a strategy sees of a state. `steps`: from the strategy to Collapse.
StrategyInput strategyInput(const WalkableState& state, const std::vector<const PipelineStep*>& steps, int threads,
                            RunContext& context);

}  // namespace footfall::detail
