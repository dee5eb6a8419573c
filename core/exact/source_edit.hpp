// Makes the source mesh of an edited environment from that of its base, without sorting it anew.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/source_mesh.hpp"

namespace footfall::detail {

/// The numbers of an edited mesh in terms of those of its base. All maps rise: what was kept keeps its order, so that
/// every choice by the smaller number stays what it was.
struct SourceEdit {
  std::weak_ptr<const SourceMesh> base;
  std::vector<Index> vertexOf;    ///< new number of each vertex of the base, or -1
  std::vector<Index> planOf;      ///< new number of each plan id of the base, or -1 (also for numbers that are no plan
                                  ///< id)
  std::vector<Index> triangleOf;  ///< new number of each triangle of the base, or -1
  std::vector<Index> baseOf;      ///< number in the base of each triangle, or -1
  std::vector<Index> addedTriangles;  ///< new triangles that are not degenerate, ascending
  std::vector<Box> removed, added;    ///< boxes of the triangles that went and came
};

/// A soup of which the first vertices and triangles are some of another one, in the same order.
struct SoupEdit {
  SoupView soup;
  std::span<const std::uint32_t> keptVertices;   ///< numbers in the other one, ascending
  std::span<const std::uint32_t> keptTriangles;  ///< numbers in the other one, ascending
  bool bothSides = false;                        ///< meaning as in makeSourceMesh()
};

/// The mesh that makeSourceMesh() makes of the edit's soup; the other soup is the one that `base` was made of. Null
/// when they do not fit together, or when the edit changes the scale of the grid. `poll` is called now and then and may
/// throw to cancel.
std::shared_ptr<const SourceMesh> editSourceMesh(const std::shared_ptr<const SourceMesh>& base, const SoupEdit& edit,
                                                 Poll poll);

}  // namespace footfall::detail
