// Strategies, which begin a parallel block, and Collapse, which ends it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptors/descriptors.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

namespace {

constexpr std::string_view kBlockPrecondition = "A Collapse follows, with only local filters in between.";
constexpr std::string_view kBlockEffect = "The filters up to Collapse run on each cell on its own.";

constexpr ParameterDescriptor kMinimumTriangles{
    .name = "min",
    .label = "Fewest triangles",
    .help = "A cell with no more triangles than this is not cut again.",
    .type = ParameterType::Integer,
    .unit = Unit::Count,
    .defaultValue = 50,
    .minimum = 1,
    .maximum = kLargestInteger,
};

constexpr ParameterDescriptor kMaximumDepth{
    .name = "depth",
    .label = "Largest depth",
    .help = "The largest number of cuts inside each other.",
    .type = ParameterType::Integer,
    .unit = Unit::Count,
    .defaultValue = 3,
    .minimum = 1,
    .maximum = 32,
};

constexpr ParameterDescriptor kRoundCuts{
    .name = "round",
    .label = "Round the cuts",
    .help =
        "Read from the thesis's files, where points on cuts are rounded to keep numbers small. Here no obstacle is cut "
        "and cuts vanish in Collapse, so both values give the same result; only the cut environment of "
        "footfall cells -o differs.",
    .type = ParameterType::Boolean,
    .unit = Unit::None,
    .defaultValue = 0,
    .minimum = 0,
    .maximum = 1,
};

ParameterDescriptor optional(ParameterDescriptor parameter) {
  parameter.optional = true;
  return parameter;
}

FilterTraits traitsOfBlocks(bool (*makesBorders)(StepValues)) {
  return {
      .removals = {},
      .parameters = {},
      .makesBorders = makesBorders,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = always,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::LeftOut>,
      .tileProblem = kNoText,
      .problem = noProblem,
  };
}

/// The traits of all strategies.
const FilterTraits* strategyTraits() {
  static const FilterTraits kTraits = traitsOfBlocks(never);
  return &kTraits;
}

}  // namespace

FilterDescriptor describeGridStrategy() {
  const auto count = [](std::string_view name, std::string_view label, std::string_view help) {
    return ParameterDescriptor{.name = name,
                               .label = label,
                               .help = help,
                               .type = ParameterType::Integer,
                               .unit = Unit::Count,
                               .defaultValue = 2,
                               .minimum = 1,
                               .maximum = kLargestInteger};
  };
  return {
      .type = FilterType::GridStrategy,
      .name = "GridStrategy",
      .aliases = {},
      .label = "Grid strategy",
      .help =
          "Cuts the environment into a grid of equal rectangles in the plan and begins a parallel block. Good where "
          "obstacles are spread evenly.",
      .precondition = kBlockPrecondition,
      .effect = kBlockEffect,
      .source = "thesis 4.3.1",
      .parameters = {count("n", "Columns", "Number of cells along x."), count("m", "Rows", "Number of cells along y."),
                     optional(kRoundCuts)},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
      .traits = strategyTraits(),
  };
}

FilterDescriptor describeRecursiveStrategy() {
  return {
      .type = FilterType::RecursiveStrategy,
      .name = "RecursiveStrategy",
      .aliases = {},
      .label = "Recursive strategy",
      .help =
          "Cuts the environment into four equal rectangles, and each of them again as long as it holds many triangles, "
          "and begins a parallel block.",
      .precondition = kBlockPrecondition,
      .effect = kBlockEffect,
      .source = "thesis 4.3.2",
      .parameters = {kMinimumTriangles, kMaximumDepth, optional(kRoundCuts)},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
      .traits = strategyTraits(),
  };
}

FilterDescriptor describeSortedRecursiveStrategy() {
  return {
      .type = FilterType::SortedRecursiveStrategy,
      .name = "SortedRecursiveStrategy",
      .aliases = {"SmartRecursiveStrategy"},
      .label = "Sorted recursive strategy",
      .help =
          "Cuts the environment into halves of about equally many triangles, across x and y in turn and again as long "
          "as a part holds many, and begins a parallel block.",
      .precondition = kBlockPrecondition,
      .effect = kBlockEffect,
      .source = "thesis 4.3.3",
      .parameters = {kMinimumTriangles, kMaximumDepth, kRoundCuts},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
      .traits = strategyTraits(),
  };
}

FilterDescriptor describeHeightAwareStrategy() {
  ParameterDescriptor least = kMinimumTriangles;
  least.label = "Least work";
  least.help =
      "A cell with no more estimated work than this is not cut again. The unit is one triangle that nothing stands on.";
  return {
      .type = FilterType::HeightAwareStrategy,
      .name = "HeightAwareStrategy",
      .aliases = {},
      .label = "Height-aware strategy",
      .help =
          "Divides the floors, across the plan and between storeys, into cells of about equal work, each with only the "
          "obstacles that can stand in the clearance above its floors, and begins a parallel block. Good for towers "
          "and buildings with storeys.",
      .precondition = kBlockPrecondition,
      .effect = kBlockEffect,
      .source = "ours; thesis 6.1, first proposal",
      .parameters = {least, kMaximumDepth, optional(kRoundCuts)},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
      .traits = strategyTraits(),
  };
}

FilterDescriptor describeAutoStrategy() {
  return {
      .type = FilterType::AutoStrategy,
      .name = "AutoStrategy",
      .aliases = {"Auto"},
      .label = "Automatic strategy",
      .help =
          "Picks a strategy and its depth from the environment and the number of threads, says what it picked and why, "
          "and begins a parallel block. Small environments stay in one cell.",
      .precondition = kBlockPrecondition,
      .effect = kBlockEffect,
      .source = "ours",
      .parameters = {},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
      .traits = strategyTraits(),
  };
}

FilterDescriptor describeCollapse() {
  static const FilterTraits kTraits = traitsOfBlocks(always);
  return {
      .type = FilterType::Collapse,
      .name = "Collapse",
      .aliases = {},
      .label = "Collapse",
      .help =
          "Ends a parallel block: puts the cells together again. The seams vanish, so that the result is the one "
          "of the same filters without a block.",
      .precondition = "A strategy stands before it.",
      .effect = "One environment again, without a trace of the cells.",
      .source = "thesis 4.1, 5.4",
      .parameters = {},
      .kind = FilterKind::Collapse,
      .scope = Scope::Global,
      .traits = &kTraits,
  };
}

}  // namespace footfall::detail
