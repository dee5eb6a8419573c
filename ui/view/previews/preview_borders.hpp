// Finds the borders of the walkable area, for previews of edits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/base/poll.hpp"
#include "footfall/navigation_mesh.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// An edge with one triangle, on its left seen from above.
struct PreviewBorder {
  Vec3 from, to;
  Vec3 along;       ///< from `from` to `to` in the plan, a unit vector
  Vec3 inward;      ///< towards the triangle, level, a unit vector
  double size = 0;  ///< in the plan
};

/// All borders of a mesh that have an extent in the plan and that no step or gap crosses.
std::vector<PreviewBorder> findBorders(const NavigationMesh& mesh, Poll poll);

/// The box around points, extended by `sideways` in the plan and by `upright` in height.
Box boxAround(const std::vector<Vec3>& points, double sideways, double upright);

}  // namespace footfall::ui
