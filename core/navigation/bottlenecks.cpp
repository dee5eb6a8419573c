// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "core/base/disjoint_sets.hpp"
#include "core/navigation/corridor_graph.hpp"

namespace footfall {
namespace detail {
namespace {

constexpr std::uint32_t kNoEdge = 0xFFFFFFFF;
/// Widths that differ by less, relative to them, are one width: borders that are parallel but for roundings.
constexpr double kSameWidth = 1e-6;
/// Border places are opposite each other when they are as far apart as the place is wide, less this share.
constexpr double kNotOpposite = 1e-3;

double acrossPlan(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Vec3 between(const Vec3& a, const Vec3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

/// Nodes are the vertices of the map, and behind them the narrowest places between the ends of edges.
class BottleneckFinder {
 public:
  BottleneckFinder(const CorridorMap& map, const std::vector<double>& hidden, Poll poll)
      : map_(map), hidden_(hidden), poll_(poll), narrowNodes_(map.edges.size(), kNoEdge) {
    for (const CorridorVertex& vertex : map.vertices) widths_.push_back(vertex.width);
    for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
      const CorridorEdge& edge = map.edges[e];
      if (edge.width >= std::min(widths_[edge.from], widths_[edge.to])) continue;
      narrowNodes_[e] = static_cast<std::uint32_t>(widths_.size());
      narrowEdges_.push_back(e);
      widths_.push_back(edge.width);
    }
    edges_.resize(map.vertices.size());
    for (std::uint32_t e = 0; e < map.edges.size(); ++e)
      for (const std::uint32_t v : {map.edges[e].from, map.edges[e].to}) edges_[v].push_back(e);
  }

  std::vector<Bottleneck> find() {
    findBridges();
    std::vector<Found> found;
    for (auto& nodes : valleys()) {
      poll_();
      if (const auto bottleneck = bottleneckOf(nodes)) found.push_back({*bottleneck, std::move(nodes)});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.bottleneck.width < b.bottleneck.width; });
    findWidest(found);
    std::vector<Bottleneck> bottlenecks;
    for (const Found& f : found) bottlenecks.push_back(f.bottleneck);
    return bottlenecks;
  }

 private:
  struct Found {
    Bottleneck bottleneck;
    std::vector<std::uint32_t> nodes;  ///< its valley
  };

  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t node) const {
    std::vector<std::uint32_t> nodes;
    if (node >= map_.vertices.size()) {
      const CorridorEdge& edge = map_.edges[narrowEdges_[node - map_.vertices.size()]];
      return {edge.from, edge.to};
    }
    for (const std::uint32_t e : edges_[node])
      nodes.push_back(narrowNodes_[e] != kNoEdge ? narrowNodes_[e] : otherEnd(e, node));
    return nodes;
  }
  [[nodiscard]] std::uint32_t otherEnd(std::uint32_t e, std::uint32_t v) const {
    return map_.edges[e].from == v ? map_.edges[e].to : map_.edges[e].from;
  }

  /// Sets of nodes that are as narrow, and hang together, and have nothing narrower beside them; the narrowest first.
  std::vector<std::vector<std::uint32_t>> valleys() const {
    std::vector<std::uint32_t> order(widths_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return widths_[a] < widths_[b]; });
    std::vector<char> isTaken(widths_.size(), 0);
    std::vector<std::vector<std::uint32_t>> valleys;
    for (const std::uint32_t first : order) {
      if (isTaken[first] != 0) continue;
      const double most = widths_[first] * (1 + kSameWidth);
      std::vector<std::uint32_t> nodes{first};
      isTaken[first] = 1;
      bool isLowest = true;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const std::uint32_t next : neighbours(nodes[i])) {
          // A bottleneck that was taken before is narrower, or belongs to this valley.
          if (isTaken[next] != 0 && std::find(nodes.begin(), nodes.end(), next) == nodes.end()) isLowest = false;
          if (isTaken[next] != 0 || widths_[next] > most) continue;
          isTaken[next] = 1;
          nodes.push_back(next);
        }
      if (isLowest) valleys.push_back(std::move(nodes));
    }
    return valleys;
  }

  /// The edge of a valley to speak of: the longest one within it, or one beside its narrowest node.
  [[nodiscard]] std::uint32_t edgeOf(const std::vector<std::uint32_t>& nodes) const {
    const std::uint32_t first = nodes.front();
    std::uint32_t best = kNoEdge;
    for (const std::uint32_t node : nodes) {
      if (node >= map_.vertices.size()) continue;
      for (const std::uint32_t e : edges_[node]) {
        const bool isWithin = narrowNodes_[e] == kNoEdge && otherEnd(e, node) != node &&
                              std::find(nodes.begin(), nodes.end(), otherEnd(e, node)) != nodes.end();
        if (isWithin && (best == kNoEdge || map_.edges[e].length > map_.edges[best].length)) best = e;
      }
    }
    if (best != kNoEdge) return best;
    return first >= map_.vertices.size() ? narrowEdges_[first - map_.vertices.size()]
           : edges_[first].empty()       ? kNoEdge
                                         : edges_[first].front();
  }

