// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/corridor_network.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/mesh/gap_bridges.hpp"
#include "core/navigation/field_walk.hpp"

namespace footfall::detail {
namespace {

/// Halvings of a piece of a ray: what is left is below a unit in the last place.
constexpr int kHalvings = 60;

double distanceOf(const FieldFeature& feature, FieldVector p) { return lengthOf(feature.nearestTo(p) - p); }

/// A direction along which places of a piece of axis are in their order: that of the edge where it is a parabola.
FieldVector directionOf(const FieldFeature& left, const FieldFeature& right, FieldVector from, FieldVector to) {
  const FieldVector way = to - from;
  if (left.isCorner() != right.isCorner()) {
    const FieldVector along = (left.isCorner() ? right : left).along;
    if (dot(along, way) != 0) return along * (dot(along, way) > 0 ? 1 : -1);
  }
  const double length = lengthOf(way);
  return length > 0 ? way * (1 / length) : FieldVector{1, 0};
}

/// Puts chains that follow each other next to each other, in one direction: searches go along them, and memory is read
/// in its order.
std::vector<CorridorChain> inOrder(std::vector<CorridorChain> chains, std::size_t nodeCount) {
  std::vector<std::vector<std::uint32_t>> at(nodeCount);
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    at[chains[c].from].push_back(c);
    at[chains[c].to].push_back(c);
  }
  std::vector<char> isDone(chains.size(), 0);
  std::vector<CorridorChain> ordered;
  ordered.reserve(chains.size());
  const auto follow = [&](std::uint32_t node, std::uint32_t c) {
    while (isDone[c] == 0) {
      isDone[c] = 1;
      CorridorChain& chain = chains[c];
      if (chain.from != node) {
        std::swap(chain.from, chain.to);
        std::swap(chain.left, chain.right);
      }
      node = chain.to;
      ordered.push_back(std::move(chain));
      if (at[node].size() != 2) return;
      c = at[node][0] == c ? at[node][1] : at[node][0];
    }
  };
  for (const bool isRing : {false, true})  // rings have no vertex at which to begin
    for (std::uint32_t node = 0; node < nodeCount; ++node)
      for (std::size_t i = 0; i < at[node].size(); ++i)
        if (isRing || at[node].size() != 2) follow(node, at[node][i]);
  return ordered;
}

}  // namespace

CorridorNetwork::CorridorNetwork(const NavigationMesh& mesh, Poll poll)
    : mesh_(mesh), bridged_(withBridges(mesh)), field_(mesh, {}, poll) {
  const CorridorAxis axis = makeCorridorAxis(field_, poll);
  const CorridorGraph graph = makeCorridorGraph(field_, axis, true, poll);
  std::vector<std::uint32_t> numbers(axis.nodes.size(), CorridorFoot::kNone);
  const auto numberOf = [&](std::uint32_t node) {
    if (numbers[node] == CorridorFoot::kNone) {
      numbers[node] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(axis.nodes[node]);
    }
    return numbers[node];
  };
  waysIn_.resize(field_.surface().faces.size());
  for (const CorridorChain& chain : inOrder(graph.chains, axis.nodes.size())) {
    const std::uint32_t from = numberOf(chain.from), to = numberOf(chain.to);
    addWay(chain, from, to);
  }
  waysAt_.resize(vertices_.size());
  for (std::uint32_t w = 0; w < ways_.size(); ++w) {
    waysAt_[ways_[w].from].push_back(w);
    if (ways_[w].to != ways_[w].from) waysAt_[ways_[w].to].push_back(w);
  }
  numberEnds();
  poll();
  findInward();
  listExits();
  findWidest();
}

