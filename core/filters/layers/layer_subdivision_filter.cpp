// LayerSubdivisionFilter (the thesis's PEELFilter): splits the walkable triangles into layers that do not overlap in
// the plan, with few connections (model, Layers, thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region that lies nowhere above itself is one piece; others are divided (layer_pieces.hpp). The pieces are then put
// into as few layers as a greedy pass finds. Outlines decide which regions lie above themselves (double_cover.hpp), and
// triangles are looked up among those of a piece (piece_conflicts.hpp) or of the pieces of a layer (layer_cover.hpp).
// All overlapping pairs of triangles are listed instead where later runs need them, unless there are far more of them
// than triangles, as in a tower of thousands of floors or a spiral of hundreds of turns. The result is the same.

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/lexicographic_order.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/layers/double_cover.hpp"
#include "core/filters/layers/known_overlaps.hpp"
#include "core/filters/layers/layer_cover.hpp"
#include "core/filters/layers/layer_pieces.hpp"
#include "core/filters/layers/plan_overlaps.hpp"
#include "core/mesh/first_uses.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

constexpr Index kTrianglesPerTask = 2048;

using Pair = std::array<Index, 2>;

// The lists of both members of each pair.
IndexLists listsOf(const std::vector<Pair>& pairs, Index count) {
  IndexLists lists;
  lists.first.assign(count + 1, 0);
  for (const auto& [s, t] : pairs) {
    ++lists.first[s + 1];
    ++lists.first[t + 1];
  }
  for (Index t = 0; t < count; ++t) lists.first[t + 1] += lists.first[t];
  lists.items.resize(lists.first.back());
  std::vector<Index> next(lists.first.begin(), lists.first.end() - 1);
  for (const auto& [s, t] : pairs) {
    lists.items[next[s]++] = t;
    lists.items[next[t]++] = s;
  }
  return lists;
}

class LayerSubdivision {
 public:
  /// `kernel` may be null where all pairs are given.
  LayerSubdivision(const PlanKernel* kernel, const WalkableMesh& mesh, const Adjacency& topology, RunContext& context)
      : kernel_(kernel),
        mesh_(mesh),
        topology_(topology),
        context_(context),
        count_(static_cast<Index>(mesh.triangles.size())) {}

  std::vector<std::uint32_t> run(const Recall& recall) {
    parallelInvoke([&] { findOverlaps(recall); },
                   [&] {
                     region_ = findRegions(mesh_, topology_, regionCount_);
                     findLowest();
                   });
    context_.checkCancelled();
    subdivideRegions();
    context_.progress(kShareOfPieces);
    return knowsAllOverlaps_ ? colourPieces() : placePieces();
  }

  std::vector<std::uint32_t> runWith(std::vector<Pair> overlaps) {
    overlaps_ = std::move(overlaps);
    region_ = findRegions(mesh_, topology_, regionCount_);
    findLowest();
    subdivideRegions();
    return colourPieces();
  }

  /// All pairs for the next run, or null where there are too many. Call it once.
  std::shared_ptr<const std::vector<Pair>> takeOverlaps() {
    return knowsAllOverlaps_ ? std::make_shared<const std::vector<Pair>>(std::move(overlaps_)) : nullptr;
  }

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  void findOverlaps(const Recall& recall) {
    const StatePtr& before = recall.before;
    const auto earlier = EarlierResult::relate(before, *kernel_);
    if (earlier && before->overlaps) {
      const MeshRelation relation = relateMeshes(*earlier, *before->mesh, mesh_);
      context_.checkCancelled();
      if (relation.related > count_ / 2) {
        overlaps_ = updatePlanOverlaps(*before->overlaps, relation, *kernel_, mesh_, context_, fallbacks_);
        return;
      }
    }
    knowsAllOverlaps_ = recall.keep;
    if (!recall.keep) return;
    const std::size_t most = kMostPairs + kMostPairsOfTriangle * static_cast<std::size_t>(count_);
    auto found = findPlanOverlaps(*kernel_, mesh_, topology_, most, context_, fallbacks_);
    knowsAllOverlaps_ = found.has_value();
    if (found) overlaps_ = std::move(*found);
  }

  void findLowest() {
    lowest_.resize(count_);
    parallelRanges(count_, kTrianglesPerTask, [&](const auto& range) {
      context_.checkCancelled();
      for (Index t = range.begin(); t != range.end(); ++t) {
        const auto& c = mesh_.triangles[t].corners;
        lowest_[t] = std::min({mesh_.vertices[c[0]].z, mesh_.vertices[c[1]].z, mesh_.vertices[c[2]].z});
      }
    });
  }

