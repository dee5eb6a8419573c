// Finds the triangles of a walkable mesh that are those of an earlier one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/assembly/earlier_result.hpp"

namespace footfall::detail {

/// A triangle is an earlier one when its face is, and its corners, one for one, are the same vertices: the same points
/// of the same sources, with the same rounded coordinates. Vertices correspond one to one. Whatever follows from such
/// triangles alone is what it was.
struct MeshRelation {
  std::vector<Index> triangleBefore;  ///< number of each triangle in the earlier mesh, or -1; each at most once
  Index related = 0;                  ///< number of related triangles
  std::vector<Index> vertexBefore;    ///< the same for each vertex of a related triangle; others may have -1
  std::vector<Index> vertexNow;       ///< number now of each vertex of the earlier mesh, or -1
};

/// `before` is the mesh of a state that `earlier` relates to `now`'s. Triangles of a face are compared in their order;
/// those that are not found may still be there.
MeshRelation relateMeshes(const EarlierResult& earlier, const WalkableMesh& before, const WalkableMesh& now);

}  // namespace footfall::detail
