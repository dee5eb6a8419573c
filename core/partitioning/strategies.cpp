// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/strategies.hpp"

#include <stdexcept>

#include "core/partitioning/partition_builder.hpp"

namespace footfall {
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
  const std::string name = textOf(strategy, values);
  std::unique_ptr<CutTree> tree;
  if (strategy == "GridStrategy")
    tree = growGrid(values.at(0), values.at(1), name, input);
  else
    throw std::logic_error("no such strategy: " + name);
  Partition partition = partitionOf(*tree);
  partition.strategy = name;
  return partition;
}

}  // namespace footfall
