// Lines that show steps, gaps and drops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/navigation_mesh.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// Adds the lines of all links and drops of a mesh, and their layers where the mesh has layers.
void addLinkLines(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry);

}  // namespace footfall::ui
