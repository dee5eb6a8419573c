// Counts the vertices that rounding keeps apart from others that they should meet.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

struct NearPlaces {
  std::uint64_t count = 0;  ///< places of corners beyond the first at one place of the grid, about
  std::uint64_t all = 0;    ///< places of corners, about
  double step = 0;          ///< of the usual grid, on which they are one place; 0: there is none, or it is in use
};

/// Counts places of vertices that become one with another on the usual grid. The count is a little too small, and from
/// about 2^16 places on it is an estimate by a part of the squares of the grid.
NearPlaces countNearPlaces(const Environment& environment, Poll poll);

}  // namespace footfall::detail