  // Neighbours come in the order of the edges, which is that of the first use of their vertices: after some filters,
  // vertices are numbered in another one.
  void findNeighbors(const std::vector<char>& divided) {
    std::vector<MeshTriangle> renumbered;
    Adjacency own;
    if (putInOrder(renumbered)) own = findEdges(renumbered, mesh_.vertices.size(), context_);
    const Adjacency& edges = renumbered.empty() ? topology_ : own;
    std::vector<Pair> pairs;
    for (Index e = 0; e < edges.edgeCount(); ++e) {
      const auto sides = edges.sidesOf(e);
      if (sides.size() < 2 || divided[region_[sides[0] / 3]] == 0 || isObstacle(mesh_.triangles, sides)) continue;
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) pairs.push_back({sides[i] / 3, sides[j] / 3});
    }
    input_.neighbors = listsOf(pairs, count_);
  }

  // False where vertices are in that order already.
  bool putInOrder(std::vector<MeshTriangle>& triangles) const {
    const FirstUses uses = findFirstUses(
        mesh_.triangles.size(), mesh_.vertices.size(), [&](std::size_t t) { return mesh_.triangles[t].corners; },
        context_);
    if (std::is_sorted(uses.order.begin(), uses.order.end())) return false;
    triangles = mesh_.triangles;
    renumber(triangles, uses, context_);
    return true;
  }

  void sortByHeight(const std::vector<char>& divided) {
    std::vector<Index> triangles;
    for (Index t = 0; t < count_; ++t)
      if (divided[region_[t]] != 0) triangles.push_back(t);
    const auto heightOf = [&](std::uint32_t i, int axis) { return axis == 0 ? lowest_[triangles[i]] : 0; };
    const std::vector<std::uint32_t> order = lexicographicOrder(triangles.size(), heightOf, context_);
    context_.checkCancelled();
    input_.byHeight.resize(order.size());
    input_.rank.assign(count_, -1);
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      input_.byHeight[rank] = triangles[order[rank]];
      input_.rank[input_.byHeight[rank]] = static_cast<Index>(rank);
    }
  }

  // Decides for each region whether it lies above itself; `within` receives the pairs that show it, where pairs are
  // known.
  std::vector<char> findDivided(std::vector<Pair>& within) {
    if (!knowsAllOverlaps_)
      return findDoubleCovers(region_, regionCount_, findTrianglesAcross(mesh_, topology_, context_), *kernel_, mesh_,
                              context_, fallbacks_);
    std::vector<char> divided(regionCount_, 0);
    for (const auto& pair : overlaps_) {
      if (region_[pair[0]] != region_[pair[1]]) continue;
      divided[region_[pair[0]]] = 1;
      within.push_back(pair);
    }
    return divided;
  }

  // Numbers all pieces by the height of the triangles from which they grew.
  void subdivideRegions() {
    std::vector<Pair> within;
    const std::vector<char> divided = findDivided(within);
    parallelInvoke([&] { input_.overlaps = listsOf(within, count_); }, [&] { findNeighbors(divided); },
                   [&] { sortByHeight(divided); });
    context_.checkCancelled();

    std::vector<Index> number(regionCount_, -1), regions, first{0};
    for (Index r = 0; r < regionCount_; ++r) {
      if (divided[r] == 0) continue;
      number[r] = static_cast<Index>(regions.size());
      regions.push_back(r);
    }
    first.resize(regions.size() + 1, 0);
    for (const Index r : region_)
      if (number[r] >= 0) ++first[number[r] + 1];
    for (std::size_t i = 0; i < regions.size(); ++i) first[i + 1] += first[i];
    std::vector<Index> triangles(first.back()), ranks(first.back());
    parallelInvoke(
        [&] {
          std::vector<Index> next = first;
          input_.number.resize(count_);
          for (Index t = 0; t < count_; ++t) {
            const Index n = number[region_[t]];
            if (n < 0) continue;
            input_.number[t] = next[n] - first[n];
            triangles[next[n]++] = t;
          }
        },
        [&] {
          std::vector<Index> next = first;
          for (std::size_t rank = 0; rank < ranks.size(); ++rank)
            ranks[next[number[region_[input_.byHeight[rank]]]]++] = static_cast<Index>(rank);
        });

    piece_.assign(count_, 0);
    std::vector<std::vector<Index>> seeds(regionCount_);
    std::vector<SearchCounts> counts(regions.size());
    parallelFor(regions.size(), [&](std::size_t i) {
      context_.checkCancelled();
      const std::span<const Index> own(triangles.data() + first[i], triangles.data() + first[i + 1]);
      const std::span<const Index> ownRanks(ranks.data() + first[i], ranks.data() + first[i + 1]);
      seeds[regions[i]] = knowsAllOverlaps_
                              ? subdivideRegion(input_, own, ownRanks, piece_, context_)
                              : subdivideRegion(input_, own, ownRanks, *kernel_, mesh_, piece_, context_, counts[i]);
    });
    context_.checkCancelled();
    for (const SearchCounts& own : counts) fallbacks_ += own.fallbacks;
    for (Index t = 0; t < count_; ++t) {
      if (divided[region_[t]] != 0) continue;
      auto& seed = seeds[region_[t]];
      if (seed.empty())
        seed.push_back(t);
      else if (lowest_[t] < lowest_[seed[0]])
        seed[0] = t;
    }
    numberPieces(seeds);
  }

  void numberPieces(const std::vector<std::vector<Index>>& seeds) {
    std::vector<Index> order;
    std::vector<Index> firstPiece(regionCount_ + 1, 0);
    for (Index r = 0; r < regionCount_; ++r) {
      order.insert(order.end(), seeds[r].begin(), seeds[r].end());
      firstPiece[r + 1] = static_cast<Index>(order.size());
    }
    pieceCount_ = static_cast<Index>(order.size());
    std::vector<Index> bySeed(count_, -1);
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return lowest_[a] != lowest_[b] ? lowest_[a] < lowest_[b] : a < b; });
    for (Index p = 0; p < pieceCount_; ++p) bySeed[order[p]] = p;
    for (Index t = 0; t < count_; ++t) piece_[t] = bySeed[seeds[region_[t]][piece_[t]]];
  }

  // Each piece, lowest first, goes to the layer without overlap with which it shares most edges, else the first one.
  std::vector<std::uint32_t> colourPieces() {
    // Pieces above and beside each other, once for each pair of triangles.
    std::vector<Pair> above, beside;
    for (const auto& [s, t] : overlaps_) above.push_back({piece_[s], piece_[t]});
    for (Index t = 0; t < count_; ++t)
      for (const Index n : input_.neighbors[t])
        if (n < t && piece_[n] != piece_[t]) beside.push_back({piece_[t], piece_[n]});
    context_.checkCancelled();
    IndexLists conflicts, shared;
    parallelInvoke([&] { conflicts = listsOf(above, pieceCount_); }, [&] { shared = listsOf(beside, pieceCount_); });
    context_.checkCancelled();
    std::vector<char> used(pieceCount_, 0);
    for (const Index p : piece_) used[p] = 1;
    constexpr std::uint32_t kUnplaced = 0xFFFFFFFF;
    std::vector<std::uint32_t> layerOf(pieceCount_, kUnplaced);
    std::vector<Index> blockedFor;  // for each layer the last piece that could not go there
    std::vector<int> edges;         // with each layer; zero between pieces
    for (Index p = 0; p < pieceCount_; ++p) {
      if (used[p] == 0) continue;
      if (p % 1024 == 0) context_.checkCancelled();
      for (const Index other : conflicts[p])
        if (layerOf[other] != kUnplaced) blockedFor[layerOf[other]] = p;
      std::uint32_t best = 0;
      while (best < blockedFor.size() && blockedFor[best] == p) ++best;
      if (best == blockedFor.size()) {
        blockedFor.push_back(-1);
        edges.push_back(0);
      } else {
        for (const Index other : shared[p])
          if (layerOf[other] != kUnplaced) ++edges[layerOf[other]];
        for (const Index other : shared[p]) {
          const std::uint32_t l = layerOf[other];
          if (l == kUnplaced || blockedFor[l] == p) continue;
          if (edges[l] > edges[best] || (edges[l] == edges[best] && l < best)) best = l;
        }
        for (const Index other : shared[p])
          if (layerOf[other] != kUnplaced) edges[layerOf[other]] = 0;
      }
      layerOf[p] = best;
    }
    std::vector<std::uint32_t> layers(count_);
    for (Index t = 0; t < count_; ++t) layers[t] = layerOf[piece_[t]];
    return layers;
  }

  // Places pieces without the pairs: the layers decide whether a piece overlaps them.
  std::vector<std::uint32_t> placePieces() {
    std::vector<Index> first(pieceCount_ + 1, 0), triangles(count_);
    for (const Index p : piece_) ++first[p + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Index> next(first.begin(), first.end() - 1);
    for (Index t = 0; t < count_; ++t) triangles[next[piece_[t]]++] = t;
    std::vector<Pair> beside;
    for (Index t = 0; t < count_; ++t)
      for (const Index n : input_.neighbors[t])
        if (n < t && piece_[n] != piece_[t]) beside.push_back({piece_[t], piece_[n]});
    const IndexLists shared = listsOf(beside, pieceCount_);

    std::vector<std::span<const Index>> pieces;
    for (Index p = 0; p < pieceCount_; ++p)
      pieces.emplace_back(triangles.data() + first[p], static_cast<std::size_t>(first[p + 1] - first[p]));
    LayerCover cover(*kernel_, mesh_, pieces, context_);
    constexpr std::uint32_t kUnplaced = 0xFFFFFFFF;
    std::vector<std::uint32_t> layerOf(pieceCount_, kUnplaced), layers(count_);
    for (Index p = 0; p < pieceCount_; ++p) {
      if (pieces[p].empty()) continue;
      if (p % 64 == 0) {
        context_.checkCancelled();
        context_.progress(kShareOfPieces + (1 - kShareOfPieces) * p / pieceCount_);
      }
      std::uint32_t best = cover.firstFree(p);
      if (best < cover.layerCount()) {
        std::map<std::uint32_t, int> edges;
        for (const Index other : shared[p])
          if (layerOf[other] != kUnplaced) ++edges[layerOf[other]];
        const auto edgesWith = [&](std::uint32_t l) { return edges.contains(l) ? edges.at(l) : 0; };
        int most = edgesWith(best);
        for (const auto& [l, count] : edges) {
          if (count < most || (count == most && l >= best) || !cover.isFree(l)) continue;
          best = l;
          most = count;
        }
      }
      cover.add(p, best);
      layerOf[p] = best;
      for (const Index t : pieces[p]) layers[t] = best;
    }
    fallbacks_ += cover.fallbacks();
    return layers;
  }

  static constexpr double kShareOfPieces = 0.5;  // of the time, at a guess
  static constexpr std::size_t kMostPairs = std::size_t{1} << 20;
  static constexpr std::size_t kMostPairsOfTriangle = 64;

  const PlanKernel* kernel_;
  const WalkableMesh& mesh_;
  const Adjacency& topology_;
  RunContext& context_;
  Index count_;
  std::vector<Pair> overlaps_;
  bool knowsAllOverlaps_ = true;  ///< else overlaps_ is empty
  std::vector<Index> region_;
  Index regionCount_ = 0;
  std::vector<double> lowest_;  ///< for each triangle the height of its lowest corner
  LayerInput input_;
  std::vector<Index> piece_;
  Index pieceCount_ = 0;
  ExactFallbacks fallbacks_;
};

}  // namespace

