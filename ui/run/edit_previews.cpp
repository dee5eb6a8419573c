// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/edit_previews.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

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
      missing_.push_back({name, std::move(edited), {}, {}});
      if (step.filter->type != FilterType::Radius) continue;
      Pipeline before;
      for (std::size_t k = 0; k < i; ++k) before.steps.push_back(*job.steps[k]);
      missing_.back().makeProduct = [environment = job.environment, before, cache = job.cache,
                                     threads = job.threads](RunContext& context) {
        return runPipeline(environment, before, context, cache.get(), threads).mesh;
      };
    }
  }
  known_ = std::move(kept);
}

void EditPreviews::prepare(const std::shared_ptr<const Environment>& environment, const Vec3& centre) {
  for (Missing& wanted : missing_) {
    if (wanted.asked == context_) continue;
    wanted.asked = context_;
    queue_.post([this, missing = wanted, context = context_, environment, centre]() mutable {
      std::shared_ptr<const EditPreview> made;
      try {
        context->checkCancelled();
        if (missing.makeProduct) missing.step.product = missing.makeProduct(*context);
        made = makeEditPreview(missing.step, environment, centre, *context);
      } catch (const std::exception&) {
        return;  // cancelled, no pipeline of its own before the step, or memory ran out: a run shows the first change
      }
      const auto keep = [this, name = missing.name, context, made] {
        if (!made || context != context_) return;
        known_[name] = made;
        std::erase_if(missing_, [&](const Missing& done) { return done.name == name; });
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
