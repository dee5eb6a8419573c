// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/margin_surface.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "core/base/parallel.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kVerticesPerTask = 4096;
constexpr std::size_t kPolled = 4095;  // bits that are 0 whenever a poll is due

}  // namespace

double turnFrom(const PlanVector& base, const PlanVector& direction) {
  const double x = dot(base, direction), y = cross(base, direction);
  const double size = std::fabs(x) + std::fabs(y);
  if (size == 0) return 0;
  const double part = y / size;
  return x >= 0 ? part : y >= 0 ? 2 - part : -2 - part;
}

MarginSurface::MarginSurface(const WalkableState& state, RunContext& context)
    : mesh_(*state.mesh),
      corners_(mesh_.triangles),
      poll_(context),
      places_(mesh_.vertices.size()),
      errors_(mesh_.vertices.size()),
      first_(mesh_.triangles.size() * 3 + 1) {
  const int scale = state.kernel->mesh().grid.scaleExponent();
  parallelRanges(places_.size(), kVerticesPerTask, [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      const MeshVertex& vertex = mesh_.vertices[v];
      places_[v] = {vertex.x, vertex.y};
      errors_[v] = vertex.error;
      if (vertex.error < 2 * kUnit) continue;
      const Vec3 place = state.kernel->roundedPosition(vertex.point, vertex.face);
      places_[v] = {std::ldexp(place.x, scale), std::ldexp(place.y, scale)};
      errors_[v] = kUnit;
    }
  });

  const auto topology = topologyOf(state, context);
  std::vector<std::array<Index, 2>> pairs;
  for (Index e = 0; e < topology->edgeCount(); ++e) {
    const auto sides = topology->sidesOf(e);
    if (sides.size() < 2 || isObstacle(mesh_.triangles, sides)) continue;
    for (const Index a : sides)
      for (const Index b : sides)
        if (beginVertex(a) == endVertex(b)) pairs.push_back({a, b});
  }
  for (const MeshLink& link : mesh_.links) {
    const Index a = findSide(mesh_.triangles, *topology, link.from[0], link.from[1]);
    const Index b = findSide(mesh_.triangles, *topology, link.to[0], link.to[1]);
    if (a < 0 || b < 0) throw std::logic_error("a link without its triangles");
    pairs.push_back({a, b});
    pairs.push_back({b, a});
  }
  std::sort(pairs.begin(), pairs.end());
  beyond_.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    ++first_[a + 1];
    beyond_.push_back(b);
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

bool MarginSurface::fanBehind(Index border, std::vector<Index>& fan) const {
  fan.clear();
  // The first of several links or bridges leads on: the borders behind the others are reached at their ends only.
  const auto hasOneWay = [&](Index side) {
    int ways = 0;
    for (const Index other : beyond(side))
      ways += static_cast<int>(beginVertex(other) == endVertex(side) && face(other) >= 0);
    return ways <= 1;
  };
  Index mark = -1;
  for (Index side = nextSide(border);; side = nextSide(beyond(side)[0])) {
    fan.push_back(side);
    if ((fan.size() & kPolled) == 0) poll_();
    if (isBorder(side)) return false;
    if (side == mark || !hasOneWay(side) || !hasOneWay(beyond(side)[0])) break;
    if (std::has_single_bit(fan.size())) mark = side;  // what leads round in a circle comes to one of them again
  }
  addAllWays(fan);
  return true;
}

// Starts from the last side of the fan.
void MarginSurface::addAllWays(std::vector<Index>& fan) const {
  std::unordered_set<Index> seen(fan.begin(), fan.end());
  for (std::size_t i = fan.size() - 1; i < fan.size(); ++i) {
    if ((i & kPolled) == 0) poll_();
    for (const Index other : beyond(fan[i]))
      if (const Index side = nextSide(other); seen.insert(side).second) fan.push_back(side);
  }
}

}  // namespace footfall::detail
