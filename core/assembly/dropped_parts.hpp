// What AreaFilter took away stays away when floors are cut anew.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/assembly/walkable_state.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The mesh without the triangles that lie in `dropped`, whose outlines are among the cuts that the mesh was made from.
std::shared_ptr<const WalkableMesh> withoutDropped(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                   const WalkableMesh& dropped, RunContext& context,
                                                   ExactFallbacks& fallbacks);

}  // namespace footfall::detail
