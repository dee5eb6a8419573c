// `footfall compare`: load two navigation meshes, compare, tell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/compare/mesh_comparison.hpp"

namespace footfall::app {
using namespace detail;

struct CompareArguments {
  std::array<std::string, 2> files;  ///< A, the ground truth, and B
  ComparisonOptions options;
  std::string up;  ///< a name of nameOf(UpAxis), or empty: what the files state
  bool json = false;
  bool failIfDifferent = false;
  std::optional<double> failAbove;  ///< area in the plan
  int threads = 0;                  ///< 0: as many as the machine has
  bool quiet = false;
};

struct CompareOutcome {
  std::string report;      ///< for stdout
  std::string difference;  ///< one line, when the meshes differ by more than the arguments allow; else empty
};

/// SIGINT and SIGTERM cancel while it runs. Throws InputError or Cancelled.
CompareOutcome compareFiles(const CompareArguments& arguments);

}  // namespace footfall::app
