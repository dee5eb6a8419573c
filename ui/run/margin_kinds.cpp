// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/margin_kinds.hpp"

#include <utility>

namespace footfall::ui {

void MarginKinds::setResult(const std::shared_ptr<const RunJob>& job, const RunOutcome& outcome) {
  clear();
  if (!outcome.content.hasMixedMargins) return;
  job_ = job;
  outcome_ = outcome;
}

void MarginKinds::clear() {
  work_.stop();
  job_.reset();
  outcome_ = {};
}

void MarginKinds::find() {
  if (!job_ || work_.busy()) return;
  const auto look = [job = job_, outcome = outcome_](RunContext& context) {
    const RunResult& result = outcome.finished->result;
    const std::vector<RemovedShare> shares = removedShares(*job, result);
    const ViewContent& shown = outcome.content;
    // Without the meshes of steps, the present content shows more.
    if (shares.size() != shown.removed.size() + (shown.firstRemoval ? 1 : 0)) return shown;
    return makeContent(*job, result, dividedShares(*job, result, shares, context), shown);
  };
  const auto show = [this](const ViewContent& content) {
    const std::shared_ptr<const RunJob> job = std::exchange(job_, nullptr);
    RunOutcome outcome = std::exchange(outcome_, {});
    outcome.content = content;
    emit found(outcome, job->key);
  };
  // Memory ran out: the margins stay as they are.
  work_.start(*this, look, show, [this](const std::exception&) { clear(); });
}

}  // namespace footfall::ui
