// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/runner.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include "core/base/background_release.hpp"
#include "core/base/exhaustion.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/worker_arena.hpp"
#include "core/filters/rounding/settled_product.hpp"
#include "core/pipeline/block_structure.hpp"
#include "core/pipeline/parallel_block.hpp"
#include "core/pipeline/result_cache.hpp"
#include "footfall/filter.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

constexpr Pattern kAtPlace{"%1: %2"};

// Above this many triangles, steps return freed memory, which would otherwise add to the peaks of later ones. Below it,
// returning and allocating again would cost an eighth of a run and save only a fiftieth of the peak. Runs after an edit
// need as much again at once.
constexpr std::size_t kReturnedSize = std::size_t{1} << 22;
// Cached runs above this many triangles return unused memory at the end, after the result has been delivered.
constexpr std::size_t kReturnedAtEnd = std::size_t{1} << 19;
// Above this many triangles, rounding waits until the layers are done, because the two together would double peak
// memory.
constexpr std::size_t kSettledAfter = std::size_t{1} << 19;

// Checks everything that can be known to be wrong before the first step runs.
void checkRunnable(const Pipeline& pipeline) {
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled) continue;
    const Text place(Pattern{"%1, %2"}, placeOfStep(pipeline, i), step.filter->name);
    if (!step.filter->takes(step.values.size())) {
      const std::size_t repeats = step.filter->repeats;
      throw InputError(repeats == 0 ? FOOTFALL_TEXT("%1: values given: %2; give %3")
                                    : FOOTFALL_TEXT("%1: values given: %2; give a multiple of %3"),
                       place, step.values.size(), repeats == 0 ? step.filter->parameters.size() : repeats);
    }
    for (std::size_t v = 0; v < step.values.size(); ++v) {
      const Text wrong = checkValue(step.filter->parameterOf(v), step.values[v]);
      if (!wrong.empty()) throw InputError(kAtPlace, place, wrong);
    }
  }
  if (const auto error = findStructureError(pipeline)) {
    throw InputError(kAtPlace, placeOfStep(pipeline, error->step), error->message);
  }
}

// Runs `work`. Every error in it that the user has not caused becomes a RunError with the place.
template <typename Work>
auto guarded(const Text& where, Work&& work) {
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const RunError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw RunError(FOOTFALL_TEXT("%1: memory ran out; close other programs or use a smaller environment"), where);
  } catch (const std::exception& error) {
    if (const auto ranOut = exhaustionText(error)) throw RunError(Pattern{"%1: %2"}, where, *ranOut);
    throw RunError(FOOTFALL_TEXT("%1: internal error (%2); please report it with the environment's file"), where,
                   error.what());
  }
}

// Runs `work`; adds the place of the step to its input errors.
template <typename Work>
auto withPlace(const Text& place, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(kAtPlace, place, error.text());
  }
}

class Run {
 public:
  Run(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context, PrefixCache* cache,
      int threads, const Stopwatch& clock, CellExchange* exchange = nullptr)
      : environment_(std::move(environment)),
        pipeline_(pipeline),
        context_(context),
        cache_(cache),
        threads_(threads),
        clock_(clock),
        exchange_(exchange) {
    for (const PipelineStep& step : pipeline.steps) {
      if (step.enabled) steps_.push_back(&step);
    }
  }

