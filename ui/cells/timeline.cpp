// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/timeline.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/partitioning/load_balancing.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr double kPause = 0.05;  // ms; shorter pauses between two filters of a cell do not count as idle

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

// Bands follow each other with pauses that belong to none: merging begins when the last cell has ended.
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

Timeline::Serial::Kind kindOf(RunPart::Kind kind) {
  switch (kind) {
    case RunPart::Kind::Start:
      return Timeline::Serial::Kind::Start;
    case RunPart::Kind::Step:
      return Timeline::Serial::Kind::Step;
    case RunPart::Kind::Finish:
      break;
  }
  return Timeline::Serial::Kind::Finish;
}

// The parts cover the run from its beginning to its end: a gap between two parts is a part too.
void addSerial(const RunFigures& run, Timeline& timeline) {
  constexpr double kGap = 0.5;  // in ms; shorter gaps are errors of the clock
  std::vector<Timeline::Serial>& serial = timeline.serial;
  std::vector<std::pair<double, double>> covered;
  for (const RunPart& part : run.parts)
    serial.push_back({kindOf(part.kind), part.filter, part.startMs, part.endMs, part.cpuMs});
  for (const Timeline::Band& band : timeline.bands) {
    covered.emplace_back(band.start, band.end);
    if (band.phase == Timeline::Phase::Parallel || band.end <= band.start) continue;
    const bool cuts = band.phase == Timeline::Phase::Partitioning;
    serial.push_back(
        {cuts ? Timeline::Serial::Kind::Partitioning : Timeline::Serial::Kind::Merging, {}, band.start, band.end, -1});
  }
  for (const RunPart& part : run.parts) covered.emplace_back(part.startMs, part.endMs);
  std::ranges::sort(covered);
  double end = 0;
  if (!run.parts.empty()) covered.emplace_back(run.times.total, run.times.total);
  for (const auto& [from, to] : covered) {
    if (!run.parts.empty() && from - end > kGap) serial.push_back({Timeline::Serial::Kind::Between, {}, end, from, -1});
    end = std::max(end, to);
  }
  for (Timeline::Serial& part : serial) {
    const double length = part.end - part.start;
    const double cpu = part.threads;  // milliseconds of thread time so far
    part.threads = 1;
    if (length <= 0) continue;
    if (run.processors.known())
      part.threads = run.processors.cpuMs(part.start, part.end) / length;
    else if (cpu >= 0)
      part.threads = cpu / length;
    part.threads = std::clamp(part.threads, 0.0, std::max(1.0, static_cast<double>(timeline.lanes)));
  }
  std::ranges::sort(serial, {}, &Timeline::Serial::start);
}

}  // namespace

TimeUse timeUse(const Timeline& timeline) {
  TimeUse use;
  const double lanes = timeline.lanes;
  for (const Timeline::Serial& part : timeline.serial) {
    const double whole = lanes * (part.end - part.start);
    const double busy = std::min(whole, part.threads * (part.end - part.start));
    // Other threads of the program also wait for processors; only the time that the working thread has lost counts.
    const double lost = std::max(0.0, part.end - part.start - busy);
    const double others = std::min(timeline.processors.waitedMs(part.start, part.end), lost);
    use.steps += busy;
    use.otherPrograms += others;
    use.waitingForStep += whole - busy - others;
  }
  for (const Timeline::Band& band : timeline.bands) {
    if (band.phase != Timeline::Phase::Parallel) continue;
    double busy = 0;
    for (const Timeline::Bar& bar : timeline.bars)
      busy += std::max(0.0, std::min(bar.end, band.end) - std::max(bar.start, band.start));
    const double lost = std::max(0.0, busy - timeline.processors.cpuMs(band.start, band.end));
    const double others = std::min(timeline.processors.waitedMs(band.start, band.end), lost);
    use.cells += busy - others;
    use.otherPrograms += others;
    use.waitingForWork += std::max(0.0, lanes * (band.end - band.start) - busy);
  }
  return use;
}

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
    if (block.run != blocks[shown].run) continue;  // its times have another origin
    timeline.lanes = std::max(timeline.lanes, block.threads());
    addBands(block.report, timeline.bands);
    for (std::size_t c = 0; c < block.report.cells.size(); ++c) {
      if (!block.finished[c]) continue;
      for (const CellSpan& span : block.report.cells[c].spans) work.push_back({CellId{b, c}, &span});
    }
    for (const CellSpan& span : block.report.shared) work.push_back({std::nullopt, &span});
  }
  std::ranges::sort(work, {}, [](const Work& piece) { return piece.span->startMs; });
  // numbered in the order of their first use
  for (const Work& piece : work) numberOf(piece.span->filter, timeline.filters);
  addBars(work, timeline);
  if (blocks[shown].run) {
    addSerial(*blocks[shown].run, timeline);
    timeline.processors = blocks[shown].run->processors;
  }
  bool first = true;
  const auto cover = [&](double start, double end) {
    timeline.start = first ? start : std::min(timeline.start, start);
    timeline.end = first ? end : std::max(timeline.end, end);
    first = false;
  };
  for (const Timeline::Band& band : timeline.bands) cover(band.start, band.end);
  for (const Timeline::Bar& bar : timeline.bars) cover(bar.start, bar.end);
  for (const Timeline::Serial& part : timeline.serial) cover(part.start, part.end);
  return timeline;
}

}  // namespace footfall::ui
