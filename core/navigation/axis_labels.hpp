// Finds the nearest feature of the border along the edges of a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/clearance_field.hpp"

namespace footfall::detail {

/// Up to `end` along an edge, from where the one before it ends, this feature is nearest.
struct AxisLabel {
  std::uint32_t feature = 0;
  double end = 0;
};

/// The labels of an edge that is no border, in its direction; each feature differs from the one before it. Where two
/// features are equally near up to the field's margin, the previous one stays: an edge that lies on the axis has one
/// label.
std::vector<AxisLabel> labelsOf(const ClearanceField& field, std::uint32_t edge);

}  // namespace footfall::detail
