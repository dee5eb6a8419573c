// Several ranks in one process: threads instead of MPI.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/distributed/rank_exchange.hpp"
#include "footfall/run.hpp"

namespace footfall::test {

struct RankOptions {
  int ranks = 2;
  int threads = 1;            ///< threads of each rank
  std::string workFolder;     ///< empty: none
  bool leavesShares = false;  ///< RankExchange::Options
  /// Called by a rank whenever one of its cells is done; may throw, which fails the rank.
  std::function<void(int rank)> cellDone = [](int) {};
  /// The environment of a rank, where it is not the one that all have.
  std::function<std::shared_ptr<const Environment>(int rank)> environmentOf = nullptr;
  std::function<Pipeline(int rank)> pipelineOf = nullptr;  ///< likewise
  /// RankExchange::Options
  std::function<double(int rank)> patienceMs = [](int) { return 10000.0; };
  /// Called by a rank when it is over.
  std::function<void(int rank)> ended = [](int) {};
};

struct RankOutcome {
  RunResult result;         ///< result of rank 0; its mesh is null after a failure
  std::string error;        ///< error reported by rank 0
  std::vector<Text> notes;  ///< notes of all ranks
  std::vector<detail::RankStatistics> ranks;
  std::vector<bool> hasResult;  ///< one flag per rank
  std::vector<bool> isCutOff;   ///< one flag per rank
};

/// Runs the pipeline on all ranks as footfall-mpi does.
RankOutcome runOnRanks(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                       const RankOptions& options);

/// Calls `body` on ranks of one group, each in a thread of its own. `event` (may be empty) is called with the events of
/// their runs, and may throw, which fails the rank. Returns the failure of each rank; empty if it did not fail.
std::vector<std::string> runAsGroup(int ranks, const std::function<void(detail::RankGroup&, RunContext&)>& body,
                                    const std::function<void(int rank, const RunEvent&)>& event = {});

}  // namespace footfall::test
