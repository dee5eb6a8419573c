// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/corridor_graph.hpp"

#include <algorithm>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/navigation/axis_islands.hpp"
#include "core/navigation/axis_vertex.hpp"

namespace footfall::detail {
namespace {

constexpr std::uint32_t kNoArc = 0xFFFFFFFF;

class GraphMaker {
 public:
  GraphMaker(const ClearanceField& field, const CorridorAxis& axis, Poll poll)
      : field_(field), axis_(axis), poll_(poll), runs_(field.features().size()) {
    makeRuns();
    isLeftOut_ = arcsToLeaveOut(field, axis, poll);
    leaveOutSmallParts(field, axis, isLeftOut_);
    makeEnds();
    graph_.hidden.assign(axis.nodes.size(), 0);
  }

  CorridorGraph make(bool isFull) {
    const std::vector<std::uint32_t> best = widestNodes();
    if (!isFull) leaveOutCorners();
    findChains();
    std::vector<char> hasChain(axis_.nodes.size(), 0);
    for (const CorridorChain& chain : graph_.chains) hasChain[part(chain.from)] = 1;
    for (const std::uint32_t node : best)
      if (hasChain[part(node)] == 0) graph_.alone.push_back(node);
    return std::move(graph_);
  }

 private:
  /// Edges of the border that go on straight are one run.
  void makeRuns() {
    const FieldSurface& surface = field_.surface();
    std::vector<std::uint32_t> beginsAt(surface.topology.fanVertices.size(), kNoArc);
    for (std::uint32_t f = 0; f < field_.features().size(); ++f)
      if (!field_.features()[f].isCorner()) beginsAt[axisFeature(field_, f).beginFan] = f;
    for (std::uint32_t f = 0; f < field_.features().size(); ++f) {
      if (field_.features()[f].isCorner()) continue;
      const std::uint32_t next = beginsAt[axisFeature(field_, f).endFan];
      if (next != kNoArc && next != f && field_.featureOfFan(axisFeature(field_, f).endFan) == FieldEdge::kNone &&
          pairOf(field_, f, next) == AxisPair::Joined)
        runs_.unite(static_cast<Index>(f), static_cast<Index>(next));
    }
  }

  void makeEnds() {
    starts_.assign(axis_.nodes.size() + 1, 0);
    for (const AxisArc& arc : axis_.arcs) ++starts_[arc.from + 1], ++starts_[arc.to + 1];
    for (std::size_t n = 0; n < axis_.nodes.size(); ++n) starts_[n + 1] += starts_[n];
    ends_.resize(2 * axis_.arcs.size());
    std::vector<std::uint32_t> filled(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t a = 0; a < axis_.arcs.size(); ++a)
      for (const std::uint32_t node : {axis_.arcs[a].from, axis_.arcs[a].to}) ends_[filled[node]++] = a;
  }

  [[nodiscard]] std::vector<std::uint32_t> arcsAt(std::uint32_t node) const {
    std::vector<std::uint32_t> arcs;
    for (std::uint32_t i = starts_[node]; i < starts_[node + 1]; ++i)
      if (isLeftOut_[ends_[i]] == 0) arcs.push_back(ends_[i]);
    return arcs;
  }
  [[nodiscard]] std::uint32_t otherEnd(std::uint32_t arc, std::uint32_t node) const {
    return axis_.arcs[arc].from == node ? axis_.arcs[arc].to : axis_.arcs[arc].from;
  }
  std::uint32_t part(std::uint32_t node) const { return parts_[node]; }

  /// The node that is farthest from the border, for each part of the axis that has an arc.
  std::vector<std::uint32_t> widestNodes() {
    DisjointSets sets(axis_.nodes.size());
    for (std::size_t a = 0; a < axis_.arcs.size(); ++a)
      if (isLeftOut_[a] == 0) sets.unite(static_cast<Index>(axis_.arcs[a].from), static_cast<Index>(axis_.arcs[a].to));
    parts_.resize(axis_.nodes.size());
    std::vector<std::uint32_t> best(axis_.nodes.size(), kNoArc), nodes;
    for (std::uint32_t n = 0; n < axis_.nodes.size(); ++n) {
      parts_[n] = static_cast<std::uint32_t>(sets.find(static_cast<Index>(n)));
      if (arcsAt(n).empty()) continue;
      std::uint32_t& widest = best[parts_[n]];
      if (widest == kNoArc || axis_.nodes[n].distance > axis_.nodes[widest].distance) widest = n;
    }
    for (const std::uint32_t n : best)
      if (n != kNoArc) nodes.push_back(n);
    return nodes;
  }

