// Runs a pipeline over an environment, step by step, with cached steps, timings and counts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/filters/filter.hpp"
#include "core/pipeline/pipeline.hpp"
#include "core/pipeline/run_report.hpp"
#include "core/text.hpp"

namespace footfall {

struct StepStatistics {
  std::string name;
  std::vector<double> parameters;
  double startMs = 0;  ///< since the run began; the filters of a parallel block begin together
  double wallMs = 0;   ///< inside a parallel block: the filter's share of the time that its cells took
  double cpuMs = 0;    ///< of the whole process while the step ran; inside a parallel block: of all threads on cells
  bool fromCache = false;
  StateSummary in, out;
  Text note;
  ExactFallbacks fallbacks;
};

struct RunResult {
  std::vector<StepStatistics> steps;  ///< enabled steps only
  std::shared_ptr<const NavigationMesh> mesh;
  StateSummary summary;
  double startMs = 0;   ///< making the first state from the environment; 0 when cached
  double finishMs = 0;  ///< making the navigation mesh from the last state
  double totalMs = 0;
  double cpuMs = 0;  ///< of the whole process during the run
  int threads = 1;
  std::vector<BlockReport> blocks;  ///< that ran, in order; none from the cache
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
  void clear();

 private:
  friend RunResult runPipeline(std::shared_ptr<const Environment>, const Pipeline&, RunContext&, ResultCache*, int);
  friend std::vector<StatePtr> stepStates(std::shared_ptr<const Environment>, const Pipeline&, RunContext&,
                                          ResultCache&, int);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Runs the enabled steps. `threads` limits the worker threads (0: as many as the machine has). Throws Cancelled,
/// InputError (steps that do not run yet) or RunError; the cache keeps what was finished. Events count the enabled
/// steps only, as RunResult::steps does, and steps from the cache are announced like others. Progress that is published
/// after the last step has finished belongs to making the navigation mesh.
RunResult runPipeline(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context,
                      ResultCache* cache = nullptr, int threads = 0);

/// The states that a run of the same pipeline goes through: before its first enabled step, and then after each. What
/// the cache has is taken from there, the rest is run and kept, as by runPipeline(). Inside a parallel block the states
/// are those of its filters one after the other, which give the same; a strategy changes nothing.
std::vector<StatePtr> stepStates(std::shared_ptr<const Environment> environment, const Pipeline& pipeline,
                                 RunContext& context, ResultCache& cache, int threads = 0);

/// The cells that the parallel block of `step` (a strategy; index into Pipeline::steps) would have, without running any
/// filter: all triangles that face up count as floors. Throws Cancelled or InputError.
Partition previewPartition(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                           std::size_t step, RunContext& context, int threads = 0);

}  // namespace footfall
