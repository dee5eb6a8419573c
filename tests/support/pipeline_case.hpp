// Random environments with random filters, each from one number.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/soup.hpp"

namespace footfall::fuzz {

/// One experiment. `soup` may lose triangles and `anyFilters` lines, and it is still one.
struct PipelineCase {
  std::string kind;  ///< a description for failures
  test::Soup soup;
  bool bothSides = false;
  double slope = 45;
  double clearance = 2;
  bool roundingIsHarmless = false;  ///< true on a grid so coarse that rounding closes nothing
  /// Filters that keep the set, in any order: `slope`, `clearance`, and for example more generous ones.
  std::vector<std::string> sameSetFilters;
  /// Anything: only the same for any number of threads and any order of the input.
  std::vector<std::string> anyFilters;
  int copies = 1;  ///< number of times that anyFilters repeats the soup along x and y, so that threads have work to
                   ///< share
  double copyDistance = 1;
  std::uint64_t order = 0;  ///< decides how the input is shuffled
};

/// Equal seeds give equal cases, on any machine.
PipelineCase makePipelineCase(std::uint64_t seed);

/// Filters one a line, as a pipeline's text.
std::string toPipelineText(const std::vector<std::string>& filters);

}  // namespace footfall::fuzz
