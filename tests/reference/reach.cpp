// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/reach.hpp"

#include <set>

namespace footfall::reference {

std::vector<std::size_t> piecesMeant(const std::vector<FloorPiece>& pieces, const Point3& seed,
                                     const std::optional<Rational>& height) {
  const Point2 place = planOf(seed);
  std::vector<std::size_t> meant;
  Rational highest;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Polygon& outline = pieces[i].outline;
    bool isInside = !outline.empty();
    for (std::size_t k = 0; k < outline.size(); ++k)
      isInside = isInside && turn(outline[k], outline[(k + 1) % outline.size()], place) >= 0;
    if (!isInside) continue;
    const Rational z = pieces[i].plane.at(place);
    if (z > seed.z || (!meant.empty() && z < highest)) continue;
    if (meant.empty() || z > highest) meant.clear();
    highest = z;
    meant.push_back(i);
  }
  if (!meant.empty() && height && seed.z - highest > *height) meant.clear();
  return meant;
}

std::optional<std::vector<std::size_t>> partsReached(const std::vector<FloorPiece>& pieces,
                                                     const std::vector<std::size_t>& partOf,
                                                     const std::vector<Point3>& seeds,
                                                     const std::optional<Rational>& height) {
  std::set<std::size_t> reached;
  for (const Point3& seed : seeds) {
    const std::vector<std::size_t> meant = piecesMeant(pieces, seed, height);
    if (meant.empty()) return std::nullopt;
    for (const std::size_t piece : meant) reached.insert(partOf[piece]);
  }
  return std::vector<std::size_t>(reached.begin(), reached.end());
}

std::vector<FloorPiece> piecesOf(const WalkableArea& area) {
  std::vector<FloorPiece> pieces;
  for (const Region& region : area.regions)
    for (const Polygon& cell : region.cells) pieces.push_back({cell, region.plane});
  return pieces;
}

std::vector<std::size_t> partsOf(std::size_t count, const std::vector<std::array<std::size_t, 2>>& crossings) {
  std::vector<std::size_t> part(count);
  for (std::size_t i = 0; i < count; ++i) part[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : crossings) {
      const std::size_t least = std::min(part[a], part[b]);
      changed = changed || part[a] != part[b];
      part[a] = part[b] = least;
    }
  }
  return part;
}

}  // namespace footfall::reference
