// Steps between the floors of a cell and those that it sees, exactly as in the whole environment.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The link of two borders follows from both borders and the obstacles near them. A link puts vertices on both borders,
// and each of them goes on to all borders that are linked there: always at one place of the plan, at most a step higher
// or lower each time. So a cell that sees so many steps over and under its own floors as there are links in a row there
// knows all vertices of its own borders.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/tiles/cell_faces.hpp"
#include "core/tiles/dropped_triangles.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

using StatePtr = std::shared_ptr<const WalkableState>;

/// The state without triangles of its mesh that were dropped. `numbers` has for each input triangle its number in the
/// environment, here and below.
StatePtr withoutDropped(const StatePtr& state, const std::vector<std::uint32_t>& numbers,
                        const DroppedTriangles& dropped);

/// The steps of a cell; faces are source triangles.
struct LinkedCell {
  StatePtr state;
  std::vector<char> isOwn;  ///< one flag per face; those at gaps are not own
  FloorsAtGaps atGaps{};    ///< own ones, which are for a cell of their own
};

/// The result of a StepFilter on what a cell sees. For own faces the mesh and the links are those of the whole; empty
/// where there are as many links in a row as the cell sees steps. `hasAllGaps`: the cell's own faces are those at gaps,
/// of all cells.
std::optional<LinkedCell> withSteps(const StatePtr& state, const std::vector<std::uint32_t>& numbers,
                                    const std::vector<char>& isSeen, const std::vector<char>& isOwn,
                                    const PipelineStep& step, int reach, bool hasAllGaps, RunContext& context);

/// A link with an edge of own faces.
struct CellLink {
  MeshLink link;                        ///< leads from the edge whose first triangle comes first
  bool hasFrom = false, hasTo = false;  ///< the first triangle with that edge, in that direction, is of an own face
  bool isShared = false;                ///< other faces have a triangle at either edge
};
std::vector<CellLink> linksOf(const WalkableMesh& mesh, const std::vector<char>& isOwn);

}  // namespace footfall::detail
