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
  const auto found = editPreviews_.find(job.prefixes[i] + std::string(before[i]->filter->name));
  if (found == editPreviews_.end()) return;
  job.changes = found->second->changes(before[i]->values[0], job.steps[i]->values[0]);
}

// What depends on nothing that is new in this run is still true; the rest is made anew, once the result is seen.
void RunController::keepPreviews(const Job& job) {
  EditPreviews kept;
  missing_.clear();
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const PipelineStep& step = *job.steps[i];
    if (step.values.size() != 1) continue;
    const std::string key = job.prefixes[i] + std::string(step.filter->name);
    const EditedStep edited{step.filter->type, step.values[0], job.previews->find(job.prefixes[i]),
                            finished_->result.mesh};
    const auto known = editPreviews_.find(key);
    if (known != editPreviews_.end() && known->second->suits(edited)) {
      kept.insert(*known);
    } else {
      missing_.emplace_back(key, edited);
    }
  }
  editPreviews_ = std::move(kept);
  frameTimer_.start(kFrameWait);
}

// In the background, as long as no run wants the processors.
void RunController::preparePreviews() {
  for (auto& [key, step] : std::exchange(missing_, {})) {
    preparations_.post([this, key, step, context = preparing_, environment = environment_, centre = centre_] {
      std::shared_ptr<const EditPreview> made;
      try {
        context->checkCancelled();
        made = makeEditPreview(step, environment, centre, *context);
      } catch (const std::exception&) {
        return;  // cancelled, or memory ran out: then a run shows the first change
      }
      const auto keep = [this, key, context, made] {
        if (made && context == preparing_) editPreviews_[key] = made;
      };
      QMetaObject::invokeMethod(this, keep, Qt::QueuedConnection);
    });
  }
}

}  // namespace footfall::ui