  // Whoever waits for the result need not wait until the last state is gone.
  ~Run() {
    if (environment_->triangles.size() >= kLargeRelease) releaseInBackground(std::move(current_.state));
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  RunResult execute() {
    context_.checkCancelled();
    const bool isDivided = exchange_ != nullptr && countPhases(steps_, steps_.size()) > 0;
    if (exchange_ != nullptr && !isDivided && !exchange_->merges()) return {};
    makesProduct_ = true;
    takeFromCache();
    const double startMs = current_.state ? 0 : makeStart();
    while (current_.steps.size() < steps_.size()) {
      const std::size_t next = current_.steps.size();
      if (steps_[next]->filter->kind == FilterKind::Strategy)
        runBlockAt(next);
      else
        runStep(next);
      if (!current_.state) return {};  // the others go on
    }
    const Stopwatch finishing;
    context_.checkCancelled();
    if (!current_.mesh) {
      current_.mesh = guarded(FOOTFALL_TEXT("navigation mesh"), [&] { return makeProduct(); });
      if (!servesEdits()) current_.rounded = nullptr;
      remember();
    }
    if (cache_ != nullptr) returnMemory(kReturnedAtEnd);
    RunResult result;
    result.startMs = startMs;
    result.finishMs = finishing.wallMs();
    result.steps = std::move(current_.steps);
    result.mesh = current_.mesh;
    result.summary = current_.summary;
    result.blocks = std::move(blocks_);
    result.times = times_;
    return result;
  }

  // See stepStates(); there must be a cache.
  std::vector<StatePtr> states() {
    advanceTo(0);
    std::vector<StatePtr> states{current_.state};
    for (std::size_t step = 0; step < steps_.size();) {
      if (steps_[step]->filter->kind != FilterKind::Strategy) {
        advanceTo(++step);
        states.push_back(current_.state);
        continue;
      }
      StatePtr state = current_.state;
      states.push_back(state);  // the strategy's
      const std::size_t collapse = findCollapse(step);
      advanceTo(collapse + 1);
      for (++step; step < collapse; ++step) {
        // The last filter's is that of the block, and it is most of the work.
        state = step + 1 < collapse ? applyAlone(step, state) : current_.state;
        states.push_back(state);
      }
      states.push_back(current_.state);
      ++step;
    }
    return states;
  }

 private:
  // Makes current_ what it is after the first `count` steps: one more than now, or those of a block.
  void advanceTo(std::size_t count) {
    context_.checkCancelled();
    if (auto found = cache_->find(environment_, prefixKey(steps_, count))) {
      current_ = std::move(*found);
      return;
    }
    const std::size_t next = current_.steps.size();
    if (count == 0)
      makeStart();
    else if (steps_[next]->filter->kind == FilterKind::Strategy)
      runBlockAt(next);
    else
      runStep(next);
  }

  StatePtr applyAlone(std::size_t index, const StatePtr& state) {
    return guarded(Text(Pattern{"%1, %2"}, placeOf(index), steps_[index]->filter->name),
                   [&] { return applyFilter(*steps_[index]->filter, steps_[index]->values, state, context_).state; });
  }

  [[nodiscard]] std::size_t findCollapse(std::size_t first) const {
    while (steps_[first]->filter->kind != FilterKind::Collapse) ++first;
    return first;
  }

  // Uses the longest cached prefix; listeners get its steps as if they had run.
  void takeFromCache() {
    if (cache_ == nullptr) return;
    for (std::size_t count = steps_.size() + 1; count-- > 0 && !current_.state;) {
      if (auto found = cache_->find(environment_, prefixKey(steps_, count))) current_ = std::move(*found);
    }
    for (std::size_t i = 0; i < current_.steps.size(); ++i) {
      current_.steps[i].fromCache = true;
      context_.beginStep(i, current_.steps[i].name);
      context_.endStep();
    }
  }

  // Returns the time it took, in milliseconds.
  double makeStart() {
    const Stopwatch watch;
    guarded(FOOTFALL_TEXT("environment"), [&] {
      const Recall earlier = recall(0);
      isEdited_ = earlier.before != nullptr;
      current_.state = makeInitialState(environment_, context_, earlier);
      current_.summary = summarize(*current_.state);
    });
    remember();
    returnMemory();
    return watch.wallMs();
  }

  void runStep(std::size_t index) {
    context_.checkCancelled();
    const PipelineStep& step = *steps_[index];
    StepStatistics statistics;
    statistics.name = step.filter->name;
    statistics.parameters = step.values;
    statistics.startMs = clock_.wallMs();
    statistics.in = current_.summary;
    const Text place(Pattern{"%1, %2"}, placeOf(index), statistics.name);
    guarded(place, [&] {
      context_.beginStep(index, statistics.name);
      const Stopwatch watch;
      FilterOutcome outcome = withPlace(place, [&] { return apply(step, index); });
      statistics.wallMs = watch.wallMs();
      statistics.cpuMs = watch.cpuMs();
      statistics.note = std::move(outcome.note);
      statistics.fallbacks = outcome.fallbacks;
      current_.state = std::move(outcome.state);
      current_.summary = summarize(*current_.state);
      current_.mesh = nullptr;
      current_.rounded = nullptr;
      current_.reuse.clear();
      statistics.out = current_.summary;
      current_.steps.push_back(std::move(statistics));
      remember();
      returnMemory();
      context_.endStep(context_.wantsParts() ? makePreviewMesh(*current_.state) : nullptr);
      (isBehindBlock(index) ? times_.postprocessing : times_.preprocessing) += watch.wallMs();
    });
  }

  FilterOutcome apply(const PipelineStep& step, std::size_t index) {
    try {
      Recall known = recall(index + 1);
      known.needsObstacles = needsObstacles(steps_, index + 1);
      if (makesProduct_ && index + 1 == steps_.size() && environment_->triangles.size() < kSettledAfter)
        known.meanwhile = [this](const WalkableState& state, const Adjacency& topology) {
          settled_ = settleProduct(state, topology, knownPlaces(), context_);
        };
      return applyFilter(*step.filter, step.values, current_.state, context_, known);
    } catch (const ValueError& error) {
      if (error.value >= step.columns.size()) throw;
      throw InputError(FOOTFALL_TEXT("column %1: %2"), step.columns[error.value], error.text());
    }
  }

  void runBlockAt(std::size_t first) {
    context_.checkCancelled();
    const std::size_t last = findCollapse(first);
    BlockRequest request;
    request.steps.assign(steps_.begin() + static_cast<std::ptrdiff_t>(first),
                         steps_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    request.firstStep = first;
    request.state = current_.state;
    request.summary = current_.summary;
    // Results of other processes come without the data that a later run could copy.
    if (exchange_ == nullptr) request.recall = recall(last + 1);
    request.threads = threads_;
    if (exchange_ != nullptr) {
      request.exchange = exchange_;
      request.key = environmentKey() + prefixKey(steps_, first);
      request.phasesBefore = countPhases(steps_, first);
      request.phases = countPhases(steps_, steps_.size());
    }
    guarded(Text(FOOTFALL_TEXT("%1, parallel block of %2"), placeOf(first), steps_[first]->filter->name), [&] {
      BlockOutcome outcome = withPlace(placeOf(first), [&] { return runBlock(request, clock_, context_); });
      current_.state = std::move(outcome.state);
      if (!current_.state) return;
      current_.summary = outcome.summary;
      current_.mesh = nullptr;
      current_.rounded = nullptr;
      current_.reuse = std::move(outcome.reuse);
      for (StepStatistics& step : outcome.steps) current_.steps.push_back(std::move(step));
      remember();
      // The time of post-processing so far lies between two blocks.
      times_.preprocessing += std::exchange(times_.postprocessing, 0);
      times_.partitioning += outcome.report.partitioningMs;
      times_.parallel += outcome.report.parallelMs;
      times_.merging += outcome.report.mergingMs;
      blocks_.push_back(std::move(outcome.report));
    });
  }

  // All of the environment that a clearance filter can see, and who sees it.
  [[nodiscard]] std::string environmentKey() const {
    Digest digest;
    digest.add(std::span<const Vec3>(environment_->vertices)).add(std::span<const Triangle>(environment_->triangles));
    digest.add(std::span<const std::uint8_t>(environment_->obstacleOnly)).add(environment_->bothSides);
    const Digest::Value value = digest.value();
    return FOOTFALL_VERSION " " + std::to_string(value[0]) + ' ' + std::to_string(value[1]) + '\n';
  }

  [[nodiscard]] KnownPlaces knownPlaces() const {
    return servesEdits() ? cache_->findPlaces(environment_, steps_, steps_.size()) : KnownPlaces();
  }

  std::shared_ptr<const NavigationMesh> makeProduct() {
    if (!settled_) return makeNavigationMesh(current_.state, knownPlaces(), current_.rounded, context_);
    SettledProduct settled = *std::exchange(settled_, std::nullopt);
    current_.rounded = settled.rounded;
    return makeNavigationMesh(*current_.state, std::move(settled), context_);
  }

  // True when a parallel block ends before the step.
  [[nodiscard]] bool isBehindBlock(std::size_t index) const {
    return std::any_of(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(index),
                       [](const PipelineStep* step) { return step->filter->kind == FilterKind::Collapse; });
  }

  // The place of a step for messages: steps_ are pointers into the pipeline's steps.
  [[nodiscard]] Text placeOf(std::size_t index) const {
    return placeOfStep(pipeline_, static_cast<std::size_t>(steps_[index] - pipeline_.steps.data()));
  }

  [[nodiscard]] bool servesEdits() const { return cache_ != nullptr && cache_->servesEdits(); }

  // The results of earlier runs after the first `count` steps.
  Recall recall(std::size_t count) {
    if (!servesEdits()) return {nullptr, false, current_.state.use_count() == 1};
    return {cache_->findEarlier(environment_, steps_, count), true, false};
  }

  void returnMemory(std::size_t from = kReturnedSize) const {
    if (!isEdited_ && environment_->triangles.size() >= from) returnFreedMemory();
  }

  void remember() {
    if (cache_ != nullptr) cache_->store(environment_, prefixKey(steps_, current_.steps.size()), current_);
  }

  std::shared_ptr<const Environment> environment_;
  const Pipeline& pipeline_;
  RunContext& context_;
  PrefixCache* cache_;
  std::vector<const PipelineStep*> steps_;  // the enabled ones
  CachedPrefix current_;
  bool makesProduct_ = false;
  std::optional<SettledProduct> settled_;  // product of the last state, if its filter left time for that
  bool isEdited_ = false;                  // there is the result of an environment that this one is an edit of
  int threads_;
  const Stopwatch& clock_;
  CellExchange* exchange_;
  std::vector<BlockReport> blocks_;
  RunTimes times_;
};

}  // namespace

std::vector<StatePtr> stepStates(std::shared_ptr<const Environment> environment, const Pipeline& pipeline,
                                 RunContext& context, ResultCache& cache, int threads) {
  checkRunnable(pipeline);
  const Stopwatch watch;
  return onThreads(threads, [&](int workers) {
    return Run(std::move(environment), pipeline, context, &cache.inside(), workers, watch).states();
  });
}

Partition previewPartition(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                           std::size_t step, RunContext& context, int threads) {
  checkRunnable(pipeline);
  std::vector<const PipelineStep*> steps;
  for (std::size_t i = step; i < pipeline.steps.size(); ++i) {
    if (pipeline.steps[i].enabled) steps.push_back(&pipeline.steps[i]);
    if (pipeline.steps[i].enabled && pipeline.steps[i].filter->kind == FilterKind::Collapse) break;
  }
  if (steps.empty() || steps[0]->filter->kind != FilterKind::Strategy)
    throw InputError(FOOTFALL_TEXT("step %1 is no strategy that is switched on; choose one that is"), step + 1);
  return guarded(placeOfStep(pipeline, step), [&] {
    return onThreads(threads, [&](int workers) {
      const StatePtr state = makeInitialState(environment, context);
      const StrategyInput input = strategyInput(*state, steps, workers, context);
      return withPlace(placeOfStep(pipeline, step), [&] {
        Partition partition = makePartition(steps[0]->filter->type, steps[0]->values, input);
        assignFloors(partition, input);
        return partition;
      });
    });
  });
}

}  // namespace footfall::detail