  [[nodiscard]] std::array<Index, 2> runsOf(std::uint32_t arc) {
    std::array<Index, 2> runs{runs_.find(static_cast<Index>(axis_.arcs[arc].features[0])),
                              runs_.find(static_cast<Index>(axis_.arcs[arc].features[1]))};
    if (runs[0] > runs[1]) std::swap(runs[0], runs[1]);
    return runs;
  }

  /// Leaves out the pieces from each convex corner between its two borders, up to where the axis divides.
  void leaveOutCorners() {
    for (std::uint32_t n = 0; n < axis_.nodes.size(); ++n) {
      if (n % 4096 == 0) poll_();
      if (axis_.nodes[n].distance > 4 * field_.margin()) continue;
      for (const std::uint32_t first : arcsAt(n)) {
        if (isLeftOut_[first] != 0 ||
            pairOf(field_, axis_.arcs[first].features[0], axis_.arcs[first].features[1]) != AxisPair::Convex)
          continue;
        const auto runs = runsOf(first);
        std::uint32_t node = n, arc = first;
        double hidden = 0;
        for (;;) {
          isLeftOut_[arc] = 1;
          hidden += areaOf(field_, axis_, axis_.arcs[arc]);
          node = otherEnd(arc, node);
          const auto next = arcsAt(node);
          if (next.size() != 1 || runsOf(next[0]) != runs) break;
          arc = next[0];
        }
        graph_.hidden[node] += hidden;
      }
    }
  }

  [[nodiscard]] bool goesOn(std::uint32_t node, std::uint32_t arc, std::uint32_t& next) const {
    const auto arcs = arcsAt(node);
    if (arcs.size() != 2) return false;
    next = arcs[0] == arc ? arcs[1] : arcs[0];
    return next != arc && axis_.arcs[next].features == axis_.arcs[arc].features;
  }

  void findChains() {
    std::vector<char> isDone(axis_.arcs.size(), 0);
    for (std::uint32_t a = 0; a < axis_.arcs.size(); ++a) {
      if (a % 4096 == 0) poll_();
      if (isLeftOut_[a] != 0 || isDone[a] != 0) continue;
      // Back to where the chain begins, then along it.
      std::uint32_t node = axis_.arcs[a].from, arc = a, next = 0;
      while (goesOn(node, arc, next) && next != a) {
        arc = next;
        node = otherEnd(arc, node);
      }
      addChain(node, arc, isDone);
    }
  }

  void addChain(std::uint32_t node, std::uint32_t arc, std::vector<char>& isDone) {
    CorridorChain chain;
    chain.from = node;
    for (std::uint32_t next = 0;; arc = next) {
      isDone[arc] = 1;
      chain.faces.push_back(axis_.arcs[arc].face);
      chain.area += areaOf(field_, axis_, axis_.arcs[arc]);
      const std::uint32_t begin = node;
      node = otherEnd(arc, node);
      chain.length += lengthBetween(arc, begin, node);
      if (chain.faces.size() == 1) setSides(chain, axis_.arcs[arc], begin);
      if (!goesOn(node, arc, next) || isDone[next] != 0) break;
    }
    chain.to = node;
    chain.faces.erase(std::unique(chain.faces.begin(), chain.faces.end()), chain.faces.end());
    graph_.chains.push_back(std::move(chain));
  }

  [[nodiscard]] double lengthBetween(std::uint32_t arc, std::uint32_t from, std::uint32_t to) const {
    return axisLength(field_.features()[axis_.arcs[arc].features[0]], field_.features()[axis_.arcs[arc].features[1]],
                      axis_.nodes[from].place, axis_.nodes[to].place);
  }

  static void setSides(CorridorChain& chain, const AxisArc& arc, std::uint32_t from) {
    const bool isFirstLeft = arc.isFirstLeft == (arc.from == from);
    chain.left = arc.features[isFirstLeft ? 0 : 1];
    chain.right = arc.features[isFirstLeft ? 1 : 0];
  }

  const ClearanceField& field_;
  const CorridorAxis& axis_;
  Poll poll_;
  DisjointSets runs_;
  std::vector<char> isLeftOut_;               ///< of each arc
  std::vector<std::uint32_t> starts_, ends_;  ///< of each node, its arcs
  std::vector<std::uint32_t> parts_;
  CorridorGraph graph_;
};

}  // namespace

CorridorGraph makeCorridorGraph(const ClearanceField& field, const CorridorAxis& axis, bool isFull, Poll poll) {
  return GraphMaker(field, axis, poll).make(isFull);
}

}  // namespace footfall::detail
