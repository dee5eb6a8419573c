// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/result_cache.hpp"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "core/filters/filter_traits.hpp"
#include "core/pipeline/block_structure.hpp"
#include "footfall/edit.hpp"
#include "footfall/filter.hpp"

namespace footfall::detail {
namespace {

// The first state, seven filters of the default pipeline, a few more: without them every edit would start from nothing.
constexpr std::size_t kLeastEntries = 12;

std::vector<StatePart> partsOf(const CachedPrefix& prefix) {
  std::vector<StatePart> parts;
  if (prefix.state) addParts(*prefix.state, parts);
  if (prefix.rounded) parts.push_back({prefix.rounded.get(), prefix.rounded->places.size() * (sizeof(Vec3) + 1)});
  if (prefix.mesh) parts.push_back({prefix.mesh.get(), sizeOf(*prefix.mesh)});
  return parts;
}

/// The addresses of the parts that are counted already.
using CountedParts = std::unordered_set<const void*>;

/// The bytes of the parts that were not counted yet.
std::size_t countParts(const std::vector<StatePart>& parts, CountedParts& counted) {
  std::size_t bytes = 0;
  for (const StatePart& part : parts)
    if (counted.insert(part.address).second) bytes += part.bytes;
  return bytes;
}

std::size_t machineMemory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGESIZE);
  constexpr std::size_t kUnknown = std::size_t{4} << 30;
  return pages > 0 && size > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(size) : kUnknown;
}

}  // namespace

PrefixCache::PrefixCache(std::size_t capacity, std::size_t bytes)
    : capacity_(capacity), mostBytes_(bytes > 0 ? bytes : machineMemory() / 8) {}

std::list<PrefixCache::Entry>::iterator PrefixCache::locate(const EnvironmentPtr& environment, const std::string& key) {
  std::erase_if(entries_, [](const Entry& entry) { return entry.environment.expired(); });
  return std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.key == key && !entry.environment.owner_before(environment) &&
           !environment.owner_before(entry.environment);
  });
}

std::optional<CachedPrefix> PrefixCache::find(const EnvironmentPtr& environment, const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = locate(environment, key);
  if (found == entries_.end()) return std::nullopt;
  entries_.splice(entries_.begin(), entries_, found);
  return found->prefix;
}

CachedPrefix PrefixCache::earlierPrefix(const EnvironmentPtr& environment, const EnvironmentPtr& base,
                                        const std::vector<const PipelineStep*>& steps, std::size_t count,
                                        bool hasPlaces) const {
  const CachedPrefix* any = nullptr;
  for (const Entry& entry : entries_) {
    const EnvironmentPtr of = entry.environment.lock();
    const auto& known = entry.prefix.steps;
    if (!of || (of != environment && of != base) || known.size() != count || (hasPlaces && !entry.prefix.rounded))
      continue;
    bool sameFilters = true, sameValues = true;
    for (std::size_t i = 0; i < count && sameFilters; ++i) {
      sameFilters = known[i].name == steps[i]->filter->name;
      sameValues = sameValues && known[i].parameters == steps[i]->values;
    }
    if (sameFilters && sameValues) return entry.prefix;
    if (sameFilters && any == nullptr) any = &entry.prefix;
  }
  return any != nullptr ? *any : CachedPrefix();
}

namespace {

std::shared_ptr<const Environment> baseOf(const Environment& environment) {
  return environment.edit ? environment.edit->base.lock() : nullptr;
}

}  // namespace

StatePtr PrefixCache::findEarlier(const EnvironmentPtr& environment, const std::vector<const PipelineStep*>& steps,
                                  std::size_t count) {
  const EnvironmentPtr base = baseOf(*environment);
  const std::lock_guard lock(mutex_);
  return earlierPrefix(environment, base, steps, count, false).state;
}

KnownPlaces PrefixCache::findPlaces(const EnvironmentPtr& environment, const std::vector<const PipelineStep*>& steps,
                                    std::size_t count) {
  const EnvironmentPtr base = baseOf(*environment);
  const std::lock_guard lock(mutex_);
  CachedPrefix found = earlierPrefix(environment, base, steps, count, true);
  return {std::move(found.state), std::move(found.rounded)};
}

void PrefixCache::store(const EnvironmentPtr& environment, const std::string& key, CachedPrefix prefix) {
  if (only_ && !only_->contains(key)) return;
  std::list<Entry> added;
  std::vector<StatePart> parts = partsOf(prefix);  // once, as it looks at long lists
  added.push_back({environment, key, std::move(prefix), std::move(parts)});
  std::list<Entry> dropped;  // large states are freed after the lock is
  const std::lock_guard lock(mutex_);
  const auto found = locate(environment, key);
  if (found != entries_.end()) dropped.splice(dropped.begin(), entries_, found);
  entries_.splice(entries_.begin(), added);
  const std::size_t kept = countToKeep();
  while (entries_.size() > kept) dropped.splice(dropped.begin(), entries_, std::prev(entries_.end()));
}

std::size_t PrefixCache::countToKeep() const {
  CountedParts counted;
  std::size_t bytes = 0;
  std::size_t count = 0;
  for (const Entry& entry : entries_) {
    bytes += countParts(entry.parts, counted);
    if (count >= capacity_ || (bytes > mostBytes_ && count >= kLeastEntries)) break;
    ++count;
  }
  return count;
}

std::size_t PrefixCache::bytes() {
  const std::lock_guard lock(mutex_);
  CountedParts counted;
  std::size_t bytes = 0;
  for (const Entry& entry : entries_) bytes += countParts(entry.parts, counted);
  return bytes;
}

void PrefixCache::clear() {
  std::list<Entry> dropped;
  const std::lock_guard lock(mutex_);
  dropped.swap(entries_);
}

std::string prefixKey(const std::vector<const PipelineStep*>& steps, std::size_t count) {
  std::string key;
  for (std::size_t i = 0; i < count; ++i) {
    key += steps[i]->filter->name;
    for (const double value : steps[i]->values) {
      key += ' ' + std::to_string(std::bit_cast<std::uint64_t>(value + 0.0));  // -0 equals 0
    }
    key += '\n';
  }
  const auto end = steps.begin() + static_cast<std::ptrdiff_t>(count);
  const bool canLeaveOut = std::any_of(
      steps.begin(), end, [](const PipelineStep* step) { return step->filter->traits->leavesOutObstacles; });
  if (canLeaveOut && needsObstacles(steps, count)) key += "with obstacles\n";
  return key;
}

std::vector<std::vector<CellReuse>> cellReuse(const std::shared_ptr<const Environment>& environment,
                                              const Pipeline& pipeline, ResultCache& cache) {
  std::vector<const PipelineStep*> steps;
  for (const PipelineStep& step : pipeline.steps)
    if (step.enabled) steps.push_back(&step);
  std::vector<std::vector<CellReuse>> blocks;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i]->filter->kind != FilterKind::Collapse) continue;
    std::optional<CachedPrefix> found = cache.inside().find(environment, prefixKey(steps, i + 1));
    blocks.push_back(found ? std::move(found->reuse) : std::vector<CellReuse>());
  }
  return blocks;
}

}  // namespace footfall::detail

namespace footfall {

ResultCache::ResultCache(std::size_t capacity, std::size_t bytes)
    : inside_(std::make_unique<detail::PrefixCache>(capacity, bytes)) {}
ResultCache::~ResultCache() = default;
void ResultCache::clear() { inside_->clear(); }

}  // namespace footfall