void CorridorNetwork::addWay(const CorridorChain& chain, std::uint32_t from, std::uint32_t to) {
  CorridorWay way;
  way.from = from;
  way.to = to;
  way.features = {chain.left, chain.right};
  way.faces = chain.faces;
  const FieldFeature &left = field_.features()[chain.left], &right = field_.features()[chain.right];
  const FieldVector begin = vertices_[from].place, end = vertices_[to].place;
  way.direction = directionOf(left, right, begin, end);
  way.begin = way.along(begin);
  way.end = way.along(end);
  way.narrow = narrowPlaceOf(left, right, begin, end);
  way.least = std::min(vertices_[from].distance, vertices_[to].distance);
  if (way.narrow) {
    way.narrowDistance = std::min(distanceOf(left, *way.narrow), distanceOf(right, *way.narrow));
    way.least = std::min(way.least, way.narrowDistance);
  }
  addGates(way);
  const auto number = static_cast<std::uint32_t>(ways_.size());
  for (const std::uint32_t face : way.faces)
    if (waysIn_[face].empty() || waysIn_[face].back() != number) waysIn_[face].push_back(number);
  ways_.push_back(std::move(way));
}

void CorridorNetwork::addGates(CorridorWay& way) {
  const FieldVector from = vertices_[way.from].place, to = vertices_[way.to].place;
  std::vector<FieldVector> places{from};
  const FieldFeature *corner = &field_.features()[way.features[0]], *other = &field_.features()[way.features[1]];
  if (!corner->isCorner()) std::swap(corner, other);
  if (corner->isCorner()) {
    const FieldVector first = from - corner->place, last = to - corner->place;
    const double turn = std::atan2(cross(first, last), dot(first, last)), length = lengthOf(first);
    const int pieces = static_cast<int>(std::ceil(std::fabs(turn) / kTurn));
    for (int i = 1; i < pieces; ++i) {
      const double angle = turn * i / pieces;
      const FieldVector ahead = (first * std::cos(angle) + leftOf(first) * std::sin(angle)) * (1 / length);
      // The place is as far from the corner as from the other feature.
      const FieldVector across = other->place - corner->place;
      const double distance = other->isCorner() ? dot(across, across) / (2 * dot(ahead, across))
                                                : -dot(across, other->inward) / (1 - dot(ahead, other->inward));
      if (distance > 0 && std::isfinite(distance)) places.push_back(corner->place + ahead * distance);
    }
  }
  places.push_back(to);
  way.firstGate = gates_.size();
  way.gateCount = places.size();
  for (const FieldVector& place : places) {
    CorridorGate gate;
    gate.place = place;
    gate.distance = std::numeric_limits<double>::infinity();
    for (const int side : {0, 1}) {
      const FieldFeature& feature = field_.features()[way.features[side]];
      gate.border[side] = feature.nearestTo(gate.place);
      const FieldVector free = gate.place - gate.border[side];
      const double distance = lengthOf(free);
      if (distance > 0) gate.away[side] = feature.isCorner() ? free * (1 / distance) : feature.inward;
      gate.distance = std::min(gate.distance, distance);
    }
    gates_.push_back(gate);
  }
}

void CorridorNetwork::numberEnds() {
  std::uint32_t next = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> known;  // features at a vertex, and a gate's number and side
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    known.clear();
    // Corners first: an edge whose nearest place is its own corner has the corner's end.
    for (const bool isCorner : {true, false})
      for (const std::uint32_t w : waysAt_[v])
        for (const std::size_t at : {ways_[w].firstGate, ways_[w].firstGate + ways_[w].gateCount - 1}) {
          if ((at == ways_[w].firstGate ? ways_[w].from : ways_[w].to) != v) continue;
          for (const int side : {0, 1})
            if (field_.features()[ways_[w].features[side]].isCorner() == isCorner)
              shareEnd(ways_[w].features[side], at, side, known, next);
        }
  }
  for (const CorridorWay& way : ways_)
    for (std::size_t i = 1; i + 1 < way.gateCount; ++i) gates_[way.firstGate + i].ends = {next++, next++};
}

