// A few triangles that stand for those of a block, for drawing an environment of any size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {

/// Corners of a triangle, in the coordinates of the block that it stands for.
using CoarseFace = std::array<Vec3, 3>;

/// The most coarse faces of one block.
inline constexpr std::uint64_t kMostCoarseFaces = 512;

/// The number of coarse faces for each of `blocks` blocks. It falls as blocks grow in number, so that their total stays
/// small.
std::size_t coarseFacesOf(std::uint64_t blocks);

/// At most `most` triangles that stand for the triangles of a block: its largest ones, where they have a good part of
/// its area (buildings with their furniture); otherwise all of them with their vertices merged on a grid (Rossignac and
/// Borrel 1993), as fine as `most` allows. They serve display only; the same block gives the same triangles.
std::vector<CoarseFace> coarseFaces(std::span<const Vec3> places, std::span<const std::array<std::uint16_t, 3>> corners,
                                    std::size_t most);

}  // namespace footfall::detail
