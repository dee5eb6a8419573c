// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_inputs.hpp"

#include <utility>

#include "core/pipeline/block_structure.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {

void RunInputs::setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre) {
  editEnvironment(std::move(environment));
  centre_ = centre;
  cache_ = std::make_shared<ResultCache>();
}

void RunInputs::editEnvironment(std::shared_ptr<const Environment> environment) {
  environment_ = std::move(environment);
  stepMeshes_ = std::make_shared<StepMeshes>();
}

bool RunInputs::setThreads(int threads) {
  if (std::exchange(threads_, threads) == threads) return false;
  cache_ = std::make_shared<ResultCache>();
  return true;
}

bool RunInputs::setPlace(const RunPlace& place) {
  if (place_ == place) return false;
  place_ = place;
  cache_ = std::make_shared<ResultCache>();
  return true;
}

Pipeline RunInputs::pipeline() const {
  Pipeline pipeline;
  for (const FilterEntry& entry : filters_) pipeline.steps.push_back(entry.step);
  return withoutSkipped(std::move(pipeline));
}

std::set<int> RunInputs::skipped() const {
  const Pipeline run = pipeline();
  std::set<int> ids;
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    if (filters_[i].step.enabled && !run.steps[i].enabled) ids.insert(filters_[i].id);
  }
  return ids;
}

std::optional<RunInputs::PlacedStep> RunInputs::find(int id) const {
  std::string prefix;
  const std::set<int> skipped = this->skipped();
  for (const FilterEntry& entry : filters_) {
    if (!entry.step.enabled || skipped.contains(entry.id)) continue;
    if (entry.id == id) return PlacedStep{std::move(prefix), entry.step};
    prefix = extendPrefix(prefix, entry.step);
  }
  return std::nullopt;
}

std::shared_ptr<RunJob> RunInputs::makeJob(const Pipeline& pipeline) const {
  std::shared_ptr<RunJob> job = makeRunJob(withoutSkipped(pipeline));
  job->environment = environment_;
  job->centre = centre_;
  job->threads = threads_;
  job->stepMeshes = stepMeshes_;
  job->cache = cache_;
  return job;
}

std::shared_ptr<RunJob> RunInputs::makeListJob() const {
  std::shared_ptr<RunJob> job = makeJob(pipeline());
  job->place = place_;
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    if (job->pipeline.steps[i].enabled) job->ids.push_back(filters_[i].id);
  }
  return job;
}

std::optional<InvalidStep> RunInputs::findInvalidStep() const {
  const Pipeline pipeline = this->pipeline();
  const auto error = findStructureError(pipeline);
  if (!error) return std::nullopt;
  return InvalidStep{filters_[error->step].id, coreText(placeOfStep(pipeline, error->step)), coreText(error->message)};
}

}  // namespace footfall::ui
