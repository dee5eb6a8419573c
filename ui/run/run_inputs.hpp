// What runs compute: the level, the list of filters, and what earlier runs left for later ones.
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
  int id = 0;  ///< of its FilterEntry
  QString place, message;
};

class RunInputs {
 public:
  /// Another environment, or none: nothing that earlier runs left belongs to it.
  void setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre);
  /// The same with something changed: states of steps serve runs on it, meshes of steps do not.
  void editEnvironment(std::shared_ptr<const Environment> environment);
  void setFilters(const std::vector<FilterEntry>& filters) { filters_ = filters; }
  /// So many threads at most; 0: as many as the machine has. False when that is so already. States that were computed
  /// with another number are forgotten: their threads and cells are not the same.
  bool setThreads(int threads);
  /// Where the cells of the list's runs are run; likewise.
  bool setPlace(const RunPlace& place);

  [[nodiscard]] const std::shared_ptr<const Environment>& environment() const { return environment_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] const std::vector<FilterEntry>& filters() const { return filters_; }
  [[nodiscard]] const std::shared_ptr<ResultCache>& cache() const { return cache_; }
  /// The list without the steps that cannot run (skipped()).
  [[nodiscard]] Pipeline pipeline() const;
  /// Ids of the enabled filters that are left out because no Vertical clearance filter runs before them.
  [[nodiscard]] std::set<int> skipped() const;
  /// The enabled steps of the list.
  [[nodiscard]] std::string key() const { return keyOf(pipeline()); }
  /// The steps before a filter of the list, and the filter; nothing for one that is switched off.
  struct PlacedStep {
    std::string prefix;
    const PipelineStep& step;
  };
  [[nodiscard]] std::optional<PlacedStep> find(int id) const;

  /// A run of any pipeline.
  [[nodiscard]] std::shared_ptr<RunJob> makeJob(const Pipeline& pipeline) const;
  /// A run of the list; its steps have their ids.
  [[nodiscard]] std::shared_ptr<RunJob> makeListJob() const;
  [[nodiscard]] std::optional<InvalidStep> findInvalidStep() const;

 private:
  std::shared_ptr<const Environment> environment_;
  Vec3 centre_;
  std::vector<FilterEntry> filters_;
  int threads_ = 0;
  RunPlace place_;
  // Replaced and not cleared: a run that is still ending keeps the old ones.
  std::shared_ptr<StepMeshes> stepMeshes_ = std::make_shared<StepMeshes>();
  std::shared_ptr<ResultCache> cache_ = std::make_shared<ResultCache>();
};

}  // namespace footfall::ui
