// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/sampling.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/process_usage.hpp"

namespace footfall::bench {
using namespace detail;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double geometricMean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

double Samples::median(const std::string& name) const { return bench::median(values_.at(name)); }

double Samples::least(const std::string& name) const { return *std::ranges::min_element(values_.at(name)); }

double Samples::most(const std::string& name) const { return *std::ranges::max_element(values_.at(name)); }

int repeat(const Repetition& repetition, const std::function<void()>& once, const std::function<void()>& warm) {
  once();
  warm();
  const Stopwatch watch;
  int done = 0;
  while (done < repetition.runs && (done == 0 || watch.wallMs() < 1000 * repetition.seconds)) {
    once();
    ++done;
  }
  return done;
}

}  // namespace footfall::bench
