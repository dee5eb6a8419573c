// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/seed_edits.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/text/translated.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kNumbers = 3;  // numbers in a seed

bool isReachable(const FilterEntry& entry) { return entry.step.filter->type == FilterType::Reachable; }

/// The values of a filter's step; null where the filter has no seeds.
std::vector<double>* valuesOf(DocumentState& state, int id) {
  const auto entry = std::ranges::find(state.filters, id, &FilterEntry::id);
  return entry != state.filters.end() && isReachable(*entry) ? &entry->step.values : nullptr;
}

QString numbered(const QString& text, std::size_t seed) { return text.arg(countText(seed + 1)); }

}  // namespace

std::vector<Vec3> seedsOf(const Document& document, int id) {
  std::vector<Vec3> seeds;
  const auto entry = std::ranges::find(document.filters(), id, &FilterEntry::id);
  if (entry == document.filters().end() || !isReachable(*entry)) return seeds;
  const std::vector<double>& values = entry->step.values;
  for (std::size_t i = 0; i + kNumbers <= values.size(); i += kNumbers)
    seeds.push_back({values[i], values[i + 1], values[i + 2]});
  return seeds;
}

int filterOfSeeds(const Document& document) {
  int found = -1;
  bool isOn = false;
  for (const FilterEntry& entry : document.filters()) {
    if (!isReachable(entry) || (isOn && !entry.step.enabled)) continue;
    found = entry.id;
    isOn = entry.step.enabled;
  }
  return found;
}

void addSeed(Document& document, int id, const Vec3& place) {
  DocumentState next = document.state();
  std::vector<double>* values = valuesOf(next, id);
  if (values == nullptr) return;
  const std::size_t seed = values->size() / kNumbers;
  values->insert(values->end(), {place.x, place.y, place.z});
  document.edit(std::move(next), numbered(tr("Place seed %1"), seed));
}

void moveSeed(Document& document, int id, std::size_t seed, const Vec3& place, const QString& mergeKey) {
  DocumentState next = document.state();
  std::vector<double>* values = valuesOf(next, id);
  if (values == nullptr || kNumbers * seed + kNumbers > values->size()) return;
  std::ranges::copy(std::array{place.x, place.y, place.z},
                    values->begin() + static_cast<std::ptrdiff_t>(kNumbers * seed));
  document.edit(std::move(next), numbered(tr("Move seed %1"), seed), mergeKey);
}

void removeSeed(Document& document, int id, std::size_t seed) {
  DocumentState next = document.state();
  std::vector<double>* values = valuesOf(next, id);
  if (values == nullptr || kNumbers * seed + kNumbers > values->size()) return;
  const auto first = values->begin() + static_cast<std::ptrdiff_t>(kNumbers * seed);
  values->erase(first, first + kNumbers);
  document.edit(std::move(next), numbered(tr("Remove seed %1"), seed));
}

int addFilterWithSeed(Document& document, const Vec3& place) {
  DocumentState next = document.state();
  auto at = next.filters.end();
  bool inBlock = false;
  for (auto entry = next.filters.begin(); entry != next.filters.end(); ++entry) {
    const PipelineStep& step = entry->step;
    if (!step.enabled) continue;
    inBlock = step.filter->kind == FilterKind::Strategy || (inBlock && step.filter->kind != FilterKind::Collapse);
    const bool isPlace = step.filter->type == FilterType::Step || step.filter->type == FilterType::VerticalClearance ||
                         step.filter->type == FilterType::Drop || step.filter->kind == FilterKind::Collapse;
    if (isPlace && !inBlock) at = entry + 1;
  }
  FilterEntry added{document.newFilterId(), defaultStep(filterDescriptor(FilterType::Reachable), 1)};
  added.step.values.insert(added.step.values.end(), {place.x, place.y, place.z});
  next.filters.insert(at, added);
  document.edit(std::move(next), numbered(tr("Place seed %1"), 0));
  return added.id;
}

}  // namespace footfall::ui
