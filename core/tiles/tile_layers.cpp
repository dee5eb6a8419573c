// SPDX-License-Identifier: GPL-3.0-or-later
//
// Overlapping triangles are found tile by tile, and for each two tiles that overlap in the plan. The steps that go from
// triangle to triangle over the whole, growing pieces and choosing their layers, need no exact values: only corners by
// number, one height for each triangle, and the pairs. All of these are in memory at once.

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/background_release.hpp"
#include "core/base/box_tree.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/layers/double_cover.hpp"
#include "core/filters/layers/known_overlaps.hpp"
#include "core/filters/layers/plan_triangles.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "core/tiles/tile_gathering.hpp"
#include "core/tiles/tile_geometry.hpp"
#include "core/tiles/tile_stage.hpp"

namespace footfall::detail {
namespace {

using Pair = std::array<Index, 2>;
using Tree = BoxTree<2>;

constexpr Index kPerTask = 256;

/// All pairs that overlap in the plan, of one of some triangles and one of `others`. Pairs of one sheet, from 0 on, do
/// not; where `own` and `others` are the same, each pair is found once. Empty where there are more than `most`.
std::optional<std::vector<Pair>> overlapsBetween(const TileUnion& made, const std::vector<Index>& own,
                                                 const std::vector<Index>& others, const std::vector<Index>& sheets,
                                                 std::uint64_t most, RunContext& context) {
  const WalkableMesh& mesh = made.mesh();
  const bool isOnce = &own == &others;
  const auto planOf = [&mesh](Index t) { return planTriangleOf(mesh.vertices, mesh.triangles[t]); };
  Tree tree;
  tree.build(
      others, [&](Index t) { return planBoundsOf(planOf(t)); }, context);
  struct Local {
    MeshGeometry geometry;
    std::vector<Pair> found;
  };
  PerThread<Local> locals([&] { return Local{MeshGeometry(made.kernel(), mesh.vertices), {}}; });
  std::atomic<std::uint64_t> count = 0;
  parallelRanges(own.size(), kPerTask, [&](const auto& range) {
    Local& local = locals.local();
    for (std::size_t i = range.begin(); i != range.end() && count <= most; ++i) {
      context.checkCancelled();
      const Index t = own[i];
      const PlanTriangle plan = planOf(t);
      tree.visitOverlapping(planBoundsOf(plan), [&](Index o) {
        if (isOnce && (o <= t || (sheets[t] >= 0 && sheets[t] == sheets[o]))) return;
        if (!local.geometry.overlap(plan, planOf(o)) || ++count > most) return;
        local.found.push_back({t, o});
      });
    }
  });
  if (count > most) return std::nullopt;
  std::vector<Pair> pairs;
  for (const Local& local : locals) pairs.insert(pairs.end(), local.found.begin(), local.found.end());
  return pairs;
}

/// The triangles of a tile that may lie in a box in the plan.
TileUnion::Part partWithin(std::size_t number, const Tile& tile, const Box& box) {
  std::vector<char> found(tile.triangles.size());
  TileUnion::Part part;
  for (std::size_t t = 0; t < found.size(); ++t) {
    const auto& [a, b, c] = tile.triangles[t].corners;
    const std::array<Vec3, 3> places{tile.places[a], tile.places[b], tile.places[c]};
    found[t] = static_cast<char>(touchInPlan(boxAround(places), box));
    if (found[t] != 0) part.numbers.push_back(static_cast<Index>(t));
  }
  part.tile = number;
  part.triangles = chosenTriangles(tile, found);
  return part;
}

class TileLayers {
 public:
  TileLayers(TileStage& stage, RunContext& context) : stage_(stage), context_(context), first_{0} {
    for (const StoredTile& tile : stage.tiles) first_.push_back(first_.back() + tile.triangles);
  }

  void run() {
    checkNumbers();
    isCounting_ = bytesWith(0) > stage_.memory;
    findOverlaps();
    if (isCounting_) stage_.failTooLittle(bytesWith(pairCount_));
    TileGathering::Whole whole = gather();
    const std::vector<std::uint32_t> layers = layersOf(std::move(whole));
    for (std::size_t i = 0; i < stage_.tiles.size(); ++i) {
      context_.checkCancelled();
      Tile tile = stage_.store.read(stage_.tiles[i].number);
      const auto at = [&](std::size_t tileNumber) {
        return layers.begin() + static_cast<std::ptrdiff_t>(first_[tileNumber]);
      };
      tile.layers.assign(at(i), at(i + 1));
      stage_.store.replace(stage_.tiles[i].number, tile);
    }
  }

 private:
  void checkNumbers() const {
    constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<Index>::max());
    if (first_.back() > kMost / 3 || pairCount_ > kMost / 2)
      throw RunError(
          FOOTFALL_TEXT("the walkable area has more triangles than LayerSubdivisionFilter can number; leave "
                        "it out"));
  }

  [[nodiscard]] std::uint64_t bytesWith(std::uint64_t pairs) const {
    return first_.back() * kOfLayerTriangle + pairs * kOfLayerPair;
  }

  /// The number of pairs of all tiles, at a guess: in proportion to the triangles of the tiles that are done, and a
  /// quarter more, since places differ.
  [[nodiscard]] std::uint64_t expectedPairs() const {
    const std::uint64_t done = first_[begun_];
    if (done == 0) return first_.back() * kUsualPairs;
    const double perTriangle = static_cast<double>(pairCount_) / static_cast<double>(done);
    return static_cast<std::uint64_t>(1.25 * perTriangle * static_cast<double>(first_.back()));
  }

