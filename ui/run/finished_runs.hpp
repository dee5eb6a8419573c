// A cache of finished results: switching back to one of them needs no run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <string>

#include "core/pipeline/runner.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/cells/cell_block.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// A finished run with all data that exports need.
struct FinishedRun {
  std::shared_ptr<const Environment> environment;
  Pipeline pipeline;
  RunResult result;
  CellRanks ranks = {};  ///< ranks that ran the cells
  ProcessorUse processors = {};
};

/// Finished runs on one environment, by the text of the enabled steps. They are bounded by the estimated memory of
/// meshes and vertices (shared data counts for each result). The least recently used run is dropped first; the newest
/// stays if it fits.
class FinishedRuns {
 public:
  static constexpr std::size_t kBytes = std::size_t{512} << 20;

  explicit FinishedRuns(std::size_t bytes = kBytes) : bound_(bytes) {}

  struct Entry {
    std::string key;
    std::shared_ptr<const FinishedRun> run;
    ViewContent content;
    std::size_t bytes = 0;
  };
  void store(const std::string& key, std::shared_ptr<const FinishedRun> run, const ViewContent& content);
  /// Null when there is none; counts as a use. Valid until the next store() or clear().
  const Entry* find(const std::string& key);
  /// Finds a run without counting it as a use.
  [[nodiscard]] std::shared_ptr<const FinishedRun> peek(const std::string& key) const;
  void clear();
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t count() const { return entries_.size(); }

 private:
  std::size_t bound_;
  std::size_t bytes_ = 0;
  std::list<Entry> entries_;  // most recently used first
};

}  // namespace footfall::ui
