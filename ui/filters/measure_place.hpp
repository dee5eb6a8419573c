// Places of a result where a step or a gap is visible.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "footfall/navigation_mesh.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

struct MeasurePlace {
  Vec3 at;           ///< middle of the lower edge of a step, or of the first edge of a gap
  Vec3 along;        ///< level unit vector: along a step's edge, or across a gap
  double value = 0;  ///< height of the step, or width of the gap
};

/// The link of a kind nearest to a place, among those for which `isShown` is true.
std::optional<MeasurePlace> findLink(const NavigationMesh& result, StepKind kind, const Vec3& near,
                                     const std::function<bool(const Vec3&)>& isShown);

}  // namespace footfall::ui
