// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/block_structure.hpp"

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
  switch (step.filter->type) {
    case FilterType::Step:
    case FilterType::Drop:
      return true;
    case FilterType::Radius:
      return step.values[0] != step.values[1];
    default:
      return false;
  }
}

namespace {

// Returns whether a filter keeps a drop's edge and its landing, or removes both.
bool keepsDrops(FilterType type) {
  return type == FilterType::Drop || type == FilterType::Reachable || type == FilterType::Area;
}

StructureError missingClearance(const Pipeline& pipeline, std::size_t step) {
  return {step, Text(FOOTFALL_TEXT("%1 needs %2 before it"), pipeline.steps[step].filter->name,
                     filterDescriptor(FilterType::VerticalClearance).name)};
}

std::optional<StructureError> findDropError(const Pipeline& pipeline) {
  bool hasClearance = false;
  std::optional<std::size_t> dropped;  // the DropFilter that came last
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled) continue;
    hasClearance = hasClearance || step.filter->type == FilterType::VerticalClearance;
    if (dropped && !keepsDrops(step.filter->type)) {
      return StructureError{i,
                            Text(FOOTFALL_TEXT("%1 would lose the drops of the DropFilter in %2; put it before that"),
                                 step.filter->name, placeOfStep(pipeline, *dropped))};
    }
    if (step.filter->type != FilterType::Drop) continue;
    if (!hasClearance) return missingClearance(pipeline, i);
    dropped = i;
  }
  return std::nullopt;
}

std::optional<StructureError> findStepError(const Pipeline& pipeline) {
  bool hasClearance = false;
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled) continue;
    hasClearance = hasClearance || step.filter->type == FilterType::VerticalClearance;
    if (step.filter->repeats > 0 && step.values.size() < step.filter->parameters.size()) {
      return StructureError{i, Text(FOOTFALL_TEXT("%1 has no seed; give the coordinates of a walkable place, or click "
                                                  "one in the editor"),
                                    step.filter->name)};
    }
    const bool ownLedges = step.filter->type == FilterType::Radius && needsClearance(step);
    if (ownLedges && !hasClearance) {
      return StructureError{i, Text(FOOTFALL_TEXT("%1 with a distance of its own to ledges needs %2 before it"),
                                    step.filter->name, filterDescriptor(FilterType::VerticalClearance).name)};
    }
    if (step.filter->type == FilterType::Step && !hasClearance) return missingClearance(pipeline, i);
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
  if (const auto error = findStepError(pipeline)) return error;
  return findDropError(pipeline);
}

}  // namespace footfall::detail
