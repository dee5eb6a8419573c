// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_event_buffer.hpp"

#include <algorithm>
#include <utility>

namespace footfall::ui {

void RunEventBuffer::add(const RunEvent& event, std::shared_ptr<const NavigationMeshGeometry> geometry) {
  bool notify = false;
  {
    const std::scoped_lock lock(mutex_);
    if (event.step >= steps_.size()) {
      if (event.kind != RunEvent::Kind::StepStarted) return;
      steps_.resize(event.step + 1);
    }
    Step& step = steps_[event.step];
    switch (event.kind) {
      case RunEvent::Kind::StepStarted:
        step.started = Clock::now();
        break;
      case RunEvent::Kind::Progress:
        step.fraction = std::max(step.fraction, event.fraction);
        break;
      case RunEvent::Kind::CellsMade:
        if (event.block) blocks_.push_back({event.block, {event.block->cells.size(), nullptr}});
        break;
      case RunEvent::Kind::CellFinished:
        addCell(event, std::move(geometry));
        break;
      case RunEvent::Kind::PartReady:
        if (event.part) step.parts.push_back({event.part, std::move(geometry), {}});
        break;
      case RunEvent::Kind::StepFinished:
        step.finished = true;
        step.ended = Clock::now();
        step.whole = {event.part, std::move(geometry), {}};
        step.parts.clear();
        break;
    }
    notify = !notified_;
    notified_ = true;
  }
  if (notify) notify_();
}

void RunEventBuffer::addCell(const RunEvent& event, std::shared_ptr<const NavigationMeshGeometry> geometry) {
  if (blocks_.empty() || event.cell >= blocks_.back().cells.size() || !event.cellReport) return;
  blocks_.back().cells[event.cell] = event.cellReport;
  blocks_.back().ranks = ranks_;
  if (event.part) steps_[event.step].parts.push_back({event.part, std::move(geometry), event.cellReport->bounds});
}

void RunEventBuffer::setRanks(CellRanks ranks) {
  const std::scoped_lock lock(mutex_);
  ranks_ = std::move(ranks);
}

std::vector<RunEventBuffer::Block> RunEventBuffer::blocks() const {
  const std::scoped_lock lock(mutex_);
  return blocks_;
}

std::vector<RunEventBuffer::Step> RunEventBuffer::fetch() {
  const std::scoped_lock lock(mutex_);
  notified_ = false;
  return steps_;
}

}  // namespace footfall::ui
