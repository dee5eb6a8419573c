// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_follower.hpp"

#include <QCoreApplication>
#include <algorithm>

#include "footfall/filter.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/run/run_progress.hpp"

namespace footfall::ui {
namespace {

constexpr auto kFetchPeriod = std::chrono::milliseconds(100);  // between two updates of the window
constexpr auto kLongPeriod = std::chrono::milliseconds(250);   // interval for runs that have taken a second
constexpr auto kWatchPeriod = std::chrono::milliseconds(10);   // interval before a run has anything to show
// Shorter runs show no progress: they end before anybody has read it, and each repaint of the window takes time from
// them.
constexpr auto kProgressAfter = std::chrono::milliseconds(150);

}  // namespace

RunFollower::RunFollower(StepStatuses& statuses, RunForecast& forecast, RunDisplay& display)
    : statuses_(statuses), forecast_(forecast), display_(display) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &RunFollower::fetch);
}

void RunFollower::follow(const std::shared_ptr<RunJob>& job) {
  listenTo(*job, [this] { QMetaObject::invokeMethod(this, &RunFollower::scheduleFetch, Qt::QueuedConnection); });
  job_ = job;
}

void RunFollower::scheduleFetch() {
  if (!job_ || timer_.isActive()) return;
  const auto usual = fetched_ - job_->begun > std::chrono::seconds(1) ? kLongPeriod : kFetchPeriod;
  const auto period = display_.waitsForPicture() ? kWatchPeriod : usual;
  const auto due = std::chrono::ceil<std::chrono::milliseconds>(fetched_ + period - RunEventBuffer::Clock::now());
  timer_.start(std::max(due, std::chrono::milliseconds(0)));
}

void RunFollower::fetch() {
  if (!job_) return;
  fetched_ = RunEventBuffer::Clock::now();
  const std::vector<RunEventBuffer::Step> steps = job_->events->fetch();
  const std::vector<RunEventBuffer::Block> blocks = job_->events->blocks();
  takeStatuses(steps, blocks);
  if (job_) display_.showCells(blocks);
  if (job_) display_.showParts(*job_, steps);
}

void RunFollower::fetchLast() {
  if (!job_) return;
  fetched_ = RunEventBuffer::Clock::now();
  takeStatuses(job_->events->fetch(), job_->events->blocks());
}

std::optional<std::chrono::milliseconds> RunFollower::remaining() const {
  return job_ ? RunForecast::remaining(*job_, fetched_) : std::nullopt;
}

void RunFollower::takeStatuses(const std::vector<RunEventBuffer::Step>& steps,
                               const std::vector<RunEventBuffer::Block>& blocks) {
  double done = 0;
  QString text = QCoreApplication::translate("footfall::ui::RunController", "Finishing");
  for (std::size_t i = 0; i < steps.size() && i < job_->ids.size(); ++i) {
    const RunEventBuffer::Step& step = steps[i];
    if (step.finished) {
      forecast_.take(*job_, i, step, false, 1, fetched_);
      statuses_.finish(i, step);
      done += 1;
      continue;
    }
    const BlockPlace place = placeInBlock(i, steps, blocks);
    if (place.waits) continue;  // the state does not change
    const double fraction = place.block ? place.fraction : step.fraction;
    statuses_.run(i, fraction);
    forecast_.take(*job_, i, step, place.block, fraction, fetched_);
    text = place.block ? place.text : filterText(job_->steps[i]->filter->label);
    done += fraction;
  }
  if (fetched_ - job_->begun > kProgressAfter) {
    emit progressed(done / static_cast<double>(job_->ids.size() + 1), text);
    emit statusChanged();
  }
}

}  // namespace footfall::ui
