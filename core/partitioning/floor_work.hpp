// Estimates how much work the floors of a block are, and where, from a sample of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/partitioning/partition_builder.hpp"

namespace footfall::detail {

/// Work is in units of one trivial triangle. Small environments are looked at as a whole, of large ones a part that
/// follows from the environment alone.
struct FloorWork {
  /// Work at a place. The height is that of the floor's lowest corner.
  struct Item {
    std::array<double, 3> place{};
    double work = 0;
  };
  /// A floor of the sample.
  struct Floor {
    PlanBox box;
    double lowest = 0;
    double highest = 0;
    double count = 1;  ///< floors that it stands for
  };
  PlanBox box;  ///< box of the whole environment
  std::vector<Item> items;
  std::vector<Floor> floors;
  double total = 0;
};

/// A floor's work is its obstacles': those whose boxes overlap that of its clearance are tested, those that overlap it
/// are cut out of it. The more `cells` are to be made of it, the more floors are looked at.
FloorWork estimateFloorWork(const StrategyInput& input, std::size_t cells);

/// Fills Cell::cost.
void estimateCosts(Partition& partition, const FloorWork& work);

}  // namespace footfall::detail
