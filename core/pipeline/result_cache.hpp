// The inside of ResultCache; only the runner looks in here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/filters/rounding/known_places.hpp"
#include "core/pipeline/cell_reuse.hpp"
#include "core/pipeline/runner.hpp"
#include "core/pipeline/state_size.hpp"

namespace footfall::detail {

/// The state after the first steps of a pipeline. An entry does not depend on others, so it stays useful when those of
/// shorter prefixes are gone.
struct CachedPrefix {
  StatePtr state;
  StateSummary summary;
  std::vector<StepStatistics> steps;             ///< statistics of the whole prefix, as measured
  std::shared_ptr<const NavigationMesh> mesh;    ///< empty until it is made
  std::shared_ptr<const RoundedPlaces> rounded;  ///< the places of which it was made
  std::vector<CellReuse> reuse;                  ///< of the cells of a block that ends with the prefix
};

/// Thread-safe; see ResultCache.
class PrefixCache {
 public:
  using EnvironmentPtr = std::shared_ptr<const Environment>;

  /// `bytes` 0: an eighth of the machine's memory.
  PrefixCache(std::size_t capacity, std::size_t bytes);

  /// Keeps the states of these prefixKey()s alone, and no data for runs after an edit: the pipelines of all runs are
  /// known beforehand. To be called before the first run.
  void keepOnly(std::unordered_set<std::string> keys) { only_ = std::move(keys); }
  /// Returns whether runs after an edit may copy data of earlier runs.
  [[nodiscard]] bool servesEdits() const { return !only_; }

  /// `key` is prefixKey() of the steps. Touches the entry.
  std::optional<CachedPrefix> find(const EnvironmentPtr& environment, const std::string& key);
  /// The state that a run had after the same filters as the first `count` of `steps` on this environment or on the one
  /// that it is an edit of; null when there is none. The most recent one with the same parameters, else the most recent
  /// one with any.
  StatePtr findEarlier(const EnvironmentPtr& environment, const std::vector<const PipelineStep*>& steps,
                       std::size_t count);
  /// The same of those whose navigation mesh was made.
  KnownPlaces findPlaces(const EnvironmentPtr& environment, const std::vector<const PipelineStep*>& steps,
                         std::size_t count);
  /// Replaces an entry with the same environment and key; the least recently used goes when there are too many.
  void store(const EnvironmentPtr& environment, const std::string& key, CachedPrefix prefix);
  void clear();
  /// The memory that all entries hold together, about.
  [[nodiscard]] std::size_t bytes();

 private:
  struct Entry {
    // Held weakly and compared by owner: an address that is used again is another environment.
    std::weak_ptr<const Environment> environment;
    std::string key;
    CachedPrefix prefix;
    std::vector<StatePart> parts;  ///< the memory that the prefix holds
  };
  /// The prefix for findEarlier(), or of those with rounded places for findPlaces(); to be called with the lock.
  [[nodiscard]] CachedPrefix earlierPrefix(const EnvironmentPtr& environment, const EnvironmentPtr& base,
                                           const std::vector<const PipelineStep*>& steps, std::size_t count,
                                           bool hasPlaces) const;
  std::list<Entry>::iterator locate(const EnvironmentPtr& environment, const std::string& key);
  /// The number of most recently used entries that stay within the bounds.
  [[nodiscard]] std::size_t countToKeep() const;

  std::mutex mutex_;
  std::size_t capacity_;
  std::size_t mostBytes_;
  std::optional<std::unordered_set<std::string>> only_;
  std::list<Entry> entries_;  // most recently used first
};

/// Filters and parameters of the first `count` of `steps` as one text, equal exactly when they are equal.
std::string prefixKey(const std::vector<const PipelineStep*>& steps, std::size_t count);

}  // namespace footfall::detail
