// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/run_trace.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kProcess = 1;
constexpr int kRunLane = 0;
int laneOf(int thread) { return thread + 1; }

class Trace {
 public:
  explicit Trace(const RunResult& result) : result_(result) {}

  std::string format() {
    nameLane(kRunLane, "run");
    for (int thread = 0; thread < result_.threads; ++thread)
      nameLane(laneOf(thread), "thread " + std::to_string(thread));
    addSteps();
    for (const BlockReport& block : result_.blocks) addBlock(block);
    const Json json = {{"traceEvents", events_}, {"displayTimeUnit", "ms"}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  }

 private:
  void nameLane(int lane, const std::string& name) {
    events_.push_back(
        {{"name", "thread_name"}, {"ph", "M"}, {"pid", kProcess}, {"tid", lane}, {"args", {{"name", name}}}});
    events_.push_back({{"name", "thread_sort_index"},
                       {"ph", "M"},
                       {"pid", kProcess},
                       {"tid", lane},
                       {"args", {{"sort_index", lane}}}});
  }

  void add(const std::string& name, const char* category, int lane, double startMs, double endMs,
           Json details = Json::object()) {
    events_.push_back({{"name", name},
                       {"cat", category},
                       {"ph", "X"},
                       {"ts", startMs * 1000},
                       {"dur", std::max(0.0, endMs - startMs) * 1000},
                       {"pid", kProcess},
                       {"tid", lane},
                       {"args", std::move(details)}});
  }

  [[nodiscard]] bool isInBlock(std::size_t step) const {
    return std::any_of(result_.blocks.begin(), result_.blocks.end(),
                       [&](const BlockReport& block) { return block.firstStep <= step && step <= block.lastStep; });
  }

  void addSteps() {
    if (result_.startMs > 0) add("first state", "phase", kRunLane, 0, result_.startMs);
    for (std::size_t i = 0; i < result_.steps.size(); ++i) {
      const StepStatistics& step = result_.steps[i];
      if (step.fromCache || isInBlock(i)) continue;
      add(step.name, "step", kRunLane, step.startMs, step.startMs + step.wallMs,
          {{"triangles_in", step.in.triangles}, {"triangles_out", step.out.triangles}, {"note", step.note.str()}});
    }
    add("navigation mesh", "phase", kRunLane, result_.totalMs - result_.finishMs, result_.totalMs);
  }

  void addBlock(const BlockReport& block) {
    add("partitioning", "phase", kRunLane, block.startMs, block.startMs + block.partitioningMs,
        {{"strategy", block.strategy}, {"reason", block.reason.str()}, {"cells", block.cells.size()}});
    double start = -1, end = -1;
    for (const CellReport& cell : block.cells) {
      if (cell.spans.empty()) continue;
      start = start < 0 ? cell.startMs : std::min(start, cell.startMs);
      end = std::max(end, cell.endMs);
    }
    for (int thread = 0; thread < result_.threads; ++thread) addLane(block, thread);
    if (end >= 0) add("cells", "phase", kRunLane, start, end, {{"imbalance", block.imbalance(result_.threads)}});
    for (const CellSpan& span : block.shared)
      add(span.filter, "filter", kRunLane, span.startMs, span.endMs, {{"cells", "all together"}});
    const StepStatistics& collapse = result_.steps.at(block.lastStep);
    if (collapse.wallMs > 0) add("merging", "phase", kRunLane, collapse.startMs, collapse.startMs + collapse.wallMs);
  }

  // One bar for uninterrupted work of a thread on a cell, with a bar for each filter inside.
  void addLane(const BlockReport& block, int thread) {
    constexpr double kBreakMs = 0.05;
    std::vector<std::pair<std::size_t, const CellSpan*>> lane;
    for (std::size_t i = 0; i < block.cells.size(); ++i)
      for (const CellSpan& span : block.cells[i].spans)
        if (span.thread == thread) lane.emplace_back(i, &span);
    std::sort(lane.begin(), lane.end(),
              [](const auto& a, const auto& b) { return a.second->startMs < b.second->startMs; });
    for (std::size_t i = 0; i < lane.size();) {
      const std::size_t number = lane[i].first;
      const CellReport& cell = block.cells[number];
      std::size_t j = i + 1;
      while (j < lane.size() && lane[j].first == number &&
             lane[j].second->startMs - lane[j - 1].second->endMs < kBreakMs)
        ++j;
      add("cell " + std::to_string(number + 1), "cell", laneOf(thread), lane[i].second->startMs,
          lane[j - 1].second->endMs,
          {{"triangles_in", cell.trianglesIn},
           {"triangles_out", cell.trianglesOut},
           {"cost", cell.cost},
           {"helping", thread != cell.thread}});
      for (; i < j; ++i)
        add(lane[i].second->filter, "filter", laneOf(thread), lane[i].second->startMs, lane[i].second->endMs);
    }
  }

  const RunResult& result_;
  Json events_ = Json::array();
};

}  // namespace

std::string formatTrace(const RunResult& result) { return Trace(result).format(); }

}  // namespace footfall::detail
