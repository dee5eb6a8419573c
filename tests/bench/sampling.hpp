// Repeating a measurement and what is kept of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// The median; 0 for an empty list; for an even number of values the mean of the two in the middle.
double median(std::vector<double> values);

/// The mean of positive values; 0 when there are none.
double geometricMean(const std::vector<double>& values);

/// The number of measurements: `runs` after one warm-up, but no more once `seconds` have gone (one run is always made).
struct Repetition {
  int runs = 7;
  double seconds = 20;
};

/// Figures by name, one value a run.
class Samples {
 public:
  void add(const std::string& name, double value) { values_[name].push_back(value); }
  void clear() { values_.clear(); }
  [[nodiscard]] double median(const std::string& name) const;
  [[nodiscard]] double least(const std::string& name) const;
  [[nodiscard]] double most(const std::string& name) const;

 private:
  std::map<std::string, std::vector<double>> values_;
};

/// Calls `once` for the warm-up, then `warm` (which may clear what the warm-up left), then `once` again for each run.
/// Returns the number of runs after the warm-up.
int repeat(const Repetition& repetition, const std::function<void()>& once, const std::function<void()>& warm);

}  // namespace footfall::bench
