// The results of an earlier run at the same place of a pipeline, and the parts of them that still hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <memory_resource>
#include <optional>
#include <vector>

#include "core/assembly/face_mesh.hpp"
#include "core/assembly/recall.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/base/copy_memory.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/exact/source_edit.hpp"

namespace footfall::detail {

/// An earlier state whose source mesh is the present one or the one that it was edited from. Faces keep their parts
/// while nothing came or went in the clearance above them; numbers are those of the present mesh.
class EarlierResult {
 public:
  /// Empty when the two do not relate. Their heights may differ.
  static std::optional<EarlierResult> relate(const StatePtr& before, const PlanKernel& now);

  [[nodiscard]] const WalkableState& state() const { return *before_; }
  /// The number that a triangle had, or -1.
  [[nodiscard]] Index faceBefore(Index face) const { return edit_ ? edit_->baseOf[face] : face; }
  /// The number that a triangle of the earlier mesh has now, or -1.
  [[nodiscard]] Index faceNow(Index before) const { return edit_ ? edit_->triangleOf[before] : before; }
  /// True when two vertices of walkable meshes are the same: point, face, source and rounded place.
  [[nodiscard]] bool isSame(const MeshVertex& before, const MeshVertex& now) const;
  /// True when the levels denote the same heights.
  [[nodiscard]] bool sameHeights() const { return sameHeights_; }
  /// An earlier vertex of a mesh, in numbers of the present one: what it was made of must still be there.
  [[nodiscard]] MeshVertex vertexNow(const MeshVertex& before) const;
  /// True when the places of the plan that a point was made of are still there.
  [[nodiscard]] bool hasPlaces(const PlanPoint& before) const;
  /// True when the lines that cut a face are those of the earlier state, in the same order. Both have cuts.
  [[nodiscard]] bool hasSameLines(Index face, const CutTable& now) const;
  /// True when all of a face's cuts are those of the earlier state. Both have cuts.
  [[nodiscard]] bool hasSameCuts(Index face, const CutTable& now) const;
  /// True when a triangle that came or went may reach into the box.
  [[nodiscard]] bool isTouched(const Box& box) const;

  // The data that a clearance filter kept of a face:

  [[nodiscard]] std::shared_ptr<const FaceCuts> cuts(Index faceBefore, const CopyMemory& memory) const;
  [[nodiscard]] std::shared_ptr<const FaceMesh> mesh(Index faceBefore, const CopyMemory& memory) const;
  /// The obstacles above a face that still exist.
  [[nodiscard]] std::shared_ptr<const std::pmr::vector<Index>> candidates(Index faceBefore,
                                                                          const CopyMemory& memory) const;
  /// The obstacles above a face that no longer exist, in numbers of the earlier mesh.
  [[nodiscard]] std::vector<Index> gone(Index faceBefore) const;
  /// The boxes around all triangles that went, and around all that came, if they may reach into the box; else boxes
  /// that overlap none.
  [[nodiscard]] std::array<Box, 2> changedIn(const Box& box) const;
  /// The triangles that came, except degenerate ones.
  [[nodiscard]] const std::vector<Index>& added() const;

 private:
  EarlierResult(StatePtr before, std::shared_ptr<const SourceEdit> edit, const PlanKernel& now, bool sameHeights);
  /// The number of a source vertex, and of a plan id, in the present mesh, or -1.
  [[nodiscard]] Index vertexNow(Index before) const {
    if (before >= sourcesBefore_) return placeNow_[before - sourcesBefore_];
    return edit_ ? edit_->vertexOf[before] : before;
  }
  [[nodiscard]] Index planNow(Index before) const {
    if (before >= sourcesBefore_) return placeNow_[before - sourcesBefore_];
    return edit_ ? edit_->planOf[before] : before;
  }
  [[nodiscard]] PlanPoint renumbered(const PlanPoint& point) const;
  [[nodiscard]] PlanLine renumbered(PlanLine line) const;

  StatePtr before_;
  std::shared_ptr<const SourceEdit> edit_;    ///< null: the same mesh
  bool sameHeights_;                          ///< levels mean what they meant
  bool hasSameNumbers_ = true;                ///< of vertices, triangles and places of the plan
  Index sourcesBefore_ = 0;                   ///< vertices of the earlier mesh that are no added places
  std::vector<Index> placeNow_;               ///< number now of each place that was added to the earlier mesh, or -1
  Box removed_, added_;                       ///< around all that went and came
  std::shared_ptr<const TriangleTree> tree_;  ///< tree over both, if there are many
};

}  // namespace footfall::detail
