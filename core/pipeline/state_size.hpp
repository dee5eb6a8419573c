// The memory that cached states hold, so that a cache can be kept within bounds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A part of a state, by its address. States share most of what they are made of.
struct StatePart {
  const void* address = nullptr;
  std::size_t bytes = 0;
};

/// Adds the parts of a state. Their bytes are estimated from the lengths of lists. What the state's environment takes
/// itself does not count.
void addParts(const WalkableState& state, std::vector<StatePart>& parts);
std::size_t sizeOf(const NavigationMesh& mesh);

}  // namespace footfall::detail
