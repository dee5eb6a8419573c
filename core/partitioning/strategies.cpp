// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/strategies.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/partitioning/floor_work.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {
namespace {

// The number of the parameter `round` in every strategy that has it.
constexpr std::size_t kRound = 2;

std::string textOf(FilterType strategy, const std::vector<double>& values) {
  std::string text(filterDescriptor(strategy).name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool isRound = i == kRound;
    if (isRound && values[i] == 0 && strategy == FilterType::GridStrategy) break;  // as it is usually written
    text += ' ';
    text += isRound ? (values[i] != 0 ? "true" : "false") : std::to_string(static_cast<long long>(values[i]));
  }
  return text;
}

/// One call of a strategy: its input, and the reason for its choice.
class StrategyCall {
 public:
  StrategyCall(FilterType strategy, const std::vector<double>& strategyValues, const StrategyInput& strategyInput)
      : values(strategyValues), input(strategyInput), name(textOf(strategy, strategyValues)) {}

  /// The work on all floors, estimated once, for about so many cells.
  const FloorWork& work(std::size_t cells) {
    if (!estimate_) estimate_ = estimateFloorWork(input, cells);
    return *estimate_;
  }
  const FloorWork& work(const RecursionLimits& limits) {
    return work(std::size_t{1} << std::min(static_cast<int>(limits.depth), 16));
  }
  [[nodiscard]] bool isEstimated() const { return estimate_.has_value(); }
  [[nodiscard]] RecursionLimits limits() const { return {values.at(0), values.at(1)}; }

  const std::vector<double>& values;
  const StrategyInput& input;
  std::string name;  ///< the name in a pipeline file; AutoStrategy replaces it by that of its choice
  Text reason;

 private:
  std::optional<FloorWork> estimate_;
};

using CutTreePtr = std::unique_ptr<CutTree>;

CutTreePtr growChosen(StrategyCall& call) {
  const AutoChoice choice =
      chooseStrategy(call.input, [&](const RecursionLimits& limits) { return call.work(limits).total; });
  call.reason = choice.reason;
  if (choice.isOneCell) {
    call.name = textOf(FilterType::GridStrategy, {1, 1});
    return std::make_unique<CutTree>();
  }
  call.name = textOf(FilterType::HeightAwareStrategy, {choice.limits.triangles, choice.limits.depth, 0});
  return growHeightAware(choice.limits, call.work(choice.limits), call.name, call.input);
}

// The switch has no default, so that a strategy that is left out does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
CutTreePtr grow(FilterType strategy, StrategyCall& call) {
  const std::vector<double>& values = call.values;
  switch (strategy) {
    case FilterType::GridStrategy:
      return growGrid(values.at(0), values.at(1), call.name, call.input);
    case FilterType::RecursiveStrategy:
      return growRecursive(call.limits(), call.name, call.input);
    case FilterType::SortedRecursiveStrategy:
      return growSortedRecursive(call.limits(), call.name, call.input);
    case FilterType::HeightAwareStrategy:
      return growHeightAware(call.limits(), call.work(call.limits()), call.name, call.input);
    case FilterType::AutoStrategy:
      return growChosen(call);
    case FilterType::Duplication:
    case FilterType::Degeneracy:
    case FilterType::Slope:
    case FilterType::VerticalClearance:
    case FilterType::Step:
    case FilterType::Radius:
    case FilterType::Drop:
    case FilterType::Reachable:
    case FilterType::Area:
    case FilterType::Simplification:
    case FilterType::LayerSubdivision:
    case FilterType::Rounding:
    case FilterType::Collapse:
      break;
  }
  throw std::logic_error("no such strategy: " + call.name);
}
#pragma GCC diagnostic pop

}  // namespace

Partition makePartition(FilterType strategy, const std::vector<double>& values, const StrategyInput& input) {
  StrategyCall call(strategy, values, input);
  const CutTreePtr tree = grow(strategy, call);
  if (values.size() > kRound && values[kRound] != 0)
    call.reason = FOOTFALL_TEXT(
        "round changes nothing, because no obstacle is cut and cuts vanish in Collapse; "
        "footfall-rounding-experiment repeats what the thesis did.");
  Partition partition = partitionOf(*tree);
  partition.strategy = std::move(call.name);
  partition.reason = std::move(call.reason);
  if (partition.cells.size() > 1 || call.isEstimated())
    estimateCosts(partition, call.work(partition.cells.size()));
  else
    partition.cells[0].cost = static_cast<double>(
        std::count_if(input.walkable.begin(), input.walkable.end(), [](char isFloor) { return isFloor != 0; }));
  return partition;
}

}  // namespace footfall::detail
