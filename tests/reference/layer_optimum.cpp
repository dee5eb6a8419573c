// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/layer_optimum.hpp"

#include <algorithm>
#include <deque>

namespace footfall::reference {
namespace {

constexpr std::size_t kMostVisits = 20000;

struct Link {
  std::size_t to = 0;
  std::size_t edge = 0;
};

enum class EdgeState : char { Open, Kept, Cut };

class Search {
 public:
  explicit Search(const std::vector<Piece>& pieces) : links_(pieces.size()), overlaps_(pieces.size()) {
    std::size_t count = 0;
    for (const auto& [edge, uses] : findEdges(pieces)) {
      if (uses.size() != 2 || pieces[uses[0].piece].obstacleEdge[uses[0].edge]) continue;
      links_[uses[0].piece].push_back({uses[1].piece, count});
      links_[uses[1].piece].push_back({uses[0].piece, count});
      ++count;
    }
    states_.assign(count, EdgeState::Open);
    for (const auto& [a, b] : findOverlaps(pieces)) {
      overlaps_[a].push_back(b);
      overlaps_[b].push_back(a);
    }
  }

  bool solve(std::size_t cuts) {
    if (++visits_ > kMostVisits) return false;
    const auto path = findShortestConflict();
    if (!path) return true;
    if (cuts == 0) return false;
    // One of the path's edges must be cut: the first that is decides the branch.
    std::vector<std::size_t> kept;
    bool solved = false;
    for (const std::size_t edge : *path) {
      if (states_[edge] == EdgeState::Kept) continue;
      states_[edge] = EdgeState::Cut;
      solved = solve(cuts - 1);
      states_[edge] = EdgeState::Kept;
      kept.push_back(edge);
      if (solved || tooLong()) break;
    }
    for (const std::size_t edge : kept) states_[edge] = EdgeState::Open;
    return solved;
  }

  [[nodiscard]] bool tooLong() const { return visits_ > kMostVisits; }

 private:
  /// The edges of a shortest path between two pieces that overlap, over edges that are not cut.
  std::optional<std::vector<std::size_t>> findShortestConflict() const {
    std::optional<std::vector<std::size_t>> best;
    for (std::size_t start = 0; start < links_.size(); ++start) {
      if (overlaps_[start].empty()) continue;
      std::vector<std::optional<Link>> from(links_.size());
      std::vector<std::size_t> distance(links_.size(), 0);
      std::deque<std::size_t> queue{start};
      from[start] = Link{start, 0};
      while (!queue.empty()) {
        const std::size_t at = queue.front();
        queue.pop_front();
        if (best && distance[at] >= best->size()) break;
        if (std::find(overlaps_[start].begin(), overlaps_[start].end(), at) != overlaps_[start].end()) {
          std::vector<std::size_t> path;
          for (std::size_t p = at; p != start; p = from[p]->to) path.push_back(from[p]->edge);
          best = path;
          break;
        }
        for (const Link& link : links_[at]) {
          if (states_[link.edge] == EdgeState::Cut || from[link.to]) continue;
          from[link.to] = Link{at, link.edge};
          distance[link.to] = distance[at] + 1;
          queue.push_back(link.to);
        }
      }
    }
    return best;
  }

  std::vector<std::vector<Link>> links_;
  std::vector<std::vector<std::size_t>> overlaps_;
  std::vector<EdgeState> states_;
  std::size_t visits_ = 0;
};

}  // namespace

std::vector<std::array<std::size_t, 2>> findOverlaps(const std::vector<Piece>& pieces) {
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!intersection(pieces[i].plan, pieces[j].plan).empty()) pairs.push_back({i, j});
  return pairs;
}

std::size_t countConnections(const std::vector<Piece>& pieces) {
  std::size_t count = 0;
  for (const auto& [edge, uses] : findEdges(pieces)) {
    if (uses.size() != 2 || pieces[uses[0].piece].obstacleEdge[uses[0].edge]) continue;
    count += pieces[uses[0].piece].layer != pieces[uses[1].piece].layer;
  }
  return count;
}

std::optional<std::size_t> fewestConnections(const std::vector<Piece>& pieces, std::size_t most) {
  Search search(pieces);
  for (std::size_t cuts = 0; cuts <= most && !search.tooLong(); ++cuts)
    if (search.solve(cuts)) return cuts;
  return std::nullopt;
}

}  // namespace footfall::reference
