// The triangles above and below one place of the plan, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/exact/source_mesh.hpp"
#include "core/inspect/generic_place.hpp"

namespace footfall::detail {

std::array<ExactPoint, 3> cornersOf(const SourceMesh& mesh, Index face);

/// A triangle that is not vertical, and the height of its plane where one stands.
struct ColumnFace {
  Index face = -1;
  GenericNumber height;
};

/// All triangles of a generation that the place is inside, in the order of the triangles.
std::vector<ColumnFace> facesAt(const SourceMesh& mesh, const GenericPlace& place);

/// The lowest triangle strictly above `height`; of several at one height that of the smallest input triangle. Null when
/// there is none.
const ColumnFace* lowestAbove(const SourceMesh& mesh, const std::vector<ColumnFace>& column,
                              const GenericNumber& height);

/// Vertical triangles that stand over the floor at (x, y), which is meant as it is: those whose part above the floor's
/// plane and below `clearance` above it has a length in the plan, and passes there or ends there. Ascending.
std::vector<Index> wallsAt(const SourceMesh& mesh, const mpq_class& x, const mpq_class& y,
                           const std::array<ExactPoint, 3>& floor, const mpq_class& clearance);

/// The triangles under or at (x, y, z), outlines included, whose planes are highest; what is at most `reach` above z
/// counts as under it. Vertical ones do not count. Several where they lie in one plane or cross there; ascending.
std::vector<Index> highestBelow(const SourceMesh& mesh, const Vec3& point, double reach);

}  // namespace footfall::detail
