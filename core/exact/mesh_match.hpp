// Finds what two source meshes that were made apart from each other have in common.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/base/poll.hpp"
#include "core/exact/source_edit.hpp"

namespace footfall::detail {

/// The edit that leads from one mesh to another: vertices are the same where they lie at one place, triangles where
/// their corners are. Neither mesh has places of the plan. Null where the scales of the grids differ. `poll` may throw
/// to cancel.
std::shared_ptr<const SourceEdit> matchSourceMeshes(const std::shared_ptr<const SourceMesh>& base,
                                                    const SourceMesh& now, const Poll& poll);

}  // namespace footfall::detail
