// SPDX-License-Identifier: GPL-3.0-or-later
// RunController's picture of a run: what the window is told while it goes on and once it has finished.
#include <algorithm>
#include <utility>

#include "core/base/parallel_ranges.hpp"
#include "ui/base/filter_text.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/run_job.hpp"
#include "ui/view/coarse_geometry.hpp"

namespace footfall::ui {
namespace {

constexpr auto kDrainPeriod = std::chrono::milliseconds(100);  // between two updates of the window
constexpr auto kWatchPeriod = std::chrono::milliseconds(10);   // the same, before there is anything to see of a run
// What a run shows first, it shows at once; then not more often than this: drawing takes time from computing.
constexpr auto kPicturePeriod = std::chrono::milliseconds(150);
// So many times what drawing takes lie between two pictures at least.
constexpr double kPictureShare = 5;
// The same where the change itself is on the screen already: pieces tell little more, and their frames are long ones.
constexpr auto kDetailPeriod = std::chrono::milliseconds(1000);
// What takes less is over before anybody has read how far it is, and each repaint of the window takes time from it.
constexpr auto kProgressAfter = std::chrono::milliseconds(150);
constexpr double kSameArea = 1 - 1e-9;  // areas in summaries are rounded

double milliseconds(RunEventBuffer::Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

CellBlock soFar(const RunEventBuffer::Block& events) {
  CellBlock block{*events.made, std::vector<char>(events.cells.size(), 0), nullptr};
  for (std::size_t i = 0; i < events.cells.size(); ++i) {
    if (!events.cells[i]) continue;
    block.report.cells[i] = *events.cells[i];
    block.finished[i] = 1;
  }
  return block;
}

// In [0, 1], by cost; a cell of no cost is work as well.
double shareDone(const RunEventBuffer::Block& block) {
  double done = 0;
  double all = 0;
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const double cost = block.made->cells[i].cost + 1;
    all += cost;
    if (block.cells[i]) done += cost;
  }
  return all > 0 ? done / all : 0;
}

struct BlockPlace {
  bool block = false;  // the step is one of a block that runs
  bool waits = false;  // for the cells
  double fraction = 0;
  QString text;
};

// The filters of a block run at the same time, one cell after the other; Collapse begins when all have ended.
BlockPlace placeInBlock(std::size_t step, const std::vector<RunEventBuffer::Step>& steps,
                        const std::vector<RunEventBuffer::Block>& blocks) {
  for (const RunEventBuffer::Block& block : blocks) {
    const BlockReport& made = *block.made;
    if (step < made.firstStep || step > made.lastStep) continue;
    const auto finished = std::ranges::count_if(block.cells, [](const auto& cell) { return cell != nullptr; });
    const auto all = static_cast<std::ptrdiff_t>(block.cells.size());
    BlockPlace place{true, step == made.lastStep && finished < all, shareDone(block), {}};
    // Progress within cells is told of the block's last filter, for all.
    if (made.lastStep - 1 < steps.size()) place.fraction = std::max(place.fraction, steps[made.lastStep - 1].fraction);
    if (step == made.firstStep) place.fraction = 1;
    if (step == made.lastStep) place.fraction = 0;
    place.text = finished == all ? RunController::tr("Putting the cells together")
                 : all == 1      ? RunController::tr("%1 of 1 cell finished").arg(finished)
                                 : RunController::tr("%1 of %2 cells finished").arg(finished).arg(all);
    return place;
  }
  return {};
}

}  // namespace

// In place of what a run that did not finish has shown.
void RunController::showLastResult() {
  if (std::exchange(provisional_, false)) emit contentReady(shown_.content);
}

ViewContent RunController::makeContent(const Job& job, const RunResult& result) {
  ViewContent content;
  if (result.mesh) content.environmentLayers = makeEnvironmentLayers(*result.mesh, *job.environment);
  const EnvironmentLayers* layers = content.environmentLayers.get();
  std::vector<MeshPtr> before;
  for (std::size_t i = 0; i < job.steps.size(); ++i) {
    const RemovalStyle* style = removalStyle(job.steps[i]->filter->type);
    if (!style || result.steps[i].out.area >= result.steps[i].in.area * kSameArea) continue;  // it removed nothing
    if (!content.firstRemoval) {
      content.firstRemoval = style;
      continue;  // the environment's own floors stand for what was there before
    }
    if (const MeshPtr mesh = job.previews->find(job.prefixes[i])) {
      before.push_back(mesh);
      content.removed.push_back({style, nullptr});
    }
  }
  if (result.mesh) content.walkable.emplace_back();
  if (result.mesh) {
    std::vector<const NavigationMesh*> meshes;
    for (const MeshPtr& mesh : before) meshes.push_back(mesh.get());
    content.floorStates = makeFloorStates(*job.environment, *result.mesh, meshes);
  }
  // The result, which takes longest, first.
  forRanges(before.size() + content.walkable.size(), 1, [&](std::size_t i, std::size_t) {
    if (i < content.walkable.size()) {
      content.walkable[i] = makeMeshGeometry(*result.mesh, job.centre, std::nullopt, layers);
      return;
    }
    const std::size_t k = i - content.walkable.size();
    content.removed[k].before = makeMeshGeometry(*before[k], job.centre, content.removed[k].style->paint, layers);
  });
  return content;
}

void RunController::scheduleDrain() {
  if (!job_ || drainTimer_.isActive()) return;
  const auto period = waitsForPicture() ? kWatchPeriod : kDrainPeriod;
  const auto due = std::chrono::ceil<std::chrono::milliseconds>(drained_ + period - RunEventBuffer::Clock::now());
  drainTimer_.start(std::max(due, std::chrono::milliseconds(0)));
}

void RunController::drain() {
  if (!job_) return;
  drained_ = RunEventBuffer::Clock::now();
  const std::vector<RunEventBuffer::Step> steps = job_->events->fetch();
  const std::vector<RunEventBuffer::Block> blocks = job_->events->blocks();
  takeStatuses(steps, blocks);
  if (job_) takeCells(blocks);
  if (!job_) return;  // somebody who heard of them has cancelled
  const std::size_t changed = job_->firstChanged;
  if (job_->changes.empty() && changed < steps.size() && steps[changed].finished) job_->changes = job_->changesOfStep;
  const auto last = job_->lastPicture ? *job_->lastPicture : job_->begun;
  std::chrono::duration<double, std::milli> period = job_->changes.empty() ? kPicturePeriod : kDetailPeriod;
  period = std::max(period, decltype(period)(kPictureShare * pictureMs_));
  if (waitsForPicture() || RunEventBuffer::Clock::now() - last > period) showParts(steps);
}

void RunController::takeStatuses(const std::vector<RunEventBuffer::Step>& steps,
                                 const std::vector<RunEventBuffer::Block>& blocks) {
  double done = 0;
  QString text = tr("Finishing");
  for (std::size_t i = 0; i < steps.size() && i < job_->ids.size(); ++i) {
    const RunEventBuffer::Step& step = steps[i];
    StepStatus& status = statuses_[job_->ids[i]];
    if (step.finished) takeTime(i, step, false, 1);
    if (!step.finished) {
      const BlockPlace place = placeInBlock(i, steps, blocks);
      if (place.waits) continue;  // as it was
      takeTime(i, step, place.block, place.block ? place.fraction : step.fraction);
      status.state = StepState::Running;
      status.fraction = place.block ? place.fraction : step.fraction;
      text = place.block ? place.text : filterText(job_->steps[i]->filter->label);
      done += status.fraction;
      continue;
    }
    done += 1;
    const bool current = status.state == StepState::Done || status.state == StepState::Cached;
    if (current && status.prefix == job_->prefixes[i + 1]) continue;
    status.state = StepState::Done;
    status.prefix = job_->prefixes[i + 1];
    if (step.whole.mesh) {
      status.wallMs = milliseconds(step.ended - step.started);
      status.trianglesOut = step.whole.mesh->triangles.size();
    }
  }
  if (drained_ - job_->begun > kProgressAfter) {
    emit progressed(done / static_cast<double>(job_->ids.size() + 1), text);
    emit statusChanged();
  }
}

// Told when something about cells is new.
void RunController::takeCells(const std::vector<RunEventBuffer::Block>& blocks) {
  std::size_t told = 0;
  for (const RunEventBuffer::Block& block : blocks) {
    told += 1 + static_cast<std::size_t>(
                    std::ranges::count_if(block.cells, [](const auto& cell) { return cell != nullptr; }));
  }
  if (std::exchange(job_->cellsTold, told) == told) return;
  CellBlocks cells;
  for (const RunEventBuffer::Block& block : blocks) cells.push_back(soFar(block));
  cellsShown_ = true;
  emit cellsChanged(cells);
}

// Without an earlier result, the steps on the way would only flicker past.
bool RunController::waitsForPicture() const { return shown_.mesh && !job_->lastPicture; }

// The last step that has something to show.
void RunController::showParts(const std::vector<RunEventBuffer::Step>& steps) {
  if (!job_->sameEnvironment) return;  // pieces are put in by numbers of triangles
  for (std::size_t i = steps.size(); i-- > 0;) {
    const bool pieces = !steps[i].parts.empty();
    if (!pieces && !(shown_.mesh ? steps[i].whole.mesh != nullptr : steps[i].whole.geometry != nullptr)) continue;
    const std::size_t parts = pieces ? steps[i].parts.size() + 1 : 0;
    if (job_->shownStep == i && job_->shownParts == parts) return;
    job_->shownStep = i;
    job_->shownParts = parts;
    // In front of an earlier result, only what changes it is worth showing, and that once.
    if (!pieces && shown_.mesh && (job_->changes.empty() || job_->lastPicture)) return;
    const ViewContent content = contentOfStep(steps[i]);
    job_->lastPicture = RunEventBuffer::Clock::now();
    provisional_ = true;
    emit contentReady(content);  // last: who hears it may cancel
    return;
  }
}

// In front of the last finished run where there is one, its pieces and what has changed; else its pieces or its whole
// result alone.
ViewContent RunController::contentOfStep(const RunEventBuffer::Step& step) const {
  const bool pieces = !step.parts.empty();
  ViewContent content = shown_.content;
  if (pieces && shown_.mesh) content = withPieces(shown_, step.parts, *job_->environment);
  content.changes = job_->changes;
  if (shown_.mesh) return content;
  content.walkable.clear();
  for (const RunEventBuffer::Part& part : step.parts) content.walkable.push_back(part.geometry);
  if (!pieces) content.walkable.push_back(step.whole.geometry);
  return content;
}

// The cells of the last finished run.
void RunController::showLastCells() {
  const CellBlocks blocks = finished_ ? knownBlocks_.blocks() : CellBlocks();
  if (blocks.empty() && !std::exchange(cellsShown_, false)) return;
  cellsShown_ = !blocks.empty();
  emit cellsChanged(blocks);
}

}  // namespace footfall::ui
