// A place for a body near one that is too near to the border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/mesh/clearance_field.hpp"
#include "core/navigation/body_search.hpp"
#include "core/navigation/corridor_network.hpp"

namespace footfall::detail {

/// A place on a face, what is nearest to it, and where a search begins from it.
struct Standing {
  std::uint32_t face = 0;
  ClearanceField::Nearest nearest;
  FieldVector place;
  BodyEnd end;
};

/// A place whose distance to the border is `radius`. Where going straight away from the border leads to one, no place
/// is nearer, as the distance grows by no more than what one goes. Else it is the first one along the corridor map.
/// Nothing where there is none.
std::optional<Vec3> admissiblePlace(const CorridorNetwork& network, const Standing& standing, double radius);

}  // namespace footfall::detail