  [[nodiscard]] bool isWithin(const std::vector<std::uint32_t>& nodes, std::uint32_t v) const {
    return std::find(nodes.begin(), nodes.end(), v) != nodes.end();
  }

  [[nodiscard]] std::optional<Bottleneck> bottleneckOf(const std::vector<std::uint32_t>& nodes) const {
    const std::uint32_t e = edgeOf(nodes);
    if (e == kNoEdge) return std::nullopt;
    const CorridorEdge& edge = map_.edges[e];
    // A place that does not get wider on at least two sides is the end of a way.
    std::size_t wider = 0;
    for (const std::uint32_t node : nodes)
      for (const std::uint32_t next : neighbours(node)) wider += isWithin(nodes, next) ? 0 : 1;
    if (wider < 2) return std::nullopt;
    Bottleneck b;
    b.edge = e;
    b.width = widths_[nodes.front()];
    double share = 0;
    if (narrowNodes_[e] != kNoEdge && nodes.front() == narrowNodes_[e]) {
      b.place = edge.narrowest;
      share = edge.length > 0 ? acrossPlan(map_.vertices[edge.from].place, b.place) /
                                    (acrossPlan(map_.vertices[edge.from].place, b.place) +
                                     acrossPlan(b.place, map_.vertices[edge.to].place))
                              : 0;
      setBorders(edge, b);
    } else {
      const bool isFrom = isWithin(nodes, edge.from), isTo = isWithin(nodes, edge.to);
      share = isFrom && isTo ? 0.5 : isFrom ? 0 : 1;
      b.place = between(map_.vertices[edge.from].place, map_.vertices[edge.to].place, share);
      b.left = between(edge.left[0], edge.left[1], share);
      b.right = between(edge.right[0], edge.right[1], share);
    }
    if (acrossPlan(b.left, b.right) < b.width * (1 - kNotOpposite)) return std::nullopt;
    b.isOnlyWay = isBridge_[e] != 0;
    if (b.isOnlyWay) setAreas(e, share, b);
    return b;
  }

  /// The corner on either side; where there is one only, the other place lies as far on the other side.
  static void setBorders(const CorridorEdge& edge, Bottleneck& b) {
    b.left = edge.left[0];
    b.right = edge.right[0];
    if (edge.shape != CorridorShape::Parabola) return;
    const bool isLeftCorner = edge.left[0] == edge.left[1];
    const Vec3& corner = isLeftCorner ? edge.left[0] : edge.right[0];
    const auto& side = isLeftCorner ? edge.right : edge.left;
    const double x = side[1].x - side[0].x, y = side[1].y - side[0].y, squared = x * x + y * y;
    const double along =
        squared > 0 ? std::clamp(((corner.x - side[0].x) * x + (corner.y - side[0].y) * y) / squared, 0.0, 1.0) : 0;
    (isLeftCorner ? b.right : b.left) = between(side[0], side[1], along);
  }

  /// Edges without which the map falls apart, by the depths of a search; and the areas below them.
  void findBridges() {
    const std::size_t count = map_.vertices.size();
    isBridge_.assign(map_.edges.size(), 0);
    below_.assign(map_.edges.size(), 0);
    lower_.assign(map_.edges.size(), kNoEdge);
    whole_.assign(count, 0);
    std::vector<std::uint32_t> depth(count, 0), low(count, 0), root(count, 0), next(count, 0), by(count, kNoEdge);
    std::vector<double> area(count, 0);
    for (std::uint32_t start = 0; start < count; ++start) {
      if (depth[start] != 0) continue;
      std::vector<std::uint32_t> path{start};
      depth[start] = low[start] = 1;
      root[start] = start;
      area[start] = hidden_[start];
      while (!path.empty()) {
        const std::uint32_t v = path.back();
        if (next[v] < edges_[v].size()) {
          const std::uint32_t e = edges_[v][next[v]++], w = otherEnd(e, v);
          if (e == by[v]) continue;
          if (depth[w] != 0) {
            low[v] = std::min(low[v], depth[w]);
            if (depth[w] < depth[v]) area[v] += map_.edges[e].area;
            if (w == v) area[v] += map_.edges[e].area / 2;  // it comes twice
            continue;
          }
          depth[w] = low[w] = depth[v] + 1;
          root[w] = start;
          by[w] = e;
          area[w] = hidden_[w];
          path.push_back(w);
          continue;
        }
        path.pop_back();
        if (path.empty()) break;
        const std::uint32_t u = path.back();
        isBridge_[by[v]] = low[v] > depth[u] ? 1 : 0;
        below_[by[v]] = area[v];
        lower_[by[v]] = v;
        low[u] = std::min(low[u], low[v]);
        area[u] += area[v] + map_.edges[by[v]].area;
      }
      whole_[start] = area[start];
    }
    root_ = std::move(root);
  }

