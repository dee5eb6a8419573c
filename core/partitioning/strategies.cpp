// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/strategies.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/partitioning/floor_work.hpp"

namespace footfall::detail {
namespace {

std::string textOf(std::string_view strategy, const std::vector<double>& values) {
  std::string text(strategy);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool isRound = i == 2;  // the third parameter, where there is one
    text += ' ';
    text += isRound ? (values[i] != 0 ? "true" : "false") : std::to_string(static_cast<long long>(values[i]));
  }
  return text;
}

}  // namespace

Partition makePartition(std::string_view strategy, const std::vector<double>& values, const StrategyInput& input) {
  std::string name = textOf(strategy, values);
  Text reason;
  std::optional<FloorWork> estimate;
  const auto work = [&](std::size_t cells) -> const FloorWork& {
    if (!estimate) estimate = estimateFloorWork(input, cells);
    return *estimate;
  };
  const auto cellsOf = [](const RecursionLimits& l) {
    return std::size_t{1} << std::min(static_cast<int>(l.depth), 16);
  };
  const auto limits = [&] { return RecursionLimits{values.at(0), values.at(1)}; };
  std::unique_ptr<CutTree> tree;
  if (strategy == "GridStrategy") {
    tree = growGrid(values.at(0), values.at(1), name, input);
  } else if (strategy == "RecursiveStrategy") {
    tree = growRecursive(limits(), name, input);
  } else if (strategy == "SortedRecursiveStrategy") {
    tree = growSortedRecursive(limits(), name, input);
  } else if (strategy == "HeightAwareStrategy") {
    tree = growHeightAware(limits(), work(cellsOf(limits())), name, input);
  } else if (strategy == "AutoStrategy") {
    const AutoChoice choice = chooseStrategy(input, [&](const RecursionLimits& l) { return work(cellsOf(l)).total; });
    reason = choice.reason;
    if (choice.isOneCell) {
      tree = std::make_unique<CutTree>();
      name = textOf("GridStrategy", {1, 1});
    } else {
      name = textOf("HeightAwareStrategy", {choice.limits.triangles, choice.limits.depth, 0});
      tree = growHeightAware(choice.limits, work(cellsOf(choice.limits)), name, input);
    }
  } else {
    throw std::logic_error("no such strategy: " + name);
  }
  Partition partition = partitionOf(*tree);
  partition.strategy = std::move(name);
  partition.reason = std::move(reason);
  if (partition.cells.size() > 1 || estimate)
    estimateCosts(partition, work(partition.cells.size()));
  else
    partition.cells[0].cost = static_cast<double>(
        std::count_if(input.walkable.begin(), input.walkable.end(), [](char isFloor) { return isFloor != 0; }));
  return partition;
}

}  // namespace footfall::detail
