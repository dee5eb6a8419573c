// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_edits.hpp"

#include <algorithm>
#include <utility>

#include "footfall/filter.hpp"
#include "ui/base/text/translated.hpp"
#include "ui/document/edit_text.hpp"

namespace footfall::ui {
namespace {

bool contains(const FilterIds& ids, int id) { return std::ranges::find(ids, id) != ids.end(); }

std::vector<PipelineStep> stepsOf(const Document& document, const FilterIds& ids) {
  std::vector<PipelineStep> steps;
  for (const FilterEntry& entry : document.filters()) {
    if (contains(ids, entry.id)) steps.push_back(entry.step);
  }
  return steps;
}

QString named(const QString& text, const std::vector<PipelineStep>& steps) { return text.arg(stepsText(steps)); }

}  // namespace

void removeFilters(Document& document, const FilterIds& ids) {
  DocumentState next = document.state();
  std::erase_if(next.filters, [&](const FilterEntry& entry) { return contains(ids, entry.id); });
  document.edit(std::move(next), named(tr("Remove %1"), stepsOf(document, ids)));
}

FilterIds duplicateFilters(Document& document, const FilterIds& ids) {
  const auto& filters = document.filters();
  const auto last =
      std::find_if(filters.rbegin(), filters.rend(), [&](const FilterEntry& entry) { return contains(ids, entry.id); });
  if (last == filters.rend()) return {};
  const std::vector<PipelineStep> steps = stepsOf(document, ids);
  return insertFilters(document, static_cast<std::size_t>(filters.rend() - last), steps,
                       named(tr("Duplicate %1"), steps));
}

FilterIds insertFilters(Document& document, std::size_t index, const std::vector<PipelineStep>& steps,
                        const QString& text) {
  DocumentState next = document.state();
  FilterIds ids;
  auto at = next.filters.begin() + static_cast<std::ptrdiff_t>(std::min(index, next.filters.size()));
  for (const PipelineStep& step : steps) {
    ids.push_back(document.newFilterId());
    at = next.filters.insert(at, {ids.back(), step}) + 1;
    std::prev(at)->step.line = 0;  // from here on, its row is its place
    std::prev(at)->step.columns.clear();
  }
  document.edit(std::move(next), text);
  return ids;
}

void moveFilters(Document& document, const FilterIds& ids, int direction) {
  const auto& filters = document.filters();
  std::size_t first = filters.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (!contains(ids, filters[i].id)) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first == filters.size()) return;
  if (direction < 0 && first > 0) moveFiltersTo(document, ids, first - 1);
  if (direction > 0 && last + 1 < filters.size()) moveFiltersTo(document, ids, last + 2);
}

void moveFiltersTo(Document& document, const FilterIds& ids, std::size_t gap) {
  const auto& filters = document.filters();
  std::vector<FilterEntry> before, moved, behind;
  bool up = false;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (contains(ids, filters[i].id)) {
      up = up || i >= gap;
      moved.push_back(filters[i]);
    } else {
      (i < gap ? before : behind).push_back(filters[i]);
    }
  }
  DocumentState next = document.state();
  next.filters = std::move(before);
  next.filters.insert(next.filters.end(), moved.begin(), moved.end());
  next.filters.insert(next.filters.end(), behind.begin(), behind.end());
  document.edit(std::move(next), named(up ? tr("Move %1 up") : tr("Move %1 down"), stepsOf(document, ids)));
}

void switchFilters(Document& document, const FilterIds& ids, bool on) {
  DocumentState next = document.state();
  for (FilterEntry& entry : next.filters) {
    if (contains(ids, entry.id)) entry.step.enabled = on;
  }
  document.edit(std::move(next), named(on ? tr("Switch on %1") : tr("Switch off %1"), stepsOf(document, ids)));
}

void runOnlyUpTo(Document& document, int id) {
  DocumentState next = document.state();
  const auto last = std::ranges::find(next.filters, id, &FilterEntry::id);
  if (last == next.filters.end()) return;
  bool open = false;
  for (auto entry = next.filters.begin(); entry != next.filters.end(); ++entry) {
    PipelineStep& step = entry->step;
    if (entry == last) step.enabled = true;
    if (entry <= last) {
      if (step.enabled && step.filter->kind != FilterKind::Filter) open = step.filter->kind == FilterKind::Strategy;
    } else {
      const bool closes = open && step.filter->kind == FilterKind::Collapse;
      open = open && !closes;
      step.enabled = closes;
    }
  }
  document.edit(std::move(next), tr("Run only up to %1").arg(labelOf(last->step)));
}

void switchOthersOff(Document& document, const FilterIds& ids) {
  DocumentState next = document.state();
  for (FilterEntry& entry : next.filters) entry.step.enabled = contains(ids, entry.id);
  // A strategy and its Collapse belong together.
  const auto& before = document.filters();
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!before[i].step.enabled || before[i].step.filter->kind != FilterKind::Strategy) continue;
    std::size_t end = i;
    bool needed = false;
    while (end < before.size() && before[end].step.filter->kind != FilterKind::Collapse) {
      needed = needed || contains(ids, before[end].id);
      ++end;
    }
    if (end == before.size() || !(needed || contains(ids, before[end].id))) continue;
    next.filters[i].step.enabled = next.filters[end].step.enabled = true;
  }
  document.edit(std::move(next), named(tr("Switch off all but %1"), stepsOf(document, ids)));
}

void switchAllOn(Document& document) {
  DocumentState next = document.state();
  for (FilterEntry& entry : next.filters) entry.step.enabled = true;
  document.edit(std::move(next), tr("Switch on all filters"));
}

std::string filtersAsText(const Document& document, const FilterIds& ids) {
  return formatPipeline({stepsOf(document, ids)});
}

}  // namespace footfall::ui
