// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/edit_previews.hpp"

#include <algorithm>
#include <exception>

#include "footfall/filter.hpp"

namespace footfall::ui {
namespace {

std::string nameOf(const std::string& prefix, const PipelineStep& step) {
  return prefix + std::string(step.filter->name);
}

}  // namespace

bool EditPreviews::knows(const std::string& prefix, const PipelineStep& step) const {
  return known_.contains(nameOf(prefix, step));
}

EditPreview::Surfaces EditPreviews::changes(const RunJob& job, const Pipeline& earlier) const {
  const std::vector<const PipelineStep*> before = enabledSteps(earlier);
  const std::size_t i = job.firstChanged;
  const auto rest = static_cast<std::ptrdiff_t>(i + 1);
  if (i >= before.size() || before.size() != job.steps.size() || before[i]->filter != job.steps[i]->filter ||
      before[i]->values.size() != job.steps[i]->values.size() || before[i]->values.empty() ||
      !std::equal(before.begin() + rest, before.end(), job.steps.begin() + rest,
                  [](const PipelineStep* a, const PipelineStep* b) { return *a == *b; }))
    return {};
  const auto known = known_.find(nameOf(job.prefixes[i], *before[i]));
  if (known == known_.end()) return {};
  return known->second->changes(before[i]->values, job.steps[i]->values);
}

void EditPreviews::follow(const RunJob& job, const std::shared_ptr<const NavigationMesh>& result) {
  missing_.clear();
  decltype(known_) kept;
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const PipelineStep& step = *job.steps[i];
    if (step.values.empty()) continue;
    const std::string name = nameOf(job.prefixes[i], step);
    EditedStep edited{step.filter->type, step.values, job.stepMeshes->find(job.prefixes[i]), result};
    const auto known = known_.find(name);
    if (known != known_.end() && known->second->suits(edited)) {
      kept.insert(*known);
    } else {
      missing_.emplace_back(name, std::move(edited));
    }
  }
  known_ = std::move(kept);
}

void EditPreviews::prepare(const std::shared_ptr<const Environment>& environment, const Vec3& centre) {
  for (auto& [name, step] : std::exchange(missing_, {})) {
    queue_.post([this, name = name, step = std::move(step), context = context_, environment, centre] {
      std::shared_ptr<const EditPreview> made;
      try {
        context->checkCancelled();
        made = makeEditPreview(step, environment, centre, *context);
      } catch (const std::exception&) {
        return;  // cancelled, or memory ran out: a run then shows the first change
      }
      const auto keep = [this, name, context, made] {
        if (made && context == context_) known_[name] = made;
      };
      QMetaObject::invokeMethod(this, keep, Qt::QueuedConnection);
    });
  }
}

void EditPreviews::stop() {
  context_->cancel();
  context_ = std::make_shared<RunContext>();
}

void EditPreviews::clear() {
  stop();
  known_.clear();
  missing_.clear();
}

}  // namespace footfall::ui
