// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/known_blocks.hpp"

#include <algorithm>
#include <memory>

namespace footfall::ui {
namespace {

constexpr std::size_t kKnownBlocks = 64;

}  // namespace

void KnownBlocks::follow(const FinishedRun& run, const std::vector<const PipelineStep*>& steps,
                         const std::vector<std::string>& prefixes) {
  const RunResult& result = run.result;
  if (!result.blocks.empty()) {
    const auto figures = std::make_shared<const RunFigures>(RunFigures{result.times, result.threads});
    for (const BlockReport& report : result.blocks) {
      if (report.lastStep + 1 >= prefixes.size()) continue;
      known_[prefixes[report.lastStep + 1]] = {report, std::vector<char>(report.cells.size(), 1), figures, run.ranks};
    }
  }
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
    if (known != known_.end()) blocks.push_back(known->second);
  }
  return blocks;
}

}  // namespace footfall::ui
