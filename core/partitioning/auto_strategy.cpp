// AutoStrategy: one cell where threads would only get in each other's way, else a few cells for each thread (ours).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/counted_text.hpp"
#include "core/partitioning/partition_builder.hpp"

namespace footfall::detail {
namespace {

// Below this, threads share the floors of one cell: even the estimate would be a large part of the work.
constexpr std::size_t kFewTriangles = 16384;
// Idle threads help with cells that are not finished, so that two cells for each thread balance. More would only cut
// more floors, and so would cells of less than about 15 ms on one thread (a trivial triangle is some 4 microseconds of
// clearance filter).
constexpr double kCellsPerThread = 2;
constexpr double kLeastWorkOfCell = 4000;
constexpr int kLargestDepth = 12;
constexpr double kFewestTriangles = 50;

}  // namespace

AutoChoice chooseStrategy(const StrategyInput& input, const std::function<double(const RecursionLimits&)>& work) {
  AutoChoice choice;
  const std::size_t triangles = input.mesh.triangles.size();
  if (input.threads <= 1) {
    choice.reason = FOOTFALL_TEXT("One cell, because one thread runs.");
    return choice;
  }
  if (triangles < kFewTriangles) {
    choice.reason =
        Text(FOOTFALL_TEXT("One cell, because an environment of %1 is done before cells would pay: threads share its "
                           "floors."),
             countedText(triangles, FOOTFALL_TEXT("1 triangle"), FOOTFALL_TEXT("%1 triangles")));
    return choice;
  }
  const auto depthOf = [](double cells) {
    return std::clamp(static_cast<int>(std::ceil(std::log2(std::max(cells, 1.0)))), 0, kLargestDepth);
  };
  const double most = kCellsPerThread * input.threads;
  const double affordable = work({kFewestTriangles, static_cast<double>(depthOf(most))}) / kLeastWorkOfCell;
  if (affordable < 2) {
    choice.reason = Text(FOOTFALL_TEXT("One cell, because the %1 triangles are little work: threads share its floors."),
                         Text::count(triangles));
    return choice;
  }
  const int depth = depthOf(std::min(most, affordable));
  choice.isOneCell = false;
  choice.limits = {kFewestTriangles, static_cast<double>(depth)};
  choice.reason =
      Text(FOOTFALL_TEXT("Up to %1 cells of about equal estimated work for %2 threads, because %3 triangles "
                         "are enough work to share; cut between storeys where that cuts no floor."),
           1 << depth, input.threads, Text::count(triangles));
  return choice;
}

}  // namespace footfall::detail
