// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/block_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>

#include "core/base/parallel.hpp"
#include "core/base/worker_arena.hpp"
#include "core/partitioning/load_balancing.hpp"

namespace footfall::detail {
namespace {

// Small faces that a thread takes at once.
constexpr std::size_t kFacesPerTake = 64;
// Floors with at least this many segments are triangulated on their own.
constexpr std::size_t kSegmentsOfLarge = 128;
// Less work than that of so many trivial floors is not worth waking a thread for.
constexpr double kWorkPerThread = 32;
// The time that an idle thread sleeps before it checks for cancelling.
constexpr std::chrono::milliseconds kIdle{2};
constexpr double kShareOfProgress = 0.9;

std::vector<CellSide> sidesOf(const CellBounds& bounds) {
  std::vector<CellSide> sides;
  for (Index axis = 0; axis < 2; ++axis) {
    if (bounds.lowerBorder[axis] >= 0) sides.push_back({{PlanLine::Border, axis, bounds.lowerBorder[axis]}, 1});
    if (bounds.upperBorder[axis] >= 0) sides.push_back({{PlanLine::Border, axis, bounds.upperBorder[axis]}, -1});
  }
  return sides;
}

std::vector<std::size_t> orderOf(const Partition& partition, const CellsElsewhere& elsewhere) {
  std::vector<double> costs;
  for (const Cell& cell : partition.cells) costs.push_back(cell.cost);
  std::vector<std::size_t> order = longestFirst(costs);
  if (elsewhere.exchange == nullptr) return order;
  const auto others =
      std::stable_partition(order.begin(), order.end(), [&](std::size_t cell) { return elsewhere.isMine[cell] != 0; });
  if (!elsewhere.exchange->merges()) order.erase(others, order.end());
  return order;
}

}  // namespace

BlockRun::BlockRun(const Partition& partition, const CellFloors& floors, const SourceMesh& mesh,
                   const std::vector<char>& walkable, CellFilters filters, std::vector<CellReport>& reports,
                   const Stopwatch& clock, RunContext& context, CellsElsewhere elsewhere)
    : partition_(partition),
      floors_(floors),
      mesh_(mesh),
      walkable_(walkable),
      filters_(std::move(filters)),
      reports_(reports),
      clock_(clock),
      context_(context),
      elsewhere_(std::move(elsewhere)),
      order_(orderOf(partition, elsewhere_)),
      cells_(partition.cells.size()),
      passed_(filters_.tests.empty() ? 0 : walkable.size(), 0),
      itemsExpected_(floors.floors.size()),
      current_(static_cast<std::size_t>(availableThreads())),
      workers_(current_.size(), nullptr),
      records_(current_.size()),
      cellsLeft_(order_.size()) {
  for (auto& cell : current_) cell = -1;
  ownLeft_ = static_cast<std::size_t>(std::count_if(
      order_.begin(), order_.end(), [this](std::size_t cell) { return isMine(static_cast<Index>(cell)); }));
  othersToTest_ = order_.size() - ownLeft_;
  for (ThreadRecord& record : records_) record.workMs.resize(filters_.names.size());
  if (filters_.clearance == nullptr) return;
  for (const Cell& cell : partition.cells) sides_.push_back(sidesOf(cell.bounds));
  Index count = 0;
  sharesOf_.assign(walkable.size(), -1);
  for (std::size_t t = 0; t < walkable.size(); ++t)
    if (walkable[t] != 0 && floors.cellCount[t] > 1) sharesOf_[t] = count++;
  shares_ = std::vector<Shares>(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < walkable.size(); ++t)
    if (sharesOf_[t] >= 0) shares_[sharesOf_[t]].cells = floors.cellCount[t];
  keepFirstCells(floors, [this](Index face, Index cell) {
    if (const Index shares = sharesOf_[face]; shares >= 0) shares_[shares].counted = cell;
  });
}

void BlockRun::run() {
  if (elsewhere_.exchange != nullptr && ownLeft_ == 0) elsewhere_.exchange->ownFinished();
  // Few floors can be much work: giants under a level full of walls.
  double useful = static_cast<double>(floors_.floors.size());
  if (filters_.clearance != nullptr) {
    double cost = 0;
    for (const Cell& cell : partition_.cells) cost += cell.cost;
    useful = std::min(std::max(useful, cost), useful * kWorkPerThread);
  }
  const auto threads = static_cast<int>(std::clamp(useful / kWorkPerThread, 1.0, static_cast<double>(current_.size())));
  if (threads == 1) {
    work();
  } else {
    forRanges(static_cast<std::size_t>(threads), 1, [&](std::size_t /*first*/, std::size_t /*last*/) { work(); });
  }
  // Floors that cells share may have been triangulated after the cell that they count for was finished.
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) reports_[cell].trianglesOut = cells_[cell].trianglesOut;
}

