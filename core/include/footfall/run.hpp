// Runs a pipeline over an environment, step by step, with cached steps, timings and counts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"
#include "footfall/statistics.hpp"

namespace footfall {

namespace detail {
class PrefixCache;
}

/// The result of a run, and what it took. Times are milliseconds.
struct RunResult {
  std::vector<StepStatistics> steps;           ///< enabled steps only
  std::shared_ptr<const NavigationMesh> mesh;  ///< never null
  StateSummary summary;                        ///< summary of the last state
  double startMs = 0;                          ///< making the first state from the environment; 0 when cached
  double finishMs = 0;                         ///< time for the rest of the navigation mesh, after a last layer filter
  double totalMs = 0;
  double cpuMs = 0;  ///< processor time of the whole process during the run
  int threads = 1;
  std::vector<BlockReport> blocks;  ///< blocks that ran, in order; none from the cache
  RunTimes times;
};

/// States of earlier runs by environment, filters and parameters: changing the last filter re-runs only the last.
/// Thread-safe. Keeps the states of the most recent runs only (least recently used go first): `capacity` of them, and
/// fewer when they hold more than about `bytes`, but never fewer than a run of a usual pipeline makes. 0 bytes: an
/// eighth of the machine's memory.
class ResultCache {
 public:
  explicit ResultCache(std::size_t capacity = 32, std::size_t bytes = 0);
  ~ResultCache();
  ResultCache(const ResultCache&) = delete;
  ResultCache& operator=(const ResultCache&) = delete;
  /// Drops all states.
  void clear();

  /// Internal to the library.
  [[nodiscard]] detail::PrefixCache& inside() const { return *inside_; }

 private:
  std::unique_ptr<detail::PrefixCache> inside_;
};

/// Runs the enabled steps over an environment that is in order (checkEnvironment()). `threads` limits the worker
/// threads (0: as many as the machine has; at most 1024). Throws Cancelled, InputError (steps that do not run yet) or
/// RunError; the cache keeps what was finished. Events count the enabled steps only, as RunResult::steps does, and
/// steps from the cache are announced like others. Progress that is published after the last step has finished belongs
/// to making the navigation mesh. Several threads may run at the same time, with one cache.
RunResult runPipeline(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context,
                      ResultCache* cache = nullptr, int threads = 0);

}  // namespace footfall
