// Places that are equally far from three features of the border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/mesh/clearance_field.hpp"

namespace footfall::detail {

/// A feature and the fans of the corners at its ends, which identify features that share a corner.
struct AxisFeature {
  const FieldFeature* feature = nullptr;
  std::uint32_t beginFan = 0, endFan = 0;  ///< the same one for a corner
};
AxisFeature axisFeature(const ClearanceField& field, std::uint32_t feature);

/// Places in the plan, two at most, that are as far from three features, by closed formulas in doubles. Returns how
/// many; none where the equations say nothing.
int equallyFar(const std::array<AxisFeature, 3>& features, std::array<FieldVector, 2>& places);

}  // namespace footfall::detail
