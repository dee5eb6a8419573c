// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/cell_share_reader.hpp"

#include <algorithm>

namespace footfall::detail {

CellShareReader::CellShareReader(const CellFloors& floors, const std::vector<char>& walkable,
                                 const std::vector<FaceTest>& tests, const ClearancePass& clearance,
                                 std::size_t filters)
    : floors_(floors),
      walkable_(walkable),
      tests_(tests),
      clearance_(clearance),
      filters_(filters),
      firstCell_(walkable.size(), -1) {
  keepFirstCells(floors, [this](Index face, Index cell) { firstCell_[face] = cell; });
}

CellShare CellShareReader::read(Index cell, std::string_view bytes) const {
  const PlanKernel& kernel = clearance_.kernel();
  CellShare share = decodeCellShare(
      bytes, {static_cast<Index>(kernel.mesh().scaled.size()), static_cast<Index>(kernel.mesh().triangles.size()),
              static_cast<Index>(kernel.heights().size()), filters_});
  // A floor that cells share and must not cut into parts is the first one's.
  for (const FaceResult& result : share.faces)
    if (!isFloorOf(cell, result.face) || isDivided(result.face) || firstCell_[result.face] != cell)
      throw BadBytes("it has a floor of another cell");
  for (const FacePart& part : share.parts)
    if (!isFloorOf(cell, part.face) || !isDivided(part.face))
      throw BadBytes("it has a part of a floor of another cell");
  std::sort(share.parts.begin(), share.parts.end(),
            [](const FacePart& a, const FacePart& b) { return a.face < b.face; });
  return share;
}

bool CellShareReader::isFloorOf(Index cell, Index face) const {
  const auto begin = floors_.floors.begin() + static_cast<std::ptrdiff_t>(floors_.first[cell]);
  const auto end = floors_.floors.begin() + static_cast<std::ptrdiff_t>(floors_.first[cell + 1]);
  if (walkable_[face] == 0 || !std::binary_search(begin, end, face)) return false;
  ExactFallbacks ignored;
  return std::all_of(tests_.begin(), tests_.end(), [&](const FaceTest& test) { return test(face, ignored); });
}

bool CellShareReader::isDivided(Index face) const { return floors_.cellCount[face] > 1 && clearance_.canShare(face); }

}  // namespace footfall::detail
