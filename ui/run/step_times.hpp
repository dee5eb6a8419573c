// The times of steps in earlier runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// Times in milliseconds, by the steps so far.
class StepTimes {
 public:
  /// Stores the times of a finished run; prefixes[i] names the steps before step i.
  void remember(const std::vector<StepStatistics>& steps, const std::vector<std::string>& prefixes) {
    if (times_.size() > kKnownTimes) times_.clear();
    for (std::size_t i = 0; i < steps.size() && i + 1 < prefixes.size(); ++i) times_[prefixes[i + 1]] = steps[i].wallMs;
  }
  [[nodiscard]] std::optional<double> find(const std::string& steps) const {
    const auto known = times_.find(steps);
    return known == times_.end() ? std::nullopt : std::optional(known->second);
  }
  void clear() { times_.clear(); }

 private:
  static constexpr std::size_t kKnownTimes = 1000;  // older entries are of values that nobody returns to
  std::map<std::string, double> times_;
};

}  // namespace footfall::ui