void BlockRun::work() {
  const int thread = threadNumber();
  if (filters_.clearance != nullptr) workers_[thread] = &filters_.clearance->worker();
  try {
    for (Join next;;) {
      if (takeJoin(next)) {
        join(next, thread);
      } else if (const std::size_t n = nextCell_.fetch_add(1); n < order_.size()) {
        begin(static_cast<Index>(order_[n]), thread);
      } else if (takeArrived(thread)) {
        continue;
      } else if (const std::size_t m = nextRest_.fetch_add(1); m < order_.size()) {
        runRest(static_cast<Index>(order_[m]), thread);
      } else if (const Index cell = cellToHelp(); cell >= 0) {
        runItems(cell, thread);
      } else {
        std::unique_lock lock(mutex_);
        if (cellsLeft_ == 0 || failed_) return;
        if (joins_.empty()) changed_.wait_for(lock, kIdle);
        context_.checkCancelled();
      }
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    changed_.notify_all();
    throw;
  }
}

// Runs the filters of single faces one after the other; then all threads may work on the cell.
void BlockRun::begin(Index cell, int thread) {
  CellState& work = cells_[cell];
  {
    const std::lock_guard lock(work.mutex);
    if (const bool isFirstPhase = reports_[cell].endMs == 0; isFirstPhase && isMine(cell)) {
      reports_[cell].thread = thread;
      reports_[cell].startMs = clock_.wallMs();
    }
  }
  current_[thread] = cell;
  const auto first = floors_.floors.begin();
  // Filters since the cells were made may have rejected some.
  std::copy_if(first + static_cast<std::ptrdiff_t>(floors_.first[cell]),
               first + static_cast<std::ptrdiff_t>(floors_.first[cell + 1]), std::back_inserter(work.floors),
               [&](Index face) { return walkable_[face] != 0; });
  ExactFallbacks count;
  for (std::size_t i = 0; i < filters_.tests.size(); ++i) {
    const double startMs = clock_.wallMs();
    context_.checkCancelled();
    const auto passes = [&](Index face) {
      if (!filters_.tests[i](face, count)) {
        if (filters_.clearance != nullptr) workers_[thread]->floors.set(face, false);
        return false;
      }
      // Cells that share a face find the same.
      std::atomic_ref(passed_[face]).store(static_cast<std::uint8_t>(i + 1), std::memory_order_relaxed);
      return true;
    };
    std::erase_if(work.floors, [&](Index face) { return !passes(face); });
    record(cell, i, thread, startMs);
  }
  if (!filters_.tests.empty()) {
    const std::lock_guard lock(mutex_);
    fallbacks_ += count;
  }
  if (!isMine(cell)) {
    --othersToTest_;
    return;
  }
  if (filters_.clearance == nullptr) {
    work.trianglesOut = work.floors.size();
    done(cell, 1);
    return;
  }
  if (!filters_.tests.empty()) {
    FloorFlags& flags = workers_[thread]->floors;
    for (const Index face : work.floors) flags.set(face, true);
  }
  sortOut(work);
  work.left += work.floors.size();
  {
    const std::lock_guard lock(mutex_);
    work.open = true;
  }
  changed_.notify_all();
  // Floors that all cells share can only be triangulated when all have had their part: the earlier, the better.
  while (work.next.load(std::memory_order_relaxed) < work.shared && takeAndRun(cell, thread)) {
  }
  if (shares_.empty() || work.rest.exchange(Rest::Ready) == Rest::Wanted) runItems(cell, thread);
  done(cell, 1);
}

// Finishes a cell whose shares are done. If they are not, the thread that began it continues by itself.
void BlockRun::runRest(Index cell, int thread) {
  if (!isMine(cell) || cells_[cell].rest.exchange(Rest::Wanted) != Rest::Ready) return;
  current_[thread] = cell;
  runItems(cell, thread);
}

// Shared floors and those that are a large share of the cell come first, each to be taken on its own.
void BlockRun::sortOut(CellState& work) const {
  constexpr double kLargeShare = 1.0 / 64;
  const auto planArea = [&](Index face) {
    const Box box = boxOf(mesh_, face);
    return (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]);
  };
  double sum = 0;
  for (const Index face : work.floors) sum += planArea(face);
  const auto begin = work.floors.begin(), end = work.floors.end();
  const auto shared = std::stable_partition(begin, end, [&](Index face) { return sharesOf_[face] >= 0; });
  const auto large = std::stable_partition(shared, end, [&](Index face) { return planArea(face) > sum * kLargeShare; });
  work.shared = static_cast<std::size_t>(shared - begin);
  work.large = static_cast<std::size_t>(large - begin);
}

