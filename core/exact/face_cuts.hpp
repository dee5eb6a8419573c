// The cuts that obstacles leave on one floor triangle: segments with winding numbers, and walls.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <vector>

#include "core/exact/plan_kernel.hpp"

namespace footfall::detail {

/// A piece of a region's outline or of a wall's trace.
struct CutSegment {
  Index from = -1, to = -1;   ///< points of the FaceCuts
  Index line = -1;            ///< line of the FaceCuts
  std::int8_t direction = 1;  ///< +1: from -> to runs along the line
  int winding = 0;            ///< regions on the left minus regions on the right
  bool wall = false;
};

/// Value type: everything that triangulating the face needs, in ids of one generation. Outlines of regions along the
/// face's own edges divide nothing and are left out: the regions over one place of the face, and what is crossed from
/// there, determine the regions over all others.
struct FaceCuts {
  FaceCuts() = default;
  /// A copy that lies in `memory`.
  FaceCuts(const FaceCuts& other, std::pmr::memory_resource* memory)
      : removed(other.removed),
        edgeWalls(other.edgeWalls),
        startWinding(other.startWinding),
        points(other.points, memory),
        borders(other.borders, memory),
        lines(other.lines, memory),
        segments(other.segments, memory),
        dependsOnFloors(other.dependsOnFloors) {}

  bool removed = false;        ///< obstacles cover the whole face
  std::uint8_t edgeWalls = 0;  ///< bit k: a wall stands along the whole edge from corner k to k + 1
  int startWinding = 0;        ///< number of regions beside the start of the face's edge from corner 0 to 1
  std::pmr::vector<PlanPoint> points;
  std::pmr::vector<std::uint8_t> borders;  ///< bit k of each point: it is known to lie on the face's edge k
  std::pmr::vector<PlanLine> lines;
  std::pmr::vector<CutSegment> segments;

  /// True when it mattered that another face is a floor: coplanar floors overlap, and one of them stays.
  bool dependsOnFloors = false;

  /// Keeps its memory.
  void clear() {
    removed = dependsOnFloors = false;
    edgeWalls = 0;
    startWinding = 0;
    points.clear();
    borders.clear();
    lines.clear();
    segments.clear();
  }
  [[nodiscard]] bool empty() const { return !removed && edgeWalls == 0 && segments.empty() && !dependsOnFloors; }
};

/// The cuts of all source triangles. Most have none, and later runs share those that they can reuse.
class CutTable {
 public:
  explicit CutTable(std::size_t faces) : cuts_(faces), removed_(faces, 0) {}

  const FaceCuts& operator[](std::size_t face) const {
    static const FaceCuts kNone;
    return cuts_[face] ? *cuts_[face] : kNone;
  }
  [[nodiscard]] const std::shared_ptr<const FaceCuts>& shared(std::size_t face) const { return cuts_[face]; }
  /// True when obstacles cover the whole face.
  [[nodiscard]] bool isRemoved(std::size_t face) const { return removed_[face] != 0; }
  void set(std::size_t face, std::shared_ptr<const FaceCuts> cuts) {
    removed_[face] = static_cast<char>(cuts && cuts->removed);
    cuts_[face] = std::move(cuts);
  }
  void set(std::size_t face, FaceCuts&& cuts) {
    if (!cuts.empty()) set(face, std::make_shared<const FaceCuts>(std::move(cuts)));
  }

 private:
  std::vector<std::shared_ptr<const FaceCuts>> cuts_;
  std::vector<char> removed_;
};

}  // namespace footfall::detail
