// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/block_structure.hpp"

#include <algorithm>
#include <utility>

#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

Text placeOfStep(const Pipeline& pipeline, std::size_t step) {
  const int line = pipeline.steps[step].line;
  if (line > 0) return {FOOTFALL_TEXT("line %1"), line};
  // Labels are literals, which end as patterns have to.
  return {FOOTFALL_TEXT("step %1 (%2)"), step + 1, Text(Pattern{pipeline.steps[step].filter->label.data()})};
}

bool needsClearance(const PipelineStep& step) {
  return *step.filter->traits->clearanceNeed(step.values).english != '\0';
}

bool needsObstacles(const std::vector<const PipelineStep*>& steps, std::size_t count) {
  return std::any_of(steps.begin() + static_cast<std::ptrdiff_t>(count), steps.end(),
                     [](const PipelineStep* step) { return step->filter->traits->readsObstacles(step->values); });
}

namespace {

std::optional<StructureError> findStepError(const Pipeline& pipeline) {
  bool hasClearance = false;
  std::optional<std::size_t> dropped;  // the DropFilter that came last
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled) continue;
    const FilterTraits& traits = *step.filter->traits;
    hasClearance = hasClearance || step.filter->type == FilterType::VerticalClearance;
    if (Text problem = traits.problem(step.filter->name, step.values); !problem.empty())
      return StructureError{i, std::move(problem)};
    if (!hasClearance && needsClearance(step)) {
      return StructureError{i, Text(traits.clearanceNeed(step.values), step.filter->name,
                                    filterDescriptor(FilterType::VerticalClearance).name)};
    }
    if (dropped && !traits.keepsDrops) {
      return StructureError{i,
                            Text(FOOTFALL_TEXT("%1 would lose the drops of the DropFilter in %2; put it before that"),
                                 step.filter->name, placeOfStep(pipeline, *dropped))};
    }
    if (step.filter->type == FilterType::Drop) dropped = i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<StructureError> findStructureError(const Pipeline& pipeline) {
  std::optional<std::size_t> opened;  // the strategy whose block we are in
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled) continue;
    const std::string_view name = step.filter->name;
    const auto blockText = [&] {
      return Text(FOOTFALL_TEXT("the parallel block that %1 begins in %2"), pipeline.steps[*opened].filter->name,
                  placeOfStep(pipeline, *opened));
    };
    switch (step.filter->kind) {
      case FilterKind::Collapse:
        if (!opened) {
          return StructureError{i, FOOTFALL_TEXT("Collapse ends no parallel block; remove it or put a strategy such as "
                                                 "GridStrategy before it")};
        }
        opened.reset();
        break;
      case FilterKind::Strategy:
        if (opened)
          return StructureError{
              i, Text(FOOTFALL_TEXT("%1 stands inside %2; put a Collapse before it"), name, blockText())};
        opened = i;
        break;
      case FilterKind::Filter:
        if (opened && step.filter->scope == Scope::Global) {
          return StructureError{
              i, Text(FOOTFALL_TEXT(
                          "%1 needs all cells and cannot run inside %2; move it behind Collapse or before the block"),
                      name, blockText())};
        }
        break;
    }
  }
  if (opened) {
    return StructureError{*opened,
                          Text(FOOTFALL_TEXT("%1 begins a parallel block that never ends; add a Collapse behind "
                                             "it"),
                               pipeline.steps[*opened].filter->name)};
  }
  return findStepError(pipeline);
}

}  // namespace footfall::detail
