// The cells of a pass that other processes run: their shares arrive, and own ones are given to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "core/pipeline/block_run.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

// True when the floor belongs to this cell; it is shared but must not be cut into parts.
bool BlockRun::isWholeOf(Index cell, Index face) const {
  return shares_[sharesOf_[face]].counted == cell && !filters_.clearance->canShare(face);
}

// Shares that have arrived wait until the floors of all cells are known.
bool BlockRun::takeArrived(int thread) {
  if (elsewhere_.exchange == nullptr || !merges() || othersToTest_ > 0) return false;
  const std::optional<ArrivedShare> arrived = elsewhere_.exchange->take();
  if (!arrived) return false;
  context_.checkCancelled();
  try {
    addArrived(*arrived, thread);
  } catch (const BadBytes& error) {
    throw RunError(FOOTFALL_TEXT("the share of cell %1 that arrived cannot be used (%2); give all processes the "
                                 "same version of the program"),
                   arrived->cell + 1, std::string(error.what()));
  }
  for (Join next; takeJoin(next);) join(next, thread);
  return true;
}

void BlockRun::addArrived(const ArrivedShare& arrived, int thread) {
  const Index cell = arrived.cell;
  if (cell < 0 || static_cast<std::size_t>(cell) >= cells_.size() || isMine(cell) ||
      cells_[cell].rest.exchange(Rest::Ready) == Rest::Ready)
    throw BadBytes("nobody waits for it");
  CellShare share = elsewhere_.reader->read(cell, arrived.bytes);
  addFaces(cell, share);
  if (arrived.hasTimes) addTimes(cell, share.times, arrived, thread);
  CellState& work = cells_[cell];
  const std::size_t sum = itemsDone_.fetch_add(work.floors.size(), std::memory_order_relaxed);
  reportItems(sum);
  done(cell, 1);
}

void BlockRun::addFaces(Index cell, CellShare& share) {
  CellState& work = cells_[cell];
  const auto isDivided = [&](Index face) { return sharesOf_[face] >= 0 && filters_.clearance->canShare(face); };
  for (FaceResult& result : share.faces)
    filters_.clearance->setResult(result.face, std::move(result.cuts), std::move(result.mesh));
  auto part = share.parts.begin();
  std::uint64_t triangles = 0;
  for (const Index face : work.floors) {
    if (isDivided(face)) {
      const bool hasPart = part != share.parts.end() && part->face == face;
      addShare(cell, face, hasPart ? std::move(part->share) : FaceShare());
      if (hasPart) ++part;
    } else if (sharesOf_[face] < 0 || isWholeOf(cell, face)) {
      triangles += filters_.clearance->triangles(face);
    }
  }
  work.trianglesOut += triangles;
}

void BlockRun::addTimes(Index cell, const ShareTimes& times, const ArrivedShare& arrived, int thread) {
  const std::lock_guard lock(cells_[cell].mutex);
  CellReport& report = reports_[cell];
  report.thread = times.thread + arrived.firstThread;
  report.startMs = times.startMs + arrived.shiftMs;
  report.endMs = times.endMs + arrived.shiftMs;
  // Time that a filter took elsewhere counts as its time, too.
  for (const ShareTimes::Span& span : times.spans) records_[thread].workMs[span.filter] += span.endMs - span.startMs;
  for (const ShareTimes::Span& span : times.spans)
    report.spans.push_back({filters_.names[span.filter], span.thread + arrived.firstThread,
                            span.startMs + arrived.shiftMs, span.endMs + arrived.shiftMs});
}

// All of the cell is done, but for floors that wait for parts of other cells.
void BlockRun::give(Index cell) {
  CellShare share;
  CellState& work = cells_[cell];
  for (const Index face : work.floors) {
    if (sharesOf_[face] >= 0 && !isWholeOf(cell, face)) continue;
    if (const auto& cuts = filters_.clearance->cutsOf(face))
      share.faces.push_back({face, cuts, filters_.clearance->meshOf(face)});
  }
  {
    const std::lock_guard lock(work.mutex);
    share.parts = std::move(work.parts);
    const CellReport& report = reports_[cell];
    share.times = {report.thread, report.startMs, report.endMs, {}};
    for (const CellSpan& span : report.spans) {
      const auto name = std::find(filters_.names.begin(), filters_.names.end(), span.filter);
      if (name != filters_.names.end())
        share.times.spans.push_back(
            {static_cast<std::size_t>(name - filters_.names.begin()), span.thread, span.startMs, span.endMs});
    }
  }
  elsewhere_.exchange->give(cell, encodeCellShare(share));
}

}  // namespace footfall::detail
