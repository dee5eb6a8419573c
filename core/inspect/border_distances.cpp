// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/border_distances.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace footfall::detail {
namespace {

WalkableState withLevels(const WalkableState& state) {
  WalkableState result = state;
  result.kernel = kernelForKinds(state);
  return result;
}

PlanVector nearestOn(const PlanVector& a, const PlanVector& b, const PlanVector& p) {
  const PlanVector d = b - a;
  const double square = dot(d, d);
  return square > 0 ? a + std::clamp(dot(p - a, d) / square, 0.0, 1.0) * d : a;
}

}  // namespace

BorderDistances::BorderDistances(const WalkableState& state, RunContext& context)
    : state_(withLevels(state)), surface_(state_, context) {}

BorderDistances::Nearest BorderDistances::at(Index triangle, double x, double y, RunContext& context) const {
  const int scale = state_.kernel->mesh().grid.scaleExponent();
  const PlanVector place{std::ldexp(x, scale), std::ldexp(y, scale)};
  struct Near {
    double distance;
    Index side;
  };
  std::vector<Near> sides;
  for (Index side = 0; side < surface_.sideCount(); ++side)
    if (surface_.isBorder(side))
      sides.push_back({length(nearestOn(surface_.begin(side), surface_.end(side), place) - place), side});
  std::sort(sides.begin(), sides.end(), [](const Near& a, const Near& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.side < b.side;
  });
  BorderDivider divider(state_, surface_, false);
  std::optional<double> walls, ledges;  // scaled
  std::vector<BorderPiece> pieces;
  for (const auto& [distance, side] : sides) {
    context.checkCancelled();
    if (walls && ledges && distance >= std::max(*walls, *ledges)) break;
    if (!leadsTo(triangle, place, side / 3, nearestOn(surface_.begin(side), surface_.end(side), place))) continue;
    pieces.clear();
    divider.divide(side, pieces);
    for (const BorderPiece& piece : pieces) {
      const PlanVector nearest = nearestOn(piece.begin, piece.end, place);
      std::optional<double>& least = piece.isLedge ? ledges : walls;
      const double length = detail::length(nearest - place);
      if ((!least || length < *least) && leadsTo(triangle, place, side / 3, nearest)) least = length;
    }
  }
  const auto unscaled = [&](const std::optional<double>& d) {
    return d ? std::optional(std::ldexp(*d, -scale)) : std::nullopt;
  };
  return {unscaled(walls), unscaled(ledges)};
}

bool BorderDistances::leadsTo(Index triangle, const PlanVector& from, Index goal, const PlanVector& to) const {
  const PlanVector way = to - from;
  const double touch = MarginSurface::kSlack * (length(way) + MarginSurface::kSlack);
  std::vector<Index> stack{triangle};
  std::unordered_set<Index> seen{triangle};
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    if (t == goal) return true;
    for (Index side = 3 * t; side < 3 * t + 3; ++side) {
      const PlanVector a = surface_.begin(side), b = surface_.end(side);
      if (cross(way, a - from) > touch || cross(way, b - from) < -touch) continue;  // the way leaves elsewhere
      if (cross(b - a, to - a) > MarginSurface::kSlack * length(b - a)) continue;   // or ends before
      for (const Index other : surface_.beyond(side))
        if (seen.insert(other / 3).second) stack.push_back(other / 3);
    }
  }
  return false;
}

}  // namespace footfall::detail
