// Holding the product of the filters against the reference, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/reference/exact_view.hpp"
#include "tests/reference/walkable_area.hpp"

namespace footfall::reference {
using namespace detail;

/// A triangle of the product in rationals.
struct Piece {
  std::array<Point3, 3> corners;
  Polygon plan;
  std::uint32_t source = 0;
  std::array<bool, 3> obstacleEdge{};
  int layer = -1;
};

std::vector<Piece> toPieces(const std::vector<ExactTriangle>& triangles);

/// A triangle and its edge: from corner `edge` to the next.
struct EdgeUse {
  std::size_t piece = 0;
  std::size_t edge = 0;
};
/// Edges by their exact ends, smaller end first.
using EdgeMap = std::map<std::array<Point3, 2>, std::vector<EdgeUse>>;
EdgeMap findEdges(const std::vector<Piece>& pieces);

/// The number of each piece's connected part over whole shared edges that are not obstacle edges.
std::vector<std::size_t> connectedParts(const std::vector<Piece>& pieces);

/// Describes the first disagreement; empty when the product is exactly the reference: the same set in every plane, no
/// duplicates, every piece inside its source triangle; whole edges shared wherever two pieces meet; edges between two
/// pieces are obstacle edges exactly where walls stand, and walls cut through no piece; the same connected parts.
std::string findDifference(const Environment& environment, const WalkableArea& area, const std::vector<Piece>& pieces);

/// Only: the same set in every plane, nothing twice. For states that need not be joined yet.
std::string findSetDifference(const Environment& environment, const WalkableArea& area,
                              const std::vector<Piece>& pieces);

/// Only: T-joints, an edge of more than two pieces, obstacle marks that differ on the two sides.
std::string findConformityError(const std::vector<Piece>& pieces);

/// The length in space of edges marked as obstacles with a piece on either side, rounded.
double obstacleLength(const std::vector<Piece>& pieces);
/// The same of the reference.
double blockedLength(const std::vector<Meeting>& meetings);

std::string toText(const Point3& p);
std::string toText(const Piece& piece);

}  // namespace footfall::reference