void BlockRun::runItems(Index cell, int thread) {
  while (takeAndRun(cell, thread)) {
  }
}

// First all floors of a cell are clipped, then all are triangulated: either keeps to its own part of the caches. False
// when nothing is left to take.
bool BlockRun::takeAndRun(Index cell, int thread) {
  CellState& work = cells_[cell];
  std::vector<Index> floors;
  const double startMs = clock_.wallMs();
  std::size_t finished = 0;
  if (takeFloors(work, floors)) {
    finished = clipFloors(cell, floors, thread, startMs);
  } else if (takeCutFloors(work, floors)) {
    finished = meshFloors(cell, floors, *workers_[thread]);
    record(cell, filters_.tests.size(), thread, startMs);
  } else {
    return false;
  }
  const std::size_t sum = itemsDone_.fetch_add(finished, std::memory_order_relaxed);
  reportItems(sum);
  done(cell, finished);
  Join next;
  while (takeJoin(next)) join(next, thread);
  return true;
}

void BlockRun::reportItems(std::size_t done) const {
  const auto expected = static_cast<double>(std::max<std::size_t>(itemsExpected_, 1));
  context_.progress(kShareOfProgress * static_cast<double>(done) / expected);
}

bool BlockRun::takeFloors(CellState& work, std::vector<Index>& floors) {
  const std::size_t count = work.floors.size();
  if (work.next.load(std::memory_order_relaxed) >= count) return false;
  // When other threads were quicker, some small faces are taken alone, or a large one with small ones, which does no
  // harm.
  const std::size_t take = work.next.load(std::memory_order_relaxed) < work.large ? 1 : kFacesPerTake;
  const std::size_t first = work.next.fetch_add(take);
  const std::size_t last = std::min(first + take, count);
  if (first >= last) return false;
  const auto begin = work.floors.begin();
  floors.assign(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
  return true;
}

bool BlockRun::takeCutFloors(CellState& work, std::vector<Index>& floors) {
  const std::lock_guard lock(work.mutex);
  std::vector<Index>& from = work.largeCut.empty() ? work.smallCut : work.largeCut;
  const std::size_t take = std::min(from.size(), work.largeCut.empty() ? kFacesPerTake : 1);
  floors.assign(from.end() - static_cast<std::ptrdiff_t>(take), from.end());
  from.resize(from.size() - take);
  return take > 0;
}

// Returns how many of the floors are finished with that.
std::size_t BlockRun::clipFloors(Index cell, const std::vector<Index>& floors, int thread, double startMs) {
  ClearancePass::Worker& own = *workers_[thread];
  ClearancePass& pass = *filters_.clearance;
  std::vector<Index> large, small;
  std::uint64_t triangles = 0;
  for (const Index face : floors) {
    context_.checkCancelled();
    if (sharesOf_[face] >= 0) {
      clipShare(cell, face, own);
      continue;
    }
    pass.clip(face, own);
    if (const std::size_t segments = pass.segments(face); segments > 0)
      (segments < kSegmentsOfLarge ? small : large).push_back(face);
    else
      triangles += pass.mesh(face, own);
  }
  CellState& work = cells_[cell];
  work.trianglesOut.fetch_add(triangles, std::memory_order_relaxed);
  // Recorded before other threads can take the rest and finish the cell.
  record(cell, filters_.tests.size(), thread, startMs);
  if (small.empty() && large.empty()) return floors.size();
  {
    const std::lock_guard lock(work.mutex);
    work.smallCut.insert(work.smallCut.end(), small.rbegin(), small.rend());
    work.largeCut.insert(work.largeCut.end(), large.begin(), large.end());
  }
  changed_.notify_one();
  return floors.size() - small.size() - large.size();
}

std::size_t BlockRun::meshFloors(Index cell, const std::vector<Index>& floors, ClearancePass::Worker& own) {
  std::uint64_t triangles = 0;
  for (const Index face : floors) {
    context_.checkCancelled();
    triangles += filters_.clearance->mesh(face, own);
  }
  cells_[cell].trianglesOut.fetch_add(triangles, std::memory_order_relaxed);
  return floors.size();
}

void BlockRun::clipShare(Index cell, Index face, ClearancePass::Worker& own) {
  if (filters_.clearance->canShare(face)) {
    FaceShare share = filters_.clearance->clipShare(face, sides_[cell], own);
    if (elsewhere_.exchange != nullptr && elsewhere_.exchange->wantsOwn() && !share.empty()) {
      const std::lock_guard lock(cells_[cell].mutex);
      cells_[cell].parts.push_back({face, share});
    }
    if (merges()) addShare(cell, face, std::move(share));
    return;
  }
  // One cell takes the face as a whole: the first one that reaches it, or the one that all processes agree on.
  const bool isFirst = shares_[sharesOf_[face]].begun.fetch_add(1) == 0;
  if (elsewhere_.exchange != nullptr ? isWholeOf(cell, face) : isFirst) addJoin(cell, face);
}

void BlockRun::addShare(Index cell, Index face, FaceShare share) {
  Shares& all = shares_[sharesOf_[face]];
  if (!share.empty()) {
    const std::lock_guard lock(all.mutex);
    all.shares.push_back(std::move(share));
  }
  if (all.arrived.fetch_add(1) + 1 == all.cells) addJoin(cell, face);
}

void BlockRun::addJoin(Index cell, Index face) {
  ++cells_[cell].left;
  const std::lock_guard lock(mutex_);
  joins_.push_back({face, cell});
  changed_.notify_one();
}

bool BlockRun::takeJoin(Join& join) {
  const std::lock_guard lock(mutex_);
  if (joins_.empty()) return false;
  join = joins_.front();
  joins_.pop_front();
  return true;
}

// All shares of a face are there, or it was not to be cut.
void BlockRun::join(const Join& join, int thread) {
  context_.checkCancelled();
  const double startMs = clock_.wallMs();
  ClearancePass& pass = *filters_.clearance;
  ClearancePass::Worker& own = *workers_[thread];
  Shares& all = shares_[sharesOf_[join.face]];
  if (all.arrived.load() > 0)
    pass.joinShares(join.face, all.shares, own);
  else
    pass.clip(join.face, own);
  all.shares = {};
  cells_[all.counted].trianglesOut += pass.mesh(join.face, own);
  if (context_.wantsParts()) context_.part(pass.preview(std::array{join.face}));
  record(join.cell, filters_.tests.size(), thread, startMs);
  done(join.cell, 1);
}

// The cell with the most work left, among the cells that threads took last. The thread that clips a floor triangulates
// it.
Index BlockRun::cellToHelp() {
  Index best = -1;
  std::size_t most = 0;
  for (const auto& current : current_) {
    const Index cell = current;
    if (cell < 0 || !cells_[cell].open) continue;
    CellState& work = cells_[cell];
    const std::size_t begun = std::min(work.next.load(std::memory_order_relaxed), work.floors.size());
    const std::lock_guard lock(work.mutex);
    const std::size_t left = work.floors.size() - begun + work.smallCut.size() + work.largeCut.size();
    if (left <= most) continue;
    most = left;
    best = cell;
  }
  return best;
}

void BlockRun::done(Index cell, std::size_t items) {
  if (items > 0 && cells_[cell].left.fetch_sub(items) == items) finish(cell);
}

std::vector<CellReuse> BlockRun::reuse() const {
  std::vector<CellReuse> all(cells_.size());
  for (std::size_t cell = 0; cell < cells_.size() && filters_.clearance != nullptr; ++cell) {
    all[cell].floors = cells_[cell].floors.size();
    for (const Index face : cells_[cell].floors) all[cell].reused += filters_.clearance->isReused(face) ? 1 : 0;
  }
  return all;
}

double BlockRun::workMs(std::size_t filter) const {
  double sum = 0;
  for (const ThreadRecord& record : records_) sum += record.workMs[filter];
  return sum;
}

double BlockRun::workMs() const {
  double sum = 0;
  for (std::size_t i = 0; i < filters_.names.size(); ++i) sum += workMs(i);
  return sum;
}

// Joins what one thread does on one cell without a break, and without anything else in between.
void BlockRun::record(Index cell, std::size_t filter, int thread, double startMs) {
  constexpr double kBreakMs = 0.02;
  const double endMs = clock_.wallMs();
  ThreadRecord& own = records_[thread];
  own.workMs[filter] += endMs - startMs;
  const bool goesOn = own.cell == cell && own.filter == filter;
  own.cell = cell;
  own.filter = filter;
  const std::lock_guard lock(cells_[cell].mutex);
  std::vector<CellSpan>& spans = reports_[cell].spans;
  const auto same = std::find_if(spans.rbegin(), spans.rend(), [&](const CellSpan& s) { return s.thread == thread; });
  if (goesOn && startMs - same->endMs < kBreakMs)
    same->endMs = endMs;
  else
    spans.push_back({filters_.names[filter], thread, startMs, endMs});
}

void BlockRun::finish(Index cell) {
  std::shared_ptr<const NavigationMesh> mesh;
  if (context_.wantsParts() && filters_.clearance != nullptr) {
    std::vector<Index> whole = cells_[cell].floors;
    std::erase_if(whole, [&](Index face) { return sharesOf_[face] >= 0; });
    mesh = filters_.clearance->preview(whole);
  }
  std::shared_ptr<const CellReport> report;
  {
    const std::lock_guard lock(cells_[cell].mutex);
    std::sort(reports_[cell].spans.begin(), reports_[cell].spans.end(),
              [](const CellSpan& a, const CellSpan& b) { return a.startMs < b.startMs; });
    reports_[cell].trianglesOut = cells_[cell].trianglesOut;
    if (isMine(cell)) reports_[cell].endMs = clock_.wallMs();
    report = std::make_shared<const CellReport>(reports_[cell]);
  }
  if (elsewhere_.exchange != nullptr && isMine(cell)) {
    if (elsewhere_.exchange->wantsOwn()) give(cell);
    if (--ownLeft_ == 0) elsewhere_.exchange->ownFinished();
  }
  context_.cellFinished(static_cast<std::size_t>(cell), std::move(report), std::move(mesh));
  const std::lock_guard lock(mutex_);
  if (--cellsLeft_ == 0) changed_.notify_all();
}

}  // namespace footfall::detail
