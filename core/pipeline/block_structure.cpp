// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/block_structure.hpp"

namespace footfall {

std::string placeOfStep(const Pipeline& pipeline, std::size_t step) {
  const int line = pipeline.steps[step].line;
  return line > 0 ? "line " + std::to_string(line) : "step " + std::to_string(step + 1);
}

std::optional<StructureError> findStructureError(const Pipeline& pipeline) {
  std::optional<std::size_t> opened;  // the strategy whose block we are in
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled) continue;
    const std::string name(step.filter->name);
    const auto blockText = [&] {
      return "the parallel block that " + std::string(pipeline.steps[*opened].filter->name) + " begins in " +
             placeOfStep(pipeline, *opened);
    };
    switch (step.filter->kind) {
      case FilterKind::Collapse:
        if (!opened) {
          return StructureError{i,
                                "Collapse ends no parallel block; remove it or put a strategy such as "
                                "GridStrategy before it"};
        }
        opened.reset();
        break;
      case FilterKind::Strategy:
        if (opened) return StructureError{i, name + " stands inside " + blockText() + "; put a Collapse before it"};
        opened = i;
        break;
      case FilterKind::Filter:
        if (opened && step.filter->scope == Scope::Global) {
          return StructureError{i, name + " sees across cells and cannot run inside " + blockText() +
                                       "; move it behind Collapse or before the block"};
        }
        break;
    }
  }
  if (opened) {
    return StructureError{*opened, std::string(pipeline.steps[*opened].filter->name) +
                                       " begins a parallel block that never ends; add a Collapse behind it"};
  }
  return std::nullopt;
}

}  // namespace footfall
