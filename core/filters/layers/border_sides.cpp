// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/border_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace footfall::detail {
namespace {

using Bounds = BorderSides::Tree::Bounds;

constexpr std::size_t kMostPieces = 64, kPieces = std::size_t{1} << 20;

Bounds boundsOf(const std::array<double, 2>& a, const std::array<double, 2>& b, double error) {
  Bounds bounds;
  for (std::size_t k = 0; k < 2; ++k) {
    bounds.lower[k] = std::min(a[k], b[k]) - error;
    bounds.upper[k] = std::max(a[k], b[k]) + error;
  }
  return bounds;
}

Bounds boundsOf(const BorderSides::Side& side) { return boundsOf(side.begin, side.end, side.error); }

double areaOf(const Bounds& bounds) {
  return (bounds.upper[0] - bounds.lower[0]) * (bounds.upper[1] - bounds.lower[1]);
}

/// The area of the plan for each side.
double shareOf(const std::vector<BorderSides::Side>& sides) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds all{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const BorderSides::Side& side : sides) {
    const Bounds own = boundsOf(side);
    for (std::size_t k = 0; k < 2; ++k) {
      if (std::isfinite(own.lower[k])) all.lower[k] = std::min(all.lower[k], own.lower[k]);
      if (std::isfinite(own.upper[k])) all.upper[k] = std::max(all.upper[k], own.upper[k]);
    }
  }
  return areaOf(all) / static_cast<double>(sides.size());
}

/// The number of pieces of a side of which each has a box about as large as the share of a side.
std::size_t piecesOf(const BorderSides::Side& side, double share) {
  const double pieces = std::sqrt(areaOf(boundsOf(side)) / share);
  if (!(pieces >= 1)) return 1;
  return pieces < kMostPieces ? static_cast<std::size_t>(pieces) : kMostPieces;
}

/// A piece of a side. Each place is off by a few units in the last place of its own coordinates at most.
Bounds boundsOfPiece(const BorderSides::Side& side, std::size_t number, std::size_t count) {
  if (count == 1) return boundsOf(side);
  double size = 0;
  for (std::size_t k = 0; k < 2; ++k) size = std::max({size, std::fabs(side.begin[k]), std::fabs(side.end[k])});
  const auto at = [&](std::size_t i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    return std::array<double, 2>{side.begin[0] + (side.end[0] - side.begin[0]) * share,
                                 side.begin[1] + (side.end[1] - side.begin[1]) * share};
  };
  return boundsOf(at(number), at(number + 1), side.error + size * 0x1p-48);
}

}  // namespace

void BorderSides::build(const std::vector<Side>& sides, Poll poll) {
  triangleOf_.clear();
  extent_ = 0;
  const double share = sides.empty() ? 0 : shareOf(sides);
  std::size_t most = 2 * kMostPieces, count = 0;
  do {
    most /= 2;
    count = 0;
    for (const Side& side : sides) count += std::min(piecesOf(side, share), most);
  } while (most > 1 && count > kPieces + 4 * sides.size());
  std::vector<Bounds> pieces;
  pieces.reserve(count);
  for (const Side& side : sides) {
    poll();
    const std::size_t own = std::min(piecesOf(side, share), most);
    for (std::size_t i = 0; i < own; ++i) {
      triangleOf_.push_back(side.triangle);
      pieces.push_back(boundsOfPiece(side, i, own));
    }
  }
  std::vector<Index> all(pieces.size());
  std::iota(all.begin(), all.end(), Index{0});
  tree_.build(
      all, [&](Index piece) { return pieces[static_cast<std::size_t>(piece)]; }, poll);
  for (const Bounds& piece : pieces)
    for (std::size_t k = 0; k < 2; ++k)
      for (const double end : {piece.lower[k], piece.upper[k]})
        if (std::isfinite(end)) extent_ = std::max(extent_, std::fabs(end - tree_.centre()[k]));
}

// Corners relative to the tree's centre, and boxes, are r in size at most. A corner is off by the error e and by 2^-53
// r from the difference, a coordinate of a box by 2^-23 r from the conversion to float. A component of u, the direction
// of a side, is 2 r in size at most and off by 2 e + 2^-51 r, and 2^-24 of itself from the conversion. Its product with
// a distance of 2 r at most is then off by 4 e r + 2^-50 r^2 + |u| (2^-22 r + e), and the roundings of three products
// and two sums of floats take less than |u| 2^-21 r more. The bound is at least twice the sum over both components.
// Products neither overflow nor lose anything that matters while r is between 2^-30 and 2^60. A box that is infinite,
// cut off at the largest float, has its corner on the left of each line.
BorderSides::Outside::Outside(const PlanTriangle& t, const std::array<double, 2>& centre, double extent) {
  std::array<double, 3> x{}, y{};
  double r = extent;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = t.x[k] - centre[0];
    y[k] = t.y[k] - centre[1];
    r = std::max({r, std::fabs(x[k]), std::fabs(y[k])});
  }
  if (!(r > 0x1p-30 && r < 0x1p60 && t.error < r)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    const double ux = x[n] - x[k], uy = y[n] - y[k];
    const double bound =
        (std::fabs(ux) + std::fabs(uy)) * (0x1p-19 * r + 2 * t.error) + 16 * t.error * r + 0x1p-47 * r * r;
    lines_[k] = {static_cast<float>(ux), static_cast<float>(uy), static_cast<float>(ux * y[k] - uy * x[k]),
                 static_cast<float>(bound)};
  }
}

}  // namespace footfall::detail
