// The fewest connections that any subdivision of a small mesh into layers can have, by trying.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "tests/reference/comparison.hpp"

namespace footfall::reference {

/// Pairs of pieces that overlap in the plan with an area.
std::vector<std::array<std::size_t, 2>> findOverlaps(const std::vector<Piece>& pieces);

/// The number of shared edges (no obstacle edges) between pieces of different layers.
std::size_t countConnections(const std::vector<Piece>& pieces);

/// The smallest number of shared edges to cut so that no two pieces that still hang together overlap in the plan: with
/// as many layers as one likes, the fewest connections. Search by depth: some edge on every path between two pieces
/// that overlap must go. Empty when it is more than `most` or when the search takes too long.
std::optional<std::size_t> fewestConnections(const std::vector<Piece>& pieces, std::size_t most);

}  // namespace footfall::reference
