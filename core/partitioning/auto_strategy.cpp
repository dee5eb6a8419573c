// AutoStrategy: one cell where threads would only get in each other's way, else a few cells for each thread (ours).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>

#include "core/partitioning/partition_builder.hpp"

namespace footfall {
namespace {

// Below a few thousand triangles one thread is fastest (design, section 4): what a block spends on cells, clipping and
// merging is then of the size of the work itself.
constexpr std::size_t kFewTriangles = 2000;
// About 3 ms on one thread (a trivial triangle is some 4 microseconds of clearance filter).
constexpr double kLittleWork = 800;
// Idle threads help with cells that are not finished, so that a few cells for each thread balance; more only cut more
// floors.
constexpr int kCellsPerThread = 2;
constexpr int kLargestDepth = 12;
constexpr double kFewestTriangles = 50;

}  // namespace

AutoChoice chooseStrategy(const StrategyInput& input, const std::function<double(const RecursionLimits&)>& work) {
  AutoChoice choice;
  const auto cells = static_cast<unsigned>(std::clamp(input.threads, 1, 1 << kLargestDepth)) * kCellsPerThread;
  const int depth = std::min(static_cast<int>(std::bit_width(cells - 1)), kLargestDepth);
  choice.limits = {kFewestTriangles, static_cast<double>(depth)};
  const std::size_t triangles = input.mesh.triangles.size();
  const std::string size = std::to_string(triangles) + " triangles";
  if (input.threads <= 1) {
    choice.reason = "One cell, because one thread runs.";
  } else if (triangles < kFewTriangles) {
    choice.reason = "One cell, because an environment of " + size + " is done before cells would pay.";
  } else if (work(choice.limits) < kLittleWork) {
    choice.reason = "One cell, because the " + size + " are little work.";
  } else {
    choice.isOneCell = false;
    choice.reason = "Up to " + std::to_string(1 << depth) + " cells of about equal estimated work for " +
                    std::to_string(input.threads) + " threads, because " + size +
                    " are enough work to share; cut between storeys where that cuts no floor.";
  }
  return choice;
}

}  // namespace footfall