  void setAreas(std::uint32_t e, double share, Bottleneck& b) const {
    const CorridorEdge& edge = map_.edges[e];
    const bool isFromLower = lower_[e] == edge.from;
    const double other = whole_[root_[edge.from]] - below_[e] - edge.area;
    b.sides[0].area = (isFromLower ? below_[e] : other) + share * edge.area;
    b.sides[1].area = (isFromLower ? other : below_[e]) + (1 - share) * edge.area;
  }

  /// Unites the map again, the widest edges first, up to each bottleneck. A bottleneck is united after its sides are
  /// known, so that of several bottlenecks with one width, the first one has sides behind the others.
  void findWidest(std::vector<Found>& found) const {
    std::vector<std::uint32_t> order(map_.edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return map_.edges[a].width > map_.edges[b].width; });
    DisjointSets sets(map_.vertices.size());
    std::vector<std::uint32_t> widest(map_.vertices.size());
    std::iota(widest.begin(), widest.end(), 0);
    const auto unite = [&](std::uint32_t e) {
      const Index from = static_cast<Index>(map_.edges[e].from), to = static_cast<Index>(map_.edges[e].to);
      const std::uint32_t v = widest[sets.find(from)], w = widest[sets.find(to)];
      sets.unite(from, to);
      widest[sets.find(from)] = widths_[w] > widths_[v] ? w : v;
    };
    std::size_t done = 0;
    for (auto f = found.rbegin(); f != found.rend(); ++f) {
      Bottleneck& b = f->bottleneck;
      for (; done < order.size() && map_.edges[order[done]].width > b.width * (1 + kSameWidth); ++done)
        unite(order[done]);
      for (int side = 0; side < 2; ++side) b.sides[side].widest = widestFrom(b, side, sets, widest);
      for (const std::uint32_t node : f->nodes) {
        if (node >= map_.vertices.size()) {
          unite(narrowEdges_[node - map_.vertices.size()]);
        } else {
          for (const std::uint32_t e : edges_[node]) unite(e);
        }
      }
    }
  }

  /// Goes on from an end of a bottleneck's edge through what is as narrow, and takes the widest part that it meets.
  std::uint32_t widestFrom(const Bottleneck& b, int side, DisjointSets& sets,
                           const std::vector<std::uint32_t>& widest) const {
    const CorridorEdge& edge = map_.edges[b.edge];
    std::vector<std::uint32_t> path{side == 0 ? edge.from : edge.to};
    std::uint32_t best = path.front();
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::uint32_t v = path[i], there = widest[sets.find(static_cast<Index>(v))];
      if (widths_[there] > widths_[best]) best = there;
      if (widths_[v] > b.width * (1 + kSameWidth)) continue;
      for (const std::uint32_t e : edges_[v]) {
        const std::uint32_t w = otherEnd(e, v);
        if (e == b.edge || map_.edges[e].width < b.width * (1 - kSameWidth)) continue;
        if (std::find(path.begin(), path.end(), w) == path.end()) path.push_back(w);
      }
    }
    return best;
  }

  const CorridorMap& map_;
  const std::vector<double>& hidden_;
  Poll poll_;
  std::vector<double> widths_;                            ///< of each node
  std::vector<std::uint32_t> narrowNodes_, narrowEdges_;  ///< of each edge its node; of each such node its edge
  std::vector<std::vector<std::uint32_t>> edges_;         ///< at each vertex
  std::vector<char> isBridge_;
  std::vector<double> below_;                ///< of each edge of the search, the area below it
  std::vector<std::uint32_t> lower_, root_;  ///< its lower end; of each vertex, the vertex that its part begins with
  std::vector<double> whole_;                ///< of each such vertex, the area of the part
};

}  // namespace

std::vector<Bottleneck> findBottlenecks(const CorridorMap& map, const std::vector<double>& hidden, Poll poll) {
  return BottleneckFinder(map, hidden, poll).find();
}

}  // namespace detail

double prominence(const CorridorMap& map, const Bottleneck& bottleneck) {
  double least = std::numeric_limits<double>::infinity();
  for (const BottleneckSide& side : bottleneck.sides) least = std::min(least, map.vertices[side.widest].width);
  return least / bottleneck.width - 1;
}

}  // namespace footfall