void CorridorNetwork::shareEnd(std::uint32_t feature, std::size_t gate, int side,
                               std::vector<std::pair<std::uint32_t, std::uint32_t>>& known, std::uint32_t& next) {
  for (const auto& [other, place] : known) {
    if (other != feature && pairOf(field_, other, feature) != AxisPair::Joined) continue;
    const CorridorGate& same = gates_[place >> 1];
    const int otherSide = static_cast<int>(place & 1);
    gates_[gate].border[side] = same.border[otherSide];
    gates_[gate].away[side] = same.away[otherSide];
    gates_[gate].ends[side] = same.ends[otherSide];
    return;
  }
  gates_[gate].ends[side] = next++;
  known.emplace_back(feature, static_cast<std::uint32_t>(gate << 1) | static_cast<std::uint32_t>(side));
}

void CorridorNetwork::findInward() {
  inward_.assign(vertices_.size(), CorridorFoot::kNone);
  std::vector<std::size_t> degrees(vertices_.size());
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    for (const std::uint32_t w : waysAt_[v]) degrees[v] += ways_[w].from == ways_[w].to ? 2 : 1;
    if (degrees[v] == 1) leaves.push_back(v);
  }
  std::vector<char> isOut(ways_.size(), 0);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const std::uint32_t v = leaves[i];
    for (const std::uint32_t w : waysAt_[v]) {
      if (isOut[w] != 0) continue;
      isOut[w] = 1;
      inward_[v] = w;
      if (--degrees[otherEnd(w, v)] == 1) leaves.push_back(otherEnd(w, v));
    }
  }
}

CorridorExit CorridorNetwork::exitAlong(std::uint32_t number, bool isForward) const {
  const CorridorWay& way = ways_[number];
  const std::uint32_t next = isForward ? way.to : way.from;
  return {way.least,
          number,
          next,
          static_cast<std::uint32_t>(way.firstGate),
          static_cast<std::uint32_t>(way.gateCount),
          isForward,
          inward_[next] == number};
}

void CorridorNetwork::listExits() {
  firstExit_.reserve(vertices_.size() + 1);
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    firstExit_.push_back(exits_.size());
    for (const std::uint32_t w : waysAt_[v]) exits_.push_back(exitAlong(w, ways_[w].from == v));
  }
  firstExit_.push_back(exits_.size());
}

void CorridorNetwork::findWidest() {
  widestFirst_.resize(ways_.size());
  std::iota(widestFirst_.begin(), widestFirst_.end(), 0U);
  std::ranges::stable_sort(widestFirst_, std::greater<>(), [this](std::uint32_t w) { return ways_[w].least; });
  joinedTo_.resize(vertices_.size());
  std::iota(joinedTo_.begin(), joinedTo_.end(), 0U);
  joinedBy_.assign(vertices_.size(), CorridorFoot::kNone);
  std::vector<std::uint32_t> sizes(vertices_.size(), 1);
  const auto rootOf = [this](std::uint32_t v) {
    while (joinedTo_[v] != v) v = joinedTo_[v];
    return v;
  };
  for (std::uint32_t i = 0; i < widestFirst_.size(); ++i) {
    std::uint32_t a = rootOf(ways_[widestFirst_[i]].from), b = rootOf(ways_[widestFirst_[i]].to);
    if (a == b) continue;
    if (sizes[a] > sizes[b]) std::swap(a, b);
    joinedTo_[a] = b;
    joinedBy_[a] = i;
    sizes[b] += sizes[a];
  }
}

std::optional<std::uint32_t> CorridorNetwork::widestRoute(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t last = CorridorFoot::kNone;
  while (a != b) {
    // Numbers rise towards the root, whose own one is the highest.
    std::uint32_t& first = joinedBy_[a] < joinedBy_[b] ? a : b;
    if (joinedBy_[first] == CorridorFoot::kNone) return std::nullopt;
    last = joinedBy_[first];
    first = joinedTo_[first];
  }
  return last == CorridorFoot::kNone ? last : widestFirst_[last];
}