  // Pairs that have no room are counted to the end all the same, so that the message names what is enough.
  void addPairs(const TileUnion& made, const std::vector<Pair>& found) {
    pairCount_ += found.size();
    checkNumbers();
    if (!isCounting_ && bytesWith(pairCount_) > stage_.memory) {
      isCounting_ = true;
      pairs_ = {};
    }
    if (isCounting_) return;
    const auto numberOf = [&](Index t) {
      return static_cast<Index>(first_[made.partOf(t).tile]) + made.numberInTile(t);
    };
    for (const auto& [s, t] : found) pairs_.push_back({numberOf(s), numberOf(t)});
  }

  void findOverlaps() {
    const std::vector<StoredTile>& tiles = stage_.tiles;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const Tile tile = stage_.store.read(tiles[i].number);
      begun_ = i + 1;
      for (std::size_t j = i + 1; j < tiles.size(); ++j) {
        context_.checkCancelled();
        if (!touchInPlan(tiles[i].box, tiles[j].box)) continue;
        std::vector<TileUnion::Part> parts;
        parts.push_back(partWithin(i, tile, tiles[j].box));
        parts.push_back(partWithin(j, stage_.store.read(tiles[j].number), tiles[i].box));
        const TileUnion made = unionOf(std::move(parts));
        std::vector<Index> own, others;
        for (Index t = 0; t < static_cast<Index>(made.mesh().triangles.size()); ++t)
          (made.partOf(t).tile == i ? own : others).push_back(t);
        const auto found = overlapsBetween(made, own, others, {}, stage_.memory / kOfLayerPair, context_);
        if (!found) stage_.failTooLittle(2 * stage_.memory);
        addPairs(made, *found);
      }
      findOverlapsWithin(i, tile);
      returnFreedMemory();
      context_.progress(0.9 * static_cast<double>(i + 1) / static_cast<double>(tiles.size()));
    }
  }

  void findOverlapsWithin(std::size_t i, const Tile& tile) {
    std::vector<TileUnion::Part> parts;
    parts.push_back({i, tile});
    const TileUnion made = unionOf(std::move(parts));
    const Adjacency topology = findEdges(made.mesh().triangles, made.mesh().vertices.size(), Poll(context_));
    ExactFallbacks fallbacks;
    const std::vector<Index> sheets = findFlatSheets(findTrianglesAcross(made.mesh(), topology, context_),
                                                     made.kernel(), made.mesh(), context_, fallbacks);
    std::vector<Index> all(sheets.size());
    std::iota(all.begin(), all.end(), Index{0});
    const auto found = overlapsBetween(made, all, all, sheets, stage_.memory / kOfLayerPair, context_);
    if (!found) stage_.failTooLittle(2 * stage_.memory);
    addPairs(made, *found);
  }

  [[nodiscard]] TileUnion unionOf(std::vector<TileUnion::Part> parts) const {
    std::uint64_t count = 0;
    for (const TileUnion::Part& part : parts) count += part.triangles.triangles.size();
    stage_.require(count * kOfUnionTriangle + pairs_.size() * sizeof(Pair), bytesWith(expectedPairs()));
    return {std::move(parts), stage_.grid, context_};
  }

  // The order of all triangles, and which of them were added as which.
  TileGathering::Whole gather() {
    TileGathering gathering;
    for (const StoredTile& tile : stage_.tiles) gathering.add(stage_.store.read(tile.number), context_);
    return gathering.take(context_);
  }

  // One layer per triangle, in the order of addition.
  std::vector<std::uint32_t> layersOf(TileGathering::Whole whole) {
    WalkableMesh mesh;
    mesh.triangles = std::move(whole.mesh.triangles);
    mesh.vertices.resize(whole.heights.size());
    for (std::size_t v = 0; v < whole.heights.size(); ++v) mesh.vertices[v].z = whole.heights[v];
    mesh.links = std::move(whole.mesh.links);
    whole.mesh = {};
    std::vector<Index> placeOf(whole.addedAs.size());
    for (std::size_t t = 0; t < placeOf.size(); ++t) placeOf[whole.addedAs[t]] = static_cast<Index>(t);
    for (Pair& pair : pairs_) pair = {placeOf[pair[0]], placeOf[pair[1]]};
    const Adjacency topology = findEdges(mesh.triangles, mesh.vertices.size(), Poll(context_));
    mesh.links = linksBetween(mesh.links, mesh.triangles, topology);
    const std::vector<std::uint32_t> found = detail::layersOf(mesh, topology, std::move(pairs_), context_);
    std::vector<std::uint32_t> layers(found.size());
    for (std::size_t t = 0; t < found.size(); ++t) layers[whole.addedAs[t]] = found[t];
    return layers;
  }

  TileStage& stage_;
  RunContext& context_;
  std::vector<std::uint64_t> first_;  ///< number of triangles before each tile; then of all
  std::size_t begun_ = 0;             ///< number of tiles whose pairs are listed, the one at work included
  std::vector<Pair> pairs_;           ///< numbers of triangles as tiles have them one behind the other
  std::uint64_t pairCount_ = 0;       ///< all that were found
  bool isCounting_ = false;           ///< there is no room for the pairs
};

}  // namespace

void layTiles(TileStage& stage, RunContext& context) { TileLayers(stage, context).run(); }

}  // namespace footfall::detail
