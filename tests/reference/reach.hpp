// Finds what can be reached from a seed, straight from the definition (docs/explanation/model.md, Reachable places):
// slow, obvious, exact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tests/reference/walkable_area.hpp"

namespace footfall::reference {

/// A convex piece of a floor.
struct FloorPiece {
  Polygon outline;
  Linear plane;
};

/// The pieces, outlines included, at the highest place at or under the seed, when that is at most `height` lower (no
/// limit where empty). None: the seed has no floor.
std::vector<std::size_t> piecesMeant(const std::vector<FloorPiece>& pieces, const Point3& seed,
                                     const std::optional<Rational>& height);

/// The parts (numbers of `partOf`, one for each piece) that seeds mean, ascending; nothing where one has no floor.
std::optional<std::vector<std::size_t>> partsReached(const std::vector<FloorPiece>& pieces,
                                                     const std::vector<std::size_t>& partOf,
                                                     const std::vector<Point3>& seeds,
                                                     const std::optional<Rational>& height);

/// The cells of an area, numbered through all regions.
std::vector<FloorPiece> piecesOf(const WalkableArea& area);

/// The number of the part of each of `count` pieces, if an agent can cross between those of each pair.
std::vector<std::size_t> partsOf(std::size_t count, const std::vector<std::array<std::size_t, 2>>& crossings);

}  // namespace footfall::reference