std::optional<CorridorFoot> CorridorNetwork::footOf(std::uint32_t face, FieldVector p) const {
  const ClearanceField::Nearest nearest = field_.at(face, p);
  if (nearest.feature == FieldEdge::kNone || !(nearest.distance > 0)) return std::nullopt;
  const FieldSurface& surface = field_.surface();
  const FieldVector away = (p - nearest.border) * (1 / nearest.distance);
  const double slack = 4 * field_.margin();
  const auto isOwn = [&](std::uint32_t f, FieldVector q) {
    return field_.at(f, q).distance >= lengthOf(q - nearest.border) - slack;
  };
  FieldWalk walk(surface, face, p, p + away * (4 * surface.scale));
  FieldVector inside = p;
  for (std::size_t steps = 0; steps <= 4 * surface.faces.size(); ++steps) {
    const auto exit = walk.exit();
    if (!exit) return std::nullopt;
    if (isOwn(walk.face(), exit->place)) {
      inside = exit->place;
      if (!walk.leave(*exit)) return std::nullopt;
      continue;
    }
    FieldVector beyond = exit->place;
    for (int i = 0; i < kHalvings; ++i) {
      const FieldVector middle = (inside + beyond) * 0.5;
      (isOwn(walk.face(), middle) ? inside : beyond) = middle;
    }
    return wayNear(walk.face(), inside, nearest.feature);
  }
  return std::nullopt;
}

std::optional<CorridorFoot> CorridorNetwork::wayNear(std::uint32_t face, FieldVector p, std::uint32_t feature) const {
  // A second feature is as near as `feature` where the ray from the border meets the axis. Further along the ray, up
  // to here, `feature` recedes the fastest of all, and by 4 margins more than the nearest at most (footOf()); so the
  // second one is as near as that, too. Distances of the field are off by a margin: both features of a way here are
  // within 8. Ends of ways are off by `astray` at most (core/include/footfall/corridor_map.hpp). Between two
  // borders that are one line but for a hair there is no way: then one along another border is here.
  const double distance = field_.at(face, p).distance, nearest = distance + 8 * field_.margin();
  const double astray = 0x1p-36 * field_.surface().scale;
  CorridorFoot best{CorridorFoot::kNone, p, distance};
  // Smaller is better: ways that are not here come later, then those along other borders, which begin where the way of
  // the feature ends; then the one whose piece of the axis is nearest; then the first one.
  std::tuple<bool, bool, double, std::uint32_t> least;
  const auto consider = [&](std::uint32_t f) {
    for (const std::uint32_t w : waysIn_[f]) {
      const CorridorWay& way = ways_[w];
      const double at = way.along(p);
      double beside = std::max({0.0, way.begin - at, at - way.end});
      bool isHere = beside <= astray;
      for (const std::uint32_t other : way.features) {
        const double excess = std::max(0.0, distanceOf(field_.features()[other], p) - nearest);
        isHere = isHere && excess == 0;
        beside += excess;
      }
      const bool isOwn = isHere && std::ranges::find(way.features, feature) != way.features.end();
      const std::tuple order(!isHere, !isOwn, beside, w);
      if (best.way != CorridorFoot::kNone && least <= order) continue;
      least = order;
      best.way = w;
    }
  };
  // Roundings may put a place of the axis on the other side of a side.
  consider(face);
  for (const std::uint32_t other : field_.surface().topology.neighbours[face])
    if (other != SurfaceTopology::kNone) consider(other);
  if (best.way == CorridorFoot::kNone) return std::nullopt;
  return best;
}

CorridorNeck CorridorNetwork::neckBetween(std::uint32_t number, const CorridorFoot& a, const CorridorFoot& b) const {
  const CorridorWay& way = ways_[number];
  const CorridorFoot& narrower = a.distance <= b.distance ? a : b;
  CorridorNeck neck{number, narrower.place, narrower.distance};
  if (!way.narrow || way.narrowDistance >= neck.distance) return neck;
  const double first = std::min(way.along(a.place), way.along(b.place));
  const double last = std::max(way.along(a.place), way.along(b.place)), at = way.along(*way.narrow);
  return at > first && at < last ? CorridorNeck{number, *way.narrow, way.narrowDistance} : neck;
}

}  // namespace footfall::detail
