// Follows one place through the states of a run: what carries it there?
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "core/assembly/walkable_state.hpp"
#include "core/inspect/plan_column.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::detail {

/// A floor of a state at the place.
struct PlaceCover {
  Index face = -1;      ///< source triangle in whose plane it is
  Index triangle = -1;  ///< triangle of the state's mesh; -1 when the state has none yet
};

class PlaceFollower {
 public:
  /// Begins with the plane of a triangle of the first generation, which must not be vertical. `mesh` must live as long.
  PlaceFollower(const SourceMesh& mesh, Index face, GenericPlace place);

  /// The triangle under the place before the first filter: the triangle itself, or the first other one of its plane.
  std::optional<PlaceCover> begin(const WalkableState& state);

  /// The triangle under the place after a step that made `state` from the last one; empty: none any more. After a step
  /// that moved vertices, it comes from the same input triangles and is no farther from the place than the step may
  /// move something.
  std::optional<PlaceCover> follow(const WalkableState& state, const PipelineStep& step);

  [[nodiscard]] const GenericPlace& place() const { return place_; }
  /// The generation and the triangle of it in whose plane the place was last.
  [[nodiscard]] const SourceMesh& mesh() const { return *mesh_; }
  [[nodiscard]] Index face() const { return face_; }
  [[nodiscard]] GenericNumber height() const { return *place_.heightOf(cornersOf(*mesh_, face_)); }

 private:
  [[nodiscard]] bool isInPlane(Index face) const;
  [[nodiscard]] std::vector<PlaceCover> coversOf(const WalkableState& state) const;

  GenericPlace place_;
  const SourceMesh* mesh_;
  Index face_;
  std::set<std::uint32_t> inputs_;  ///< triangles of the environment in the first plane at the place
};

}  // namespace footfall::detail
