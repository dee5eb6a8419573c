// Places of a result at which a step or a gap can be seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "footfall/navigation_mesh.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

struct MeasurePlace {
  Vec3 at;           ///< the middle of the lower edge of a step, or of the first edge of a gap
  Vec3 along;        ///< level, a unit vector: along a step's edge, over a gap
  double value = 0;  ///< the height of the step, or the width of the gap
};

/// The link of a kind that is nearest to a place, of those that `isShown` says can be seen.
std::optional<MeasurePlace> findLink(const NavigationMesh& result, StepKind kind, const Vec3& near,
                                     const std::function<bool(const Vec3&)>& isShown);

}  // namespace footfall::ui
