// A few triangles that stand for those of a block, for a picture of an environment of any size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.hpp"

namespace footfall::detail {

/// Corners of a triangle, in the coordinates of the block that it stands for.
using CoarseFace = std::array<Vec3, 3>;

/// For one block.
inline constexpr std::uint64_t kMostCoarseFaces = 512;

/// How many triangles stand for each block, of so many: fewer where there are more, so that all of them stay a few.
std::size_t coarseFacesOf(std::uint64_t blocks);

/// At most `most` triangles for those of a block: its largest ones, where they are a good part of its area (buildings
/// with their furniture); else all of them with their vertices moved together, cell by cell of a grid (Rossignac and
/// Borrel 1993), as fine as `most` allows. For the eye alone; the same block gives the same triangles.
std::vector<CoarseFace> coarseFaces(std::span<const Vec3> places, std::span<const std::array<std::uint16_t, 3>> corners,
                                    std::size_t most);

}  // namespace footfall::detail
