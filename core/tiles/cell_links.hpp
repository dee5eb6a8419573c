// Steps between the floors of a cell and those that it sees, exactly as in the whole environment.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two borders have in common follows from both and what stands near them. A link puts vertices on both borders,
// and each of them goes on to all borders that are linked there: always at one place of the plan, at most a step higher
// or lower each time. So a cell that sees so many steps over and under its own floors as there are links in a row
// there knows all vertices of its own borders.
#pragma once

#include <cstdint>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/tiles/dropped_triangles.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

using StatePtr = std::shared_ptr<const WalkableState>;

/// The state with those triangles of its mesh that lie in chosen faces and were not dropped. `numbers` has for each
/// input triangle its number in the environment; `dropped` may be null.
StatePtr withChosenTriangles(const StatePtr& state, const std::vector<char>& chosen,
                             const std::vector<std::uint32_t>& numbers, const DroppedTriangles* dropped);

/// What a StepFilter makes of what a cell sees. For own faces (one for each source triangle) the mesh and the links are
/// those of the whole; null where there are as many links in a row as the cell sees steps.
StatePtr withSteps(const StatePtr& state, const std::vector<char>& isOwn, const PipelineStep& step, int reach,
                   RunContext& context);

/// A link with an edge of own faces.
struct CellLink {
  MeshLink link;                        ///< from the edge whose first triangle comes first
  bool hasFrom = false, hasTo = false;  ///< the first triangle with that edge, in that direction, is of an own face
  bool isShared = false;                ///< other faces have a triangle at either edge
};
std::vector<CellLink> linksOf(const WalkableMesh& mesh, const std::vector<char>& isOwn);

}  // namespace footfall::detail
