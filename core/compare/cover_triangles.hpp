// Areas between borders as triangles, to be drawn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/compare/comparison_cover.hpp"

namespace footfall::detail::comparison {

struct CoverTriangle {
  std::array<CoverCorner, 3> corners;  ///< counter-clockwise
  std::uint32_t region = 0;            ///< triangles of one region hang together; from 0
};

/// The area of one part whose complete border these pieces are: cut into trapezoids by vertical lines through the ends
/// of pieces (a sweep from left to right), and those into triangles. Which piece bounds which trapezoid follows from
/// the pieces; corners on other pieces are rounded. `poll` may throw.
std::vector<CoverTriangle> triangulatePart(const std::vector<CoverPiece>& borders, Poll poll);

}  // namespace footfall::detail::comparison
