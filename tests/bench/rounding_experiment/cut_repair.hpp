// Cuts every triangle of an environment along cells, rounds the cut points and repairs what that breaks, as section
// 5.1.1 of the thesis does. It belongs to an experiment: Footfall itself cuts no obstacle and rounds no cut.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/exact/source_mesh.hpp"
#include "core/partitioning/cutting.hpp"

namespace footfall::bench {

/// The number of triangles of each geometry case (thesis 4.4.2) that rounding the cut points made.
struct CutCases {
  std::uint64_t exact = 0;      ///< case 1: every corner is where the exact cut has it
  std::uint64_t edge = 0;       ///< case 2: two corners fell together
  std::uint64_t point = 0;      ///< case 3: all corners fell together
  std::uint64_t collinear = 0;  ///< case 4
  std::uint64_t flipped = 0;    ///< case 5: the triangle faces the other way
  std::uint64_t moved = 0;      ///< none of these, but a corner moved
};

/// Triangles of a cut environment with rounded corners.
struct RoundedCut {
  std::vector<Vec3> vertices;
  std::vector<detail::CutTriangle> triangles;
};

/// The cut with its rounded places, nothing repaired. `cut` must not be welded: cutEnvironment() without `round`.
RoundedCut roundCut(const detail::CutEnvironment& cut);

/// Counts the cases that rounding has caused. It also uses the exact places, which takes much longer than the repair,
/// so it must not be part of a measured time. `cut` is the input of `rounded`.
CutCases countCases(const detail::SourceMesh& mesh, const detail::Partition& partition,
                    const detail::CutEnvironment& cut, const RoundedCut& rounded);

/// Repairs cases 2 to 5 as 4.4.2 describes. Vertices in one place become one, which closes cases 2 and 3. A triangle
/// with collinear corners (case 4) is removed. A flipped triangle (case 5) loses the corner opposite its longest side,
/// which collapses to the nearer end of that side. No obstacle edge has to be projected (algorithm 3), because none
/// exists before the clearance filter. The loop ends, because every collapse removes a triangle.
void repairCut(const detail::SourceMesh& mesh, RoundedCut& rounded);

/// The orientation of a piece relative to the triangle `source` of `mesh`, exactly: +1 where they turn alike, 0 where
/// the corners are collinear or equal, -1 where they turn the other way.
int turnOf(const detail::SourceMesh& mesh, detail::Index source, const std::array<Vec3, 3>& corners);

}  // namespace footfall::bench
