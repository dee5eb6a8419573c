// The strategies: where the cuts between cells go (thesis 4.3.1 to 4.3.3; height-aware and Auto are ours).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/source_mesh.hpp"
#include "core/partitioning/partition.hpp"

namespace footfall {
enum class FilterType : std::uint8_t;
}

namespace footfall::detail {

/// The data from which a strategy decides.
struct StrategyInput {
  const SourceMesh& mesh;
  std::span<const char> walkable;  ///< one flag per triangle: it is a floor
  std::span<const char> removed;   ///< one flag per triangle: it was removed
  double clearance = 0;            ///< height of the block's first clearance filter, in the environment's units; 0:
                                   ///< none
  int threads = 1;                 ///< number of threads that will run the cells
  Poll poll = {};
};

/// The cells of a strategy, by its type and one value for each of its parameters. Deterministic: depends
/// on nothing but the arguments (and only AutoStrategy on the threads).
Partition makePartition(FilterType strategy, const std::vector<double>& values, const StrategyInput& input);

/// The floors that have a part in each cell: for cell c, floors[first[c]] to floors[first[c + 1] - 1], ascending.
/// Conservative: a floor may be listed where it has no area.
struct CellFloors {
  std::vector<std::size_t> first;
  std::vector<Index> floors;
  /// The number of cells in which each triangle is listed.
  std::vector<Index> cellCount;
};
/// Calls take(floor, cell) for all of them, cells from last to first: what is kept in the end is the first cell that
/// lists a floor, to which a floor belongs that cells share and do not divide.
template <class Take>
void keepFirstCells(const CellFloors& floors, const Take& take) {
  for (std::size_t cell = floors.first.size() - 1; cell-- > 0;)
    for (std::size_t i = floors.first[cell]; i < floors.first[cell + 1]; ++i)
      take(floors.floors[i], static_cast<Index>(cell));
}
/// Lists all triangles with walkable[t] != 0, and counts Cell::floors and Cell::obstacles.
CellFloors assignFloors(Partition& partition, const StrategyInput& input);

}  // namespace footfall::detail
