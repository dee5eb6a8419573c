// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/edit_previews.hpp"

#include <exception>

namespace footfall::ui {

const EditPreview* EditPreviews::find(const std::string& step) const {
  const auto found = known_.find(step);
  return found == known_.end() ? nullptr : found->second.get();
}

void EditPreviews::follow(std::vector<std::pair<std::string, EditedStep>> steps) {
  missing_.clear();
  decltype(known_) kept;
  for (auto& [name, step] : steps) {
    const auto known = known_.find(name);
    if (known != known_.end() && known->second->suits(step)) {
      kept.insert(*known);
    } else {
      missing_.emplace_back(name, std::move(step));
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
        return;  // cancelled, or memory ran out: then a run shows the first change
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
