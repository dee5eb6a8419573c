// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/timeline.hpp"

#include <algorithm>
#include <tuple>

#include "core/partitioning/load_balancing.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr double kPause = 0.05;  // ms; between two filters of a cell nobody is idle for so long

struct Work {
  std::optional<CellId> cell;
  const CellSpan* span = nullptr;
};

std::size_t numberOf(const std::string& filter, std::vector<std::string>& filters) {
  const auto found = std::ranges::find(filters, filter);
  if (found != filters.end()) return static_cast<std::size_t>(found - filters.begin());
  filters.push_back(filter);
  return filters.size() - 1;
}

// They follow each other, with pauses in between that belong to none: merging begins when the last cell has ended.
void addBands(const BlockReport& report, std::vector<Timeline::Band>& bands) {
  const double cut = report.startMs + report.partitioningMs;
  double joined = cut + report.parallelMs;
  for (const CellReport& cell : report.cells) {
    for (const CellSpan& span : cell.spans) joined = std::max(joined, span.endMs);
  }
  for (const CellSpan& span : report.shared) joined = std::max(joined, span.endMs);
  bands.push_back({Timeline::Phase::Partitioning, report.startMs, cut});
  bands.push_back({Timeline::Phase::Parallel, cut, joined});
  bands.push_back({Timeline::Phase::Merging, joined, joined + report.mergingMs});
}

void addBars(std::vector<Work>& work, Timeline& timeline) {
  std::ranges::sort(work, [](const Work& a, const Work& b) {
    return std::tie(a.span->thread, a.span->startMs, a.span->endMs) <
           std::tie(b.span->thread, b.span->startMs, b.span->endMs);
  });
  for (const Work& piece : work) {
    const CellSpan& span = *piece.span;
    const bool continues = !timeline.bars.empty() && timeline.bars.back().lane == span.thread &&
                           timeline.bars.back().cell == piece.cell && piece.cell &&
                           span.startMs - timeline.bars.back().end <= kPause;
    if (!continues) timeline.bars.push_back({piece.cell, span.thread, span.startMs, span.endMs, {}});
    Timeline::Bar& bar = timeline.bars.back();
    bar.end = std::max(bar.end, span.endMs);
    bar.segments.push_back({numberOf(span.filter, timeline.filters), span.startMs, span.endMs});
  }
}

}  // namespace

const Timeline::Bar* Timeline::at(int lane, double time) const {
  const auto after = std::ranges::upper_bound(bars, std::pair{lane, time}, {}, [](const Bar& bar) {
    return std::pair{bar.lane, bar.start};
  });
  if (after == bars.begin()) return nullptr;
  const Bar& bar = *(after - 1);
  return bar.lane == lane && time <= bar.end ? &bar : nullptr;
}

Timeline planTimeline(const CellBlock& block, std::size_t number, int threads) {
  Timeline timeline;
  timeline.planned = true;
  timeline.lanes = threads;
  std::vector<double> costs;
  for (const CellReport& cell : block.report.cells) costs.push_back(cell.cost);
  const LoadBalance balance = assignLongestFirst(costs, static_cast<std::size_t>(threads));
  for (int lane = 0; lane < threads; ++lane) {
    double time = 0;
    for (const std::size_t cell : balance.bins[static_cast<std::size_t>(lane)]) {
      timeline.bars.push_back({CellId{number, cell}, lane, time, time + costs[cell], {}});
      time += costs[cell];
    }
    timeline.end = std::max(timeline.end, time);
  }
  timeline.bands.push_back({Timeline::Phase::Parallel, 0, timeline.end});
  return timeline;
}

Timeline makeTimeline(const CellBlocks& blocks, std::size_t shown) {
  Timeline timeline;
  if (shown >= blocks.size()) return timeline;
  std::vector<Work> work;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const CellBlock& block = blocks[b];
    if (block.run != blocks[shown].run) continue;  // its times count from another beginning
    timeline.lanes = std::max(timeline.lanes, block.threads());
    addBands(block.report, timeline.bands);
    for (std::size_t c = 0; c < block.report.cells.size(); ++c) {
      if (!block.finished[c]) continue;
      for (const CellSpan& span : block.report.cells[c].spans) work.push_back({CellId{b, c}, &span});
    }
    for (const CellSpan& span : block.report.shared) work.push_back({std::nullopt, &span});
  }
  std::ranges::sort(work, {}, [](const Work& piece) { return piece.span->startMs; });
  for (const Work& piece : work) numberOf(piece.span->filter, timeline.filters);  // numbered as they come
  addBars(work, timeline);
  bool first = true;
  const auto cover = [&](double start, double end) {
    timeline.start = first ? start : std::min(timeline.start, start);
    timeline.end = first ? end : std::max(timeline.end, end);
    first = false;
  };
  for (const Timeline::Band& band : timeline.bands) cover(band.start, band.end);
  for (const Timeline::Bar& bar : timeline.bars) cover(bar.start, bar.end);
  return timeline;
}

}  // namespace footfall::ui
