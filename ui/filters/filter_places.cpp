// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_places.hpp"

#include <algorithm>
#include <utility>

#include "core/pipeline/block_structure.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/translated.hpp"
#include "ui/document/agent_rules.hpp"
#include "ui/document/edit_text.hpp"
#include "ui/run/run_job.hpp"

namespace footfall::ui {
namespace {

// The list as it runs, in the frame of the whole list.
Pipeline withInserted(const Pipeline& pipeline, std::size_t index, const std::vector<PipelineStep>& steps) {
  Pipeline next = withoutSkipped(pipeline);
  const auto at = static_cast<std::ptrdiff_t>(std::min(index, next.steps.size()));
  next.steps.insert(next.steps.begin() + at, steps.begin(), steps.end());
  return next;
}

// The end of the local filters that begin at `index`; disabled filters do not end them.
std::size_t endOfLocal(const std::vector<PipelineStep>& steps, std::size_t index) {
  std::size_t end = index;
  for (std::size_t i = index; i < steps.size(); ++i) {
    const PipelineStep& step = steps[i];
    const bool local = step.filter->kind == FilterKind::Filter && step.filter->scope == Scope::Local;
    if (local && step.enabled) end = i + 1;
    if (!local && (step.enabled || step.filter->kind != FilterKind::Filter)) break;
  }
  return end;
}

bool isInBlock(const Pipeline& pipeline, std::size_t index) {
  bool open = false;
  for (std::size_t i = 0; i < std::min(index, pipeline.steps.size()); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (step.enabled && step.filter->kind != FilterKind::Filter) open = step.filter->kind == FilterKind::Strategy;
  }
  return open;
}

// The nearest disabled clearance before the row; end() where there is none.
auto clearanceOff(std::vector<FilterEntry>& filters, int id) {
  auto found = filters.end();
  for (auto entry = filters.begin(); entry != filters.end() && entry->id != id; ++entry)
    if (entry->step.filter->type == FilterType::VerticalClearance && !entry->step.enabled) found = entry;
  return found;
}

}  // namespace

QString whyNotAt(const Pipeline& pipeline, std::size_t index, const FilterDescriptor& filter, double metresPerUnit) {
  const bool inBlock = isInBlock(pipeline, index);
  if (filter.kind == FilterKind::Strategy) return inBlock ? tr("already inside a parallel block") : QString();
  if (filter.kind == FilterKind::Collapse && !inBlock) return tr("no parallel block to end here");
  if (filter.kind == FilterKind::Filter && filter.scope == Scope::Global && inBlock)
    return tr("not inside a parallel block: it needs all cells");
  const Pipeline next = withInserted(pipeline, index, {defaultStep(filter, metresPerUnit)});
  if (!withoutSkipped(next).steps[std::min(index, pipeline.steps.size())].enabled)
    return tr("needs Vertical clearance before it");
  if (filter.repeats > 0) return {};
  const auto before = findStructureError(withoutSkipped(pipeline));
  const auto after = findStructureError(next);
  if (!after || (before && before->message == after->message)) return {};
  if (filter.kind == FilterKind::Collapse) return tr("the parallel block has an end already");
  return coreText(after->message);
}

FilterIds addFilterAt(Document& document, std::size_t index, const FilterDescriptor& filter, double metresPerUnit,
                      const QString& text) {
  DocumentState next = document.state();
  const std::vector<PipelineStep> steps = document.pipeline().steps;
  index = std::min(index, steps.size());
  const FilterEntry added{document.newFilterId(), defaultStep(filter, metresPerUnit)};
  if (filter.kind == FilterKind::Strategy) {
    const auto end = static_cast<std::ptrdiff_t>(endOfLocal(steps, index));
    next.filters.insert(next.filters.begin() + end,
                        {document.newFilterId(), defaultStep(filterDescriptor(FilterType::Collapse), metresPerUnit)});
  }
  next.filters.insert(next.filters.begin() + static_cast<std::ptrdiff_t>(index), added);
  writeSizes(next);
  document.edit(std::move(next), text.arg(labelOf(added.step)));
  return {added.id};
}

bool hasClearanceOff(const Document& document, int id) {
  std::vector<FilterEntry> filters = document.filters();
  return clearanceOff(filters, id) != filters.end();
}

void provideClearance(Document& document, int id, double metresPerUnit) {
  DocumentState next = document.state();
  const auto off = clearanceOff(next.filters, id);
  if (off != next.filters.end()) {
    off->step.enabled = true;
    const QString label = labelOf(off->step);
    document.edit(std::move(next), tr("Switch on %1").arg(label));
    return;
  }
  const auto& filters = document.filters();
  const auto row = std::ranges::find(filters, id, &FilterEntry::id);
  if (row == filters.end()) return;
  addFilterAt(document, static_cast<std::size_t>(row - filters.begin()),
              filterDescriptor(FilterType::VerticalClearance), metresPerUnit, tr("Add %1"));
}

}  // namespace footfall::ui
