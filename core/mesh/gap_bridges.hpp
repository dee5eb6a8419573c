// Gaps that an agent steps over as pieces of surface, so that code that moves on a mesh need not treat them separately.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// The triangles that face up (exactly) between the two edges of a link, over their own vertices: two, or one where the
/// edges meet at an end. None where the edges do not lie beside each other so, as those of a step do not.
std::vector<Triangle> bridgeOver(const StepLink& link, std::span<const Vec3> vertices);

/// A bound of the lengths in the plan of all ways over a link; 0 where its edges lie over each other.
double widthOf(const StepLink& link, std::span<const Vec3> vertices);

/// The mesh with a bridge over each of its gaps, behind its own triangles. An edge gets one bridge, and none where a
/// step leads on from it. Where the edges of a gap meet at an end, but not in height, a further step leads on to the
/// bridge.
NavigationMesh withBridges(const NavigationMesh& mesh);

}  // namespace footfall::detail
