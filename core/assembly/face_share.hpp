// The part of a floor in one cell that obstacles leave, kept until the cells are joined.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/exact/face_cuts.hpp"
#include "core/exact/plan_kernel.hpp"

namespace footfall::detail {

/// One side of a cell in the plan.
struct CellSide {
  PlanLine border;  ///< a Border line of the kernel
  int keep = 1;     ///< sign of the border's side on which the cell lies
};

/// Segments inside the cell are as in FaceCuts. Those that a border cut in two carry their obstacle: it has at most one
/// segment on each line, so pieces with the same obstacle and line belong together.
struct FaceShare {
  struct Piece {
    Index obstacle = -1;
    CutSegment segment;  ///< an end that a border made is -1
  };

  bool removed = false;  ///< one obstacle covers the whole face, in this cell and in all others
  std::uint8_t edgeWalls = 0;
  int startWinding = 0;  ///< regions beside the start of the face's first edge, as far as this cell has it
  bool dependsOnFloors = false;
  std::vector<PlanPoint> points;
  std::vector<std::uint8_t> borders;  ///< see FaceCuts
  std::vector<PlanLine> lines;
  std::vector<CutSegment> segments;
  std::vector<Piece> pieces;
  std::vector<Index> candidates;  ///< obstacles in the clearance above this part, ascending

  [[nodiscard]] bool empty() const {
    return !removed && edgeWalls == 0 && startWinding == 0 && !dependsOnFloors && segments.empty() && pieces.empty() &&
           candidates.empty();
  }
};

}  // namespace footfall::detail