std::vector<std::uint32_t> layersOf(const WalkableMesh& mesh, const Adjacency& topology,
                                    std::vector<std::array<Index, 2>> overlaps, RunContext& context) {
  return LayerSubdivision(nullptr, mesh, topology, context).runWith(std::move(overlaps));
}

FilterOutcome applyLayerSubdivision(const StatePtr& given, const Recall& recall, RunContext& context) {
  FilterOutcome outcome;
  const StatePtr state = withMesh(given, context, outcome.fallbacks);
  const auto topology = topologyOf(*state, context);
  LayerSubdivision subdivision(state->kernel.get(), *state->mesh, *topology, context);
  std::shared_ptr<WalkableMesh> mesh;
  std::vector<std::uint32_t> layers;
  const bool isOwn = (recall.isLast || state != given) && !recall.keep;
  parallelInvoke([&] { layers = subdivision.run(recall); },
                 [&] {
                   if (!isOwn) mesh = std::make_shared<WalkableMesh>(*state->mesh);
                   if (recall.meanwhile) recall.meanwhile(*state, *topology);
                 });
  if (isOwn) mesh = ownMeshOf(*state);
  mesh->layers = std::move(layers);
  mesh->layerCount = 0;
  for (const std::uint32_t l : mesh->layers) mesh->layerCount = std::max(mesh->layerCount, l + 1);
  outcome.fallbacks += subdivision.fallbacks();

  outcome.note = Text(
      Pattern{"%1, %2"}, countedText(mesh->layerCount, FOOTFALL_TEXT("1 layer"), FOOTFALL_TEXT("%1 layers")),
      countedText(countConnections(*mesh, *topology), FOOTFALL_TEXT("1 connection"), FOOTFALL_TEXT("%1 connections")));
  auto result = std::make_shared<WalkableState>(*state);
  result->topology = topology;
  result->topologyOwner = mesh;
  result->mesh = std::move(mesh);
  result->overlaps = recall.keep ? subdivision.takeOverlaps() : nullptr;
  outcome.state = std::move(result);
  return outcome;
}

}  // namespace footfall::detail
