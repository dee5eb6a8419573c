// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/admissible_place.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/navigation/field_walk.hpp"

namespace footfall::detail {
namespace {

/// The place in space of somebody who went straight from a place on a face to another one.
Vec3 placeAfter(const CorridorNetwork& network, std::uint32_t face, FieldVector from, FieldVector to) {
  FieldWalk walk(network.field().surface(), face, from, to);
  for (std::size_t steps = 0; steps < 2 * network.field().surface().faces.size(); ++steps) {
    const auto exit = walk.exit();
    if (!exit || !walk.leave(*exit)) break;
  }
  return network.places().onFace(walk.face(), to);
}

/// The way that is nearest to a place on a border: one of those on its face.
CorridorFoot footNear(const CorridorNetwork& network, const Standing& standing) {
  if (standing.end.foot.way != CorridorFoot::kNone) return standing.end.foot;
  CorridorFoot best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t w : network.waysIn(standing.face))
    for (const std::uint32_t v : {network.ways()[w].from, network.ways()[w].to}) {
      const double length = lengthOf(network.vertices()[v].place - standing.place);
      if (length >= least) continue;
      least = length;
      best = network.footAt(w, v);
    }
  return best;
}

/// The first place along the map that is wide enough: a vertex.
std::optional<std::uint32_t> firstWideVertex(const CorridorNetwork& network, const CorridorFoot& foot, double radius) {
  std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
      queue;
  std::unordered_map<std::uint32_t, double> lengths;
  const auto reach = [&](std::uint32_t vertex, double length) {
    const auto known = lengths.try_emplace(vertex, length);
    if (!known.second && known.first->second <= length) return;
    known.first->second = length;
    queue.emplace(length, vertex);
  };
  for (const std::uint32_t v : {network.ways()[foot.way].from, network.ways()[foot.way].to})
    reach(v, lengthOf(network.vertices()[v].place - foot.place));
  while (!queue.empty()) {
    const auto [length, vertex] = queue.top();
    queue.pop();
    if (length > lengths[vertex]) continue;
    if (network.vertices()[vertex].distance >= radius) return vertex;
    for (const CorridorExit& exit : network.exitsAt(vertex))
      reach(exit.next, length + lengthOf(network.vertices()[exit.next].place - network.vertices()[vertex].place));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> admissiblePlace(const CorridorNetwork& network, const Standing& standing, double radius) {
  const CorridorFoot foot = footNear(network, standing);
  if (foot.way == CorridorFoot::kNone) return std::nullopt;
  if (foot.distance >= radius && standing.nearest.distance > 0) {
    const FieldVector away = (standing.place - standing.nearest.border) * (radius / standing.nearest.distance);
    return placeAfter(network, standing.face, standing.place, standing.nearest.border + away);
  }
  const auto vertex = firstWideVertex(network, foot, radius);
  if (!vertex) return std::nullopt;
  return network.places().onFace(network.vertices()[*vertex].face, network.vertices()[*vertex].place);
}

}  // namespace footfall::detail
