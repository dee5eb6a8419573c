// SPDX-License-Identifier: GPL-3.0-or-later
// RunController's previews of edits: what can be shown of an edit without a run.
#include <algorithm>
#include <utility>

#include "ui/run/run_job.hpp"

namespace footfall::ui {

// An edit of one parameter, which stands for most of what somebody does here while looking at the view.
void RunController::preview(Job& job) const {
  if (!finished_ || !shown_.mesh || !job.sameEnvironment) return;
  std::vector<const PipelineStep*> before;
  for (const PipelineStep& step : finished_->pipeline.steps) {
    if (step.enabled) before.push_back(&step);
  }
  const std::size_t i = job.firstChanged;
  const auto rest = static_cast<std::ptrdiff_t>(i + 1);
  if (i >= before.size() || before.size() != job.steps.size() || before[i]->filter != job.steps[i]->filter ||
      before[i]->values.size() != 1 ||
      !std::equal(before.begin() + rest, before.end(), job.steps.begin() + rest,
                  [](const PipelineStep* a, const PipelineStep* b) { return *a == *b; }))
    return;
  const EditPreview* known = editPreviews_.find(job.prefixes[i] + std::string(before[i]->filter->name));
  if (known) job.changes = known->changes(before[i]->values[0], job.steps[i]->values[0]);
}

void RunController::keepPreviews(const Job& job) {
  std::vector<std::pair<std::string, EditedStep>> steps;
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const PipelineStep& step = *job.steps[i];
    if (step.values.size() != 1) continue;
    steps.emplace_back(
        job.prefixes[i] + std::string(step.filter->name),
        EditedStep{step.filter->type, step.values[0], job.previews->find(job.prefixes[i]), finished_->result.mesh});
  }
  editPreviews_.follow(std::move(steps));
  frameTimer_.start(kFrameWait);
}

}  // namespace footfall::ui
