// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/layer_pieces.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <tuple>

#include "core/filters/layers/piece_conflicts.hpp"

namespace footfall::detail {
namespace {

constexpr Index kNone = -1;

class RegionSubdivision {
 public:
  RegionSubdivision(const LayerInput& input, std::span<const Index> triangles, std::span<const Index> ranks,
                    std::vector<Index>& piece, PieceConflicts& conflicts, RunContext& context)
      : input_(input), triangles_(triangles), ranks_(ranks), piece_(piece), conflicts_(conflicts), context_(context) {}

  std::vector<Index> run() {
    growPieces();
    do {
      mergePieces();
    } while (moveTriangles());
    return std::move(seeds_);
  }

 private:
  void growPieces() {
    for (const Index t : triangles_) piece_[t] = kNone;
    std::priority_queue<Index, std::vector<Index>, std::greater<>> front;  // queue of ranks
    std::size_t polls = 0;
    for (const Index lowest : ranks_) {
      const Index seed = input_.byHeight[lowest];
      if (piece_[seed] >= 0) continue;
      const auto piece = static_cast<Index>(seeds_.size());
      const Index blocked = kNone - 1 - piece;  // a triangle that overlaps the piece
      seeds_.push_back(seed);
      front.push(lowest);
      conflicts_.begin(piece);
      while (!front.empty()) {
        if ((++polls & 1023) == 0) context_.checkCancelled();
        const Index t = input_.byHeight[front.top()];
        front.pop();
        if (piece_[t] >= 0 || piece_[t] == blocked) continue;
        if (conflicts_.isBlocked(t)) {
          piece_[t] = blocked;
          continue;
        }
        piece_[t] = piece;
        conflicts_.take(t);
        for (const Index n : input_.neighbors[t])
          if (piece_[n] < 0 && piece_[n] != blocked) front.push(input_.rank[n]);
      }
    }
  }

  // Unites neighbouring pieces that overlap nowhere, most connections first; among equals the first pair by number.
  void mergePieces() {
    std::vector<std::map<Index, int>> cuts(seeds_.size());  // connections with each neighbouring piece
    for (const Index t : triangles_)
      for (const Index n : input_.neighbors[t])
        if (piece_[n] != piece_[t]) ++cuts[piece_[t]][piece_[n]];
    conflicts_.beginUniting(seeds_.size());
    context_.checkCancelled();
    using Candidate = std::tuple<int, Index, Index>;  // fewest connections (negative: most), then the pair
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
    const auto offer = [&](Index p, Index q, int size) { candidates.emplace(-size, std::min(p, q), std::max(p, q)); };
    for (Index p = 0; p < static_cast<Index>(cuts.size()); ++p)
      for (const auto& [q, size] : cuts[p])
        if (p < q) offer(p, q, size);
    std::vector<Index> mergedInto(seeds_.size(), kNone);
    while (!candidates.empty()) {
      const auto [negative, into, from] = candidates.top();
      candidates.pop();
      const auto cut = cuts[into].find(from);
      if (cut == cuts[into].end() || cut->second != -negative || conflicts_.overlap(into, from)) continue;
      context_.checkCancelled();
      mergedInto[from] = into;
      cuts[into].erase(cut);
      cuts[from].erase(into);
      for (const auto& [other, size] : cuts[from]) {
        cuts[other].erase(from);
        const int sum = cuts[into][other] += size;
        cuts[other][into] = sum;
        offer(into, other, sum);
      }
      cuts[from].clear();
      conflicts_.unite(into, from);
    }
    // A piece is merged into one with a smaller number.
    for (Index p = 0; p < static_cast<Index>(mergedInto.size()); ++p)
      if (mergedInto[p] == kNone)
        mergedInto[p] = p;
      else
        mergedInto[p] = mergedInto[mergedInto[p]];
    for (const Index t : triangles_) piece_[t] = mergedInto[piece_[t]];
  }

  // Moves single triangles to a neighbouring piece while that saves connections.
  bool moveTriangles() {
    bool changed = false;
    conflicts_.beginMoving(seeds_.size());
    std::vector<Index> queue(triangles_.begin(), triangles_.end());
    for (std::size_t head = 0; head < queue.size(); ++head) {
      if ((head & 1023) == 0) context_.checkCancelled();
      const Index t = queue[head];
      const auto neighbors = input_.neighbors[t];
      const auto links = [&](Index piece) {
        return std::count_if(neighbors.begin(), neighbors.end(), [&](Index n) { return piece_[n] == piece; });
      };
      Index target = kNone;
      auto gain = links(piece_[t]);
      for (const Index n : neighbors) {
        const Index p = piece_[n];
        if (p == piece_[t] || links(p) <= gain) continue;
        if (conflicts_.overlapsPiece(t, p)) continue;
        target = p;
        gain = links(p);
      }
      if (target == kNone) continue;
      piece_[t] = target;
      conflicts_.move(t, target);
      changed = true;
      queue.insert(queue.end(), neighbors.begin(), neighbors.end());
    }
    return changed;
  }

  const LayerInput& input_;
  std::span<const Index> triangles_, ranks_;
  std::vector<Index>& piece_;
  PieceConflicts& conflicts_;
  RunContext& context_;
  std::vector<Index> seeds_;
};

}  // namespace

std::vector<Index> subdivideRegion(const LayerInput& input, std::span<const Index> triangles,
                                   std::span<const Index> ranks, std::vector<Index>& piece, RunContext& context,
                                   SearchCounts& counts) {
  PieceConflicts conflicts(input, triangles, piece, context);
  std::vector<Index> seeds = RegionSubdivision(input, triangles, ranks, piece, conflicts, context).run();
  counts = conflicts.takeCounts();
  return seeds;
}

}  // namespace footfall::detail
