// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/known_blocks.hpp"

#include <algorithm>
#include <memory>

#include "footfall/filter.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kKnownBlocks = 64;

}  // namespace

RunFigures figuresOfRun(const RunResult& result, const ProcessorUse& processors) {
  RunFigures figures{result.times, result.threads, {}, processors};
  const auto isInBlock = [&](std::size_t step) {
    return std::ranges::any_of(
        result.blocks, [step](const BlockReport& block) { return block.firstStep <= step && step <= block.lastStep; });
  };
  if (result.startMs > 0) figures.parts.push_back({RunPart::Kind::Start, {}, 0, result.startMs});
  for (std::size_t i = 0; i < result.steps.size(); ++i) {
    const StepStatistics& step = result.steps[i];
    if (step.fromCache || isInBlock(i)) continue;
    figures.parts.push_back({RunPart::Kind::Step, step.name, step.startMs, step.startMs + step.wallMs, step.cpuMs});
  }
  if (result.finishMs > 0)
    figures.parts.push_back({RunPart::Kind::Finish, {}, result.totalMs - result.finishMs, result.totalMs});
  return figures;
}

void KnownBlocks::follow(const FinishedRun& run, const std::vector<const PipelineStep*>& steps,
                         const std::vector<std::string>& prefixes) {
  const RunResult& result = run.result;
  if (!result.blocks.empty()) {
    const auto figures = std::make_shared<const RunFigures>(figuresOfRun(result, run.processors));
    last_ = figures;
    for (const BlockReport& report : result.blocks) {
      if (report.lastStep + 1 >= prefixes.size()) continue;
      known_[prefixes[report.lastStep + 1]] = {report, std::vector<char>(report.cells.size(), 1), figures, run.ranks};
    }
  }
  ran_ = !result.blocks.empty();
  names_.clear();
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i]->filter->kind == FilterKind::Collapse) names_.push_back(prefixes[i + 1]);
  if (known_.size() > kKnownBlocks)
    std::erase_if(known_, [this](const auto& known) { return std::ranges::count(names_, known.first) == 0; });
}

CellBlocks KnownBlocks::blocks() const {
  CellBlocks blocks;
  for (const std::string& name : names_) {
    const auto known = known_.find(name);
    if (known == known_.end()) continue;
    blocks.push_back(known->second);
    if (!ran_ || known->second.run != last_) blocks.back().origin = CellBlock::Origin::Cache;
  }
  return blocks;
}

}  // namespace footfall::ui
