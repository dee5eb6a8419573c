// The memory that cached states hold, so that a cache can be kept within bounds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <unordered_set>

#include "core/assembly/walkable_state.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// The parts of states that were counted already: states share most of what they are made of.
using CountedParts = std::unordered_set<const void*>;

/// Bytes, estimated from the lengths of the large lists in constant time; parts in `counted` are left out, and those
/// that are counted now are added to it. What the state's environment takes itself does not count.
std::size_t sizeOf(const WalkableState& state, CountedParts& counted);
std::size_t sizeOf(const NavigationMesh& mesh);

}  // namespace footfall::detail
