// LayerSubdivisionFilter (the thesis's PEELFilter): splits the walkable triangles into layers that do not overlap in
// the plan, with few connections (model, Layers, thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region that lies nowhere above itself is one piece; others are divided (layer_pieces.hpp). The pieces are then put
// into as few layers as a greedy pass finds. Outlines decide which regions lie above themselves (double_cover.hpp), and
// triangles are looked up among those of a piece (piece_conflicts.hpp) or of the pieces of a layer (layer_cover.hpp).
// An earlier run that left its layers and the overlaps that it met makes most of that known already
// (known_overlaps.hpp). The result is the same.

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/lexicographic_order.hpp"
#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/layers/known_overlaps.hpp"
#include "core/filters/layers/layer_cover.hpp"
#include "core/filters/layers/layer_pieces.hpp"
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
  /// `kernel` may be null for runWith().
  LayerSubdivision(const PlanKernel* kernel, const WalkableMesh& mesh, const Adjacency& topology, RunContext& context)
      : kernel_(kernel),
        mesh_(mesh),
        topology_(topology),
        context_(context),
        count_(static_cast<Index>(mesh.triangles.size())) {}

  std::vector<std::uint32_t> run(const StatePtr& before) {
    parallelInvoke(
        [&] {
          plan_.emplace(mesh_, context_);
          known_ = knownFrom(before, *kernel_, mesh_, *plan_, context_, fallbacks_);
        },
        [&] {
          region_ = findRegions(mesh_, topology_, regionCount_);
          findLowest();
        });
    input_.kernel = kernel_;
    input_.vertices = &mesh_.vertices;
    input_.plan = &*plan_;
    return divide();
  }

  std::vector<std::uint32_t> runWith(std::vector<Pair> overlaps) {
    known_.pairs = std::move(overlaps);
    known_.isAll = true;
    region_ = findRegions(mesh_, topology_, regionCount_);
    findLowest();
    return divide();
  }

  /// The overlaps that it met, for the next run. Call it once.
  std::shared_ptr<const std::vector<Pair>> takeOverlaps() {
    std::vector<Pair>& pairs = known_.pairs;
    // Pairs of earlier runs that have become many are found again where they are needed.
    if (pairs.size() > kMostPairs + kMostPairsOfTriangle * static_cast<std::size_t>(count_))
      pairs.erase(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(pairsBefore_));
    for (Pair& pair : pairs) std::sort(pair.begin(), pair.end());
    sortOnce(pairs);
    return std::make_shared<const std::vector<Pair>>(std::move(pairs));
  }

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  std::vector<std::uint32_t> divide() {
    context_.checkCancelled();
    pairsBefore_ = known_.pairs.size();
    input_.knowsAll = known_.isAll;
    subdivideRegions();
    context_.progress(kShareOfPieces);
    return placePieces();
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

  // Numbers all pieces by the height of the triangles from which they grew.
  void subdivideRegions() {
    const std::vector<char> divided =
        findRegionsAboveThemselves(region_, regionCount_, known_, kernel_, mesh_, topology_, context_, fallbacks_);
    std::vector<Pair> within;
    for (const Pair& pair : known_.pairs)
      if (region_[pair[0]] == region_[pair[1]]) within.push_back(pair);
    input_.group = std::move(known_.group);
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
      seeds[regions[i]] = subdivideRegion(input_, own, ownRanks, piece_, context_, counts[i]);
    });
    context_.checkCancelled();
    for (const SearchCounts& own : counts) {
      fallbacks_ += own.fallbacks;
      known_.pairs.insert(known_.pairs.end(), own.found.begin(), own.found.end());
    }
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
  std::vector<std::uint32_t> placePieces() {
    std::vector<Index> first(pieceCount_ + 1, 0), triangles(count_);
    for (const Index p : piece_) ++first[p + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Index> next(first.begin(), first.end() - 1);
    for (Index t = 0; t < count_; ++t) triangles[next[piece_[t]]++] = t;
    std::vector<Pair> above, beside;
    for (const auto& [s, t] : known_.pairs)
      if (piece_[s] != piece_[t]) above.push_back({piece_[s], piece_[t]});
    for (Index t = 0; t < count_; ++t)
      for (const Index n : input_.neighbors[t])
        if (n < t && piece_[n] != piece_[t]) beside.push_back({piece_[t], piece_[n]});
    const IndexLists conflicts = listsOf(above, pieceCount_);
    const IndexLists shared = listsOf(beside, pieceCount_);

    std::vector<std::span<const Index>> pieces;
    for (Index p = 0; p < pieceCount_; ++p)
      pieces.emplace_back(triangles.data() + first[p], static_cast<std::size_t>(first[p + 1] - first[p]));
    LayerCover cover(input_, pieces, conflicts, context_);
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
    known_.pairs.insert(known_.pairs.end(), cover.found().begin(), cover.found().end());
    return layers;
  }

  static constexpr double kShareOfPieces = 0.5;  // of the time, at a guess
  static constexpr std::size_t kMostPairs = std::size_t{1} << 12;
  static constexpr std::size_t kMostPairsOfTriangle = 4;

  const PlanKernel* kernel_;
  const WalkableMesh& mesh_;
  const Adjacency& topology_;
  RunContext& context_;
  Index count_;
  KnownOverlaps known_;
  std::optional<PlanTriangles> plan_;
  std::size_t pairsBefore_ = 0;  ///< number of pairs of earlier runs, which come first
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
  parallelInvoke([&] { layers = subdivision.run(recall.before); },
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
