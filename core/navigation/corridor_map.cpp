// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/corridor_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "core/mesh/gap_bridges.hpp"
#include "core/navigation/corridor_graph.hpp"
#include "core/navigation/field_places.hpp"

namespace footfall {
using namespace detail;
namespace {

/// Puts heights to places of the plan and numbers to what is left of the axis.
class MapMaker {
 public:
  MapMaker(const NavigationMesh& mesh, Poll poll)
      : mesh_(mesh), bridged_(withBridges(mesh)), field_(mesh, {}, poll), axis_(makeCorridorAxis(field_, poll)) {}

  CorridorMap make(bool isFull, Poll poll) {
    const CorridorGraph graph = makeCorridorGraph(field_, axis_, isFull, poll);
    map_.isFull = isFull;
    map_.frame = mesh_.frame;
    numbers_.assign(axis_.nodes.size(), kNone);
    std::vector<std::uint32_t> nodes = graph.alone;
    for (const CorridorChain& chain : graph.chains) nodes.insert(nodes.end(), {chain.from, chain.to});
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<double> hidden;
    for (const std::uint32_t node : nodes) {
      numbers_[node] = static_cast<std::uint32_t>(map_.vertices.size());
      const AxisNode& n = axis_.nodes[node];
      map_.vertices.push_back({places_.onFace(n.face, n.place), 2 * n.distance, places_.underFace(n.face)});
      hidden.push_back(graph.hidden[node]);
    }
    for (const CorridorChain& chain : graph.chains) addEdge(chain);
    map_.bottlenecks = findBottlenecks(map_, hidden, poll);
    return std::move(map_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  void addEdge(const CorridorChain& chain) {
    const AxisNode &from = axis_.nodes[chain.from], &to = axis_.nodes[chain.to];
    const FieldFeature &left = field_.features()[chain.left], &right = field_.features()[chain.right];
    CorridorEdge edge;
    edge.from = numbers_[chain.from];
    edge.to = numbers_[chain.to];
    if (isParabola(left, right, pairOf(field_, chain.left, chain.right))) edge.shape = CorridorShape::Parabola;
    edge.left = {places_.onBorder(chain.left, from.place), places_.onBorder(chain.left, to.place)};
    edge.right = {places_.onBorder(chain.right, from.place), places_.onBorder(chain.right, to.place)};
    edge.length = chain.length;
    edge.area = chain.area;
    for (const std::uint32_t face : chain.faces)
      if (face < mesh_.triangles.size()) edge.triangles.push_back(face);
    const bool isFirst = from.distance <= to.distance;
    edge.narrowest = map_.vertices[isFirst ? edge.from : edge.to].place;
    edge.width = 2 * std::min(from.distance, to.distance);
    if (const auto place = narrowPlaceOf(left, right, from.place, to.place)) {
      const double width = lengthOf(left.nearestTo(*place) - *place) + lengthOf(right.nearestTo(*place) - *place);
      if (width < edge.width) {
        edge.width = width;
        edge.narrowest = places_.onFace(places_.faceAt(chain.faces, *place), *place);
      }
    }
    map_.edges.push_back(std::move(edge));
  }

  const NavigationMesh& mesh_;
  NavigationMesh bridged_;
  ClearanceField field_;
  CorridorAxis axis_;
  FieldPlaces places_{mesh_, bridged_, field_};
  std::vector<std::uint32_t> numbers_;  ///< of each node, its vertex
  CorridorMap map_;
};

/// Edges at each vertex.
std::vector<std::vector<std::uint32_t>> edgesAt(const CorridorMap& map) {
  std::vector<std::vector<std::uint32_t>> edges(map.vertices.size());
  for (std::uint32_t e = 0; e < map.edges.size(); ++e)
    for (const std::uint32_t v : {map.edges[e].from, map.edges[e].to}) edges[v].push_back(e);
  return edges;
}

}  // namespace

CorridorMap detail::makePolledCorridorMap(const NavigationMesh& mesh, bool isFull, Poll poll) {
  return MapMaker(mesh, poll).make(isFull, poll);
}

CorridorMap makeCorridorMap(const NavigationMesh& mesh, const CorridorOptions& options, const RunContext* context) {
  return makePolledCorridorMap(mesh, options.full, Poll(context));
}

CorridorPath shortestCorridor(const CorridorMap& map, std::uint32_t from, std::uint32_t to, double width) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CorridorPath path;
  if (map.vertices[from].width < width || map.vertices[to].width < width) return path;
  const auto edges = edgesAt(map);
  std::vector<double> lengths(map.vertices.size(), kInfinity);
  std::vector<std::uint32_t> by(map.vertices.size(), 0);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  lengths[from] = 0;
  queue.emplace(0, from);
  while (!queue.empty() && queue.top().second != to) {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > lengths[v]) continue;
    for (const std::uint32_t e : edges[v]) {
      const CorridorEdge& edge = map.edges[e];
      const std::uint32_t other = edge.from == v ? edge.to : edge.from;
      if (edge.width < width || length + edge.length >= lengths[other]) continue;
      lengths[other] = length + edge.length;
      by[other] = e;
      queue.emplace(lengths[other], other);
    }
  }
  if (lengths[to] == kInfinity) return path;
  path.length = lengths[to];
  path.width = std::min(map.vertices[from].width, map.vertices[to].width);
  path.vertices.push_back(to);
  for (std::uint32_t v = to; v != from;) {
    const CorridorEdge& edge = map.edges[by[v]];
    path.edges.push_back(by[v]);
    path.width = std::min(path.width, edge.width);
    v = edge.from == v ? edge.to : edge.from;
    path.vertices.push_back(v);
  }
  std::reverse(path.edges.begin(), path.edges.end());
  std::reverse(path.vertices.begin(), path.vertices.end());
  return path;
}

CorridorPath widestCorridor(const CorridorMap& map, std::uint32_t from, std::uint32_t to) {
  const auto edges = edgesAt(map);
  std::vector<double> widths(map.vertices.size(), -1);
  std::priority_queue<std::pair<double, std::uint32_t>> queue;
  widths[from] = map.vertices[from].width;
  queue.emplace(widths[from], from);
  while (!queue.empty()) {
    const auto [width, v] = queue.top();
    queue.pop();
    if (width < widths[v]) continue;
    for (const std::uint32_t e : edges[v]) {
      const CorridorEdge& edge = map.edges[e];
      const std::uint32_t other = edge.from == v ? edge.to : edge.from;
      const double through = std::min(width, edge.width);
      if (through <= widths[other]) continue;
      widths[other] = through;
      queue.emplace(through, other);
    }
  }
  return widths[to] < 0 ? CorridorPath{} : shortestCorridor(map, from, to, widths[to]);
}

std::uint32_t nearestVertex(const CorridorMap& map, const Vec3& place) {
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  for (std::uint32_t v = 0; v < map.vertices.size(); ++v) {
    const Vec3& p = map.vertices[v].place;
    const double distance = std::hypot(p.x - place.x, p.y - place.y, p.z - place.z);
    if (distance >= least) continue;
    least = distance;
    nearest = v;
  }
  return nearest;
}

}  // namespace footfall
