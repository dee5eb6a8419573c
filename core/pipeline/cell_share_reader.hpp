// Reads the share of a cell from bytes, and checks that each floor in it is one that the cell has.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/distributed/cell_share.hpp"
#include "core/filters/clearance/clearance_pass.hpp"
#include "core/filters/face_filter.hpp"
#include "core/partitioning/strategies.hpp"

namespace footfall::detail {

/// Reads the shares of one pass, whose objects have to stay; thread-safe.
class CellShareReader {
 public:
  /// `tests`: those of the pass, before its clearance. `walkable`: before the first of them.
  CellShareReader(const CellFloors& floors, const std::vector<char>& walkable, const std::vector<FaceTest>& tests,
                  const ClearancePass& clearance, std::size_t filters);

  /// The share, its parts ascending by floor. Throws BadBytes where it is none of this cell.
  [[nodiscard]] CellShare read(Index cell, std::string_view bytes) const;

 private:
  [[nodiscard]] bool isFloorOf(Index cell, Index face) const;
  /// True when cells that share the floor each have a part of its cuts.
  [[nodiscard]] bool isDivided(Index face) const;

  const CellFloors& floors_;
  const std::vector<char>& walkable_;
  const std::vector<FaceTest>& tests_;
  const ClearancePass& clearance_;
  const std::size_t filters_;
  std::vector<Index> firstCell_;  ///< first cell that lists each triangle, or -1
};

}  // namespace footfall::detail
