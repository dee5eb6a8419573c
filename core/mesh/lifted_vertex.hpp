// Vertices of a walkable mesh from plan points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// A plan point in the plane of a face. `approximate` is relative to the face's first corner.
MeshVertex liftedVertex(const PlanKernel& kernel, Index face, const PlanPoint& point,
                        const ApproximatePoint& approximate);
MeshVertex liftedVertex(const PlanKernel& kernel, Index face, const PlanPoint& point);

}  // namespace footfall::detail