namespace footfall::detail {
namespace {

RunResult runAll(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context,
                 ResultCache* cache, CellExchange* exchange, int threads) {
  checkRunnable(pipeline);
  const Stopwatch watch;
  RunResult result = onThreads(threads, [&](int workers) {
    Run run(std::move(environment), pipeline, context, cache ? &cache->inside() : nullptr, workers, watch, exchange);
    RunResult made = run.execute();
    made.threads = exchange != nullptr ? exchange->threads() : workers;
    return made;
  });
  result.totalMs = watch.wallMs();
  result.cpuMs = watch.cpuMs();
  RunTimes& times = result.times;
  times.total = result.totalMs;
  times.overhead =
      times.total - times.preprocessing - times.partitioning - times.parallel - times.merging - times.postprocessing;
  return result;
}

}  // namespace

RunResult runTogether(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context,
                      CellExchange& exchange, int threads, ResultCache* cache) {
  try {
    return runAll(std::move(environment), pipeline, context, cache, &exchange, threads);
  } catch (const Cancelled&) {
    exchange.throwFailure();  // a process that fails stops the others
    throw;
  }
}

}  // namespace footfall::detail

namespace footfall {

RunResult runPipeline(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context,
                      ResultCache* cache, int threads) {
  return detail::runAll(std::move(environment), pipeline, context, cache, nullptr, threads);
}

}  // namespace footfall
