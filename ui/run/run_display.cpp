// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_display.hpp"

#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

// The first picture of a run is shown at once, and later ones at this interval, because drawing takes processor time
// from the run.
constexpr auto kPicturePeriod = std::chrono::milliseconds(150);
// The least time between two pictures, as a multiple of the time to draw one.
constexpr double kPictureShare = 12;
// The least interval where the change itself is on the screen already: pieces add little, and their frames take long.
constexpr auto kDetailPeriod = std::chrono::milliseconds(1000);

CellBlock soFar(const RunEventBuffer::Block& events) {
  CellBlock block{*events.made, std::vector<char>(events.cells.size(), 0), nullptr, events.ranks};
  for (std::size_t i = 0; i < events.cells.size(); ++i) {
    if (!events.cells[i]) continue;
    block.report.cells[i] = *events.cells[i];
    block.finished[i] = 1;
  }
  return block;
}

}  // namespace

void RunDisplay::clear() {
  shown_ = {};
  provisional_ = false;
  knownBlocks_ = {};
  showKnownCells();
}

void RunDisplay::setResult(const RunJob& job, const RunOutcome& outcome) {
  shown_ = {outcome.finished->result.mesh, outcome.content};
  provisional_ = false;
  knownBlocks_.follow(*outcome.finished, job.steps, job.prefixes);
}

void RunDisplay::show() {
  provisional_ = false;
  emitResult();
  showKnownCells();
}

// While other content is shown, the next result replaces it anyway.
void RunDisplay::setContent(const ViewContent& content) {
  shown_.content = content;
  if (!provisional_) emitResult();
}

void RunDisplay::restore() {
  if (std::exchange(provisional_, false)) emitResult();
  showKnownCells();
}

// A copy is emitted, because receivers may cause another result.
void RunDisplay::emitResult() {
  const ViewContent content = shown_.content;
  emit contentReady(content);
}

void RunDisplay::begin(bool changesShown) {
  shownStep_.reset();
  shownParts_ = 0;
  lastPicture_.reset();
  if (changesShown) lastPicture_ = RunEventBuffer::Clock::now();
  cellEvents_ = 0;
}

void RunDisplay::showChanges(const EditPreview::Surfaces& changes) {
  provisional_ = true;
  ViewContent content = shown_.content;
  content.changes = changes;
  emit contentReady(content);
}

void RunDisplay::showCells(const std::vector<RunEventBuffer::Block>& blocks) {
  std::size_t told = 0;
  for (const RunEventBuffer::Block& block : blocks) {
    told += 1 + static_cast<std::size_t>(
                    std::ranges::count_if(block.cells, [](const auto& cell) { return cell != nullptr; }));
  }
  if (std::exchange(cellEvents_, told) == told) return;
  CellBlocks cells;
  for (const RunEventBuffer::Block& block : blocks) cells.push_back(soFar(block));
  cellsShown_ = true;
  emit cellsChanged(cells);
}

bool RunDisplay::pictureIsDue(const RunJob& job) const {
  if (waitsForPicture()) return true;
  std::chrono::duration<double, std::milli> period = job.changes.empty() ? kPicturePeriod : kDetailPeriod;
  period = std::max(period, decltype(period)(kPictureShare * pictureMs_));
  return RunEventBuffer::Clock::now() - lastPicture_.value_or(job.begun) > period;
}

// Shows the last step that has content.
void RunDisplay::showParts(RunJob& job, const std::vector<RunEventBuffer::Step>& steps) {
  const std::size_t changed = job.firstChanged;
  if (job.changes.empty() && changed < steps.size() && steps[changed].finished) job.changes = job.changesOfStep;
  if (!job.sameEnvironment || !pictureIsDue(job)) return;  // pieces are identified by numbers of triangles
  for (std::size_t i = steps.size(); i-- > 0;) {
    const bool pieces = !steps[i].parts.empty();
    if (!pieces && !(hasResult() ? steps[i].whole.mesh != nullptr : steps[i].whole.geometry != nullptr)) continue;
    const std::size_t parts = pieces ? steps[i].parts.size() + 1 : 0;
    if (shownStep_ == i && shownParts_ == parts) return;
    shownStep_ = i;
    shownParts_ = parts;
    // Over an earlier result, only its changes are shown, and only once.
    if (!pieces && hasResult() && (job.changes.empty() || lastPicture_)) return;
    lastPicture_ = RunEventBuffer::Clock::now();
    provisional_ = true;
    emit contentReady(contentOf(job, steps[i]));
    return;
  }
}

// The content over the last finished run where there is one, with the pieces and changes of the present run; else the
// pieces or the whole result of the present run alone.
ViewContent RunDisplay::contentOf(const RunJob& job, const RunEventBuffer::Step& step) const {
  const bool pieces = !step.parts.empty();
  ViewContent content = shown_.content;
  if (pieces && hasResult()) content = withPieces(shown_, step.parts, *job.environment);
  content.changes = job.changes;
  if (hasResult()) return content;
  content.walkable.clear();
  for (const RunEventBuffer::Part& part : step.parts) content.walkable.push_back(part.geometry);
  if (!pieces) content.walkable.push_back(step.whole.geometry);
  return content;
}

void RunDisplay::showKnownCells() {
  const CellBlocks blocks = knownBlocks_.blocks();
  if (blocks.empty() && !std::exchange(cellsShown_, false)) return;
  cellsShown_ = !blocks.empty();
  emit cellsChanged(blocks);
}

}  // namespace footfall::ui
