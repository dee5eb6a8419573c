// The inputs of runs: the level, the list of filters, and the caches of earlier runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/document/document.hpp"
#include "ui/run/run_job.hpp"
#include "ui/run/step_meshes.hpp"

namespace footfall::ui {

/// A step that the runner would refuse before it begins.
struct InvalidStep {
  int id = 0;  ///< id of its FilterEntry
  QString place, message;
};

class RunInputs {
 public:
  /// Sets another environment, or none, and drops the caches of earlier runs.
  void setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre);
  /// Sets the same environment with a change: cached states of steps remain valid, cached meshes do not.
  void editEnvironment(std::shared_ptr<const Environment> environment);
  void setFilters(const std::vector<FilterEntry>& filters) { filters_ = filters; }
  /// Sets the largest number of threads; 0: all of the machine. Returns false when it does not change. States with
  /// another number are dropped, because their threads and cells differ.
  bool setThreads(int threads);
  /// Sets where the cells of the list's runs are run; states of another place are dropped.
  bool setPlace(const RunPlace& place);

  [[nodiscard]] const std::shared_ptr<const Environment>& environment() const { return environment_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] const std::vector<FilterEntry>& filters() const { return filters_; }
  [[nodiscard]] const std::shared_ptr<ResultCache>& cache() const { return cache_; }
  /// The list without the steps that cannot run (skipped()).
  [[nodiscard]] Pipeline pipeline() const;
  /// Ids of the enabled filters that are left out because no Vertical clearance filter runs before them.
  [[nodiscard]] std::set<int> skipped() const;
  /// The enabled steps of the list, as a key.
  [[nodiscard]] std::string key() const { return keyOf(pipeline()); }
  /// A filter of the list and the steps before it; empty for a disabled filter.
  struct PlacedStep {
    std::string prefix;
    const PipelineStep& step;
  };
  [[nodiscard]] std::optional<PlacedStep> find(int id) const;

  /// Makes a run of any pipeline.
  [[nodiscard]] std::shared_ptr<RunJob> makeJob(const Pipeline& pipeline) const;
  /// Makes a run of the list; its steps have their ids.
  [[nodiscard]] std::shared_ptr<RunJob> makeListJob() const;
  [[nodiscard]] std::optional<InvalidStep> findInvalidStep() const;

 private:
  std::shared_ptr<const Environment> environment_;
  Vec3 centre_;
  std::vector<FilterEntry> filters_;
  int threads_ = 0;
  RunPlace place_;
  // The object is replaced and not cleared, because a run that is still ending keeps the old one.
  std::shared_ptr<StepMeshes> stepMeshes_ = std::make_shared<StepMeshes>();
  std::shared_ptr<ResultCache> cache_ = std::make_shared<ResultCache>();
};

}  // namespace footfall::ui
