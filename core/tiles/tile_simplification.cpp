// SPDX-License-Identifier: GPL-3.0-or-later
//
// The simplification of a group of triangles (simplifier.hpp) depends on the group alone, and the groups on the
// triangles at their corners. So each tile is processed with the triangles that touch it. Groups within it are
// finished. The others have triangles beyond the border, which identify the groups of other tiles that they are parts
// of. Such groups are then put together from all their tiles, as many at once as the memory holds.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/background_release.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/filters/simplification/simplifier.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "core/tiles/border_names.hpp"
#include "core/tiles/tile_geometry.hpp"
#include "core/tiles/tile_stage.hpp"

namespace footfall::detail {
namespace {

using Changed = TileUnion::Changed;

/// The triangles and groups after simplifying.
SimplifierMemory simplified(const TileUnion& made, RunContext& context) {
  const Adjacency topology = findEdges(made.mesh().triangles, made.mesh().vertices.size(), Poll(context));
  SimplifierMemory memory;
  Simplifier(made.kernel(), made.mesh(), topology, {}, context).run(&memory);
  return memory;
}

/// The triangles of a tile that share a vertex with chosen ones: by number when these are of the same tile, else by the
/// names of their vertices.
std::vector<char> trianglesAround(const Tile& tile, const std::vector<char>& chosen, const BorderNames& names) {
  std::vector<char> isNear(tile.places.size(), 0), found(tile.triangles.size(), 0);
  for (const TileBorder& border : tile.borders)
    if (names.contains(tile.places[border.vertex], border)) isNear[border.vertex] = 1;
  for (std::size_t t = 0; t < chosen.size(); ++t)
    if (chosen[t] != 0)
      for (const Index v : tile.triangles[t].corners) isNear[v] = 1;
  for (std::size_t t = 0; t < found.size(); ++t)
    for (const Index v : tile.triangles[t].corners) found[t] = static_cast<char>(found[t] != 0 || isNear[v] != 0);
  return found;
}

/// One flag per chosen vertex of a tile: it is an end of a link.
std::vector<char> linkedOf(const Tile& tile, const std::vector<Index>& numbers, std::size_t count) {
  std::vector<char> isLinked(tile.links.empty() ? 0 : count, 0);
  for (const TileLink& link : tile.links)
    for (const Index v : {link.from[0], link.from[1], link.to[0], link.to[1]})
      if (static_cast<std::size_t>(v) < numbers.size() && numbers[v] >= 0) isLinked[numbers[v]] = 1;
  return isLinked;
}

/// A part with those triangles of a tile of which `found` is not 0; of them the chosen ones are its own.
TileUnion::Part partOf(std::size_t number, const Tile& tile, const std::vector<char>& found,
                       const std::vector<char>& chosen) {
  std::vector<Index> numbers;
  TileUnion::Part part{number, chosenTriangles(tile, found, &numbers)};
  part.isLinked = linkedOf(tile, numbers, part.triangles.places.size());
  for (std::size_t t = 0; t < found.size(); ++t) {
    if (found[t] == 0) continue;
    part.numbers.push_back(static_cast<Index>(t));
    part.isOwn.push_back(static_cast<char>(!chosen.empty() && chosen[t] != 0));
  }
  return part;
}

class TileSimplification {
 public:
  TileSimplification(TileStage& stage, RunContext& context)
      : stage_(stage), context_(context), given_(std::move(stage.tiles)), partsOf_(given_.size()) {
    stage.tiles.clear();
  }

  void run() {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      context_.checkCancelled();
      simplifyWithin(i);
      returnFreedMemory();
      context_.progress(0.5 * static_cast<double>(i + 1) / static_cast<double>(given_.size()));
    }
    simplifyOverBorders();
    for (const StoredTile& tile : given_) stage_.store.replace(tile.number, {});
  }

 private:
  /// A part of a group, in one tile.
  struct GroupPart {
    std::uint64_t triangles = 0;
  };
  using PartTriangle = std::pair<Index, Index>;  ///< a triangle of a tile, and its part
  /// A part of a group has a triangle of another tile beside it, which is a part of the same group there.
  struct Beside {
    Index part = -1;
    std::size_t tile = 0;
    Index triangle = -1;
  };

  // The bytes of all data about groups and links, beside the triangles.
  [[nodiscard]] std::uint64_t bytesKnown() const {
    return groupParts_.size() * sizeof(GroupPart) + partTriangles_ * sizeof(PartTriangle) +
           beside_.size() * sizeof(Beside) + links_.size() * sizeof(NamedLink);
  }
  void addPart(TileUnion::Part part, std::vector<TileUnion::Part>& parts) const {
    parts.push_back(std::move(part));
    std::uint64_t count = 0;
    for (const TileUnion::Part& each : parts) count += each.triangles.triangles.size();
    const std::uint64_t bytes = count * kOfUnionTriangle + bytesKnown();
    stage_.require(bytes, bytes + bytes / 4);  // other parts may follow
  }
  [[nodiscard]] TileUnion unionOf(std::vector<TileUnion::Part> parts) const {
    return {std::move(parts), stage_.grid, context_};
  }

  void simplifyWithin(std::size_t i) {
    std::vector<TileUnion::Part> parts;
    BorderNames names;
    {
      Tile tile = stage_.store.read(given_[i].number);
      for (const TileBorder& border : tile.borders)
        names.numberOf(tile.places[border.vertex], border, static_cast<Index>(names.size()));
      std::vector<Index> numbers(tile.places.size());
      std::iota(numbers.begin(), numbers.end(), 0);
      std::vector<char> isLinked = linkedOf(tile, numbers, numbers.size());
      addPart({i, std::move(tile), {}, {}, std::move(isLinked)}, parts);
    }
    for (std::size_t j = 0; j < given_.size(); ++j) {
      if (j == i || !touch(given_[i].box, given_[j].box)) continue;
      const Tile tile = stage_.store.read(given_[j].number);
      addPart(partOf(j, tile, trianglesAround(tile, {}, names), {}), parts);
    }
    const TileUnion made = unionOf(std::move(parts));
    const SimplifierMemory memory = simplified(made, context_);
    keepWithin(i, made, memory);
  }

  // The vertices that other tiles have as well: those of triangles that are not its own, and ends of links.
  [[nodiscard]] static std::vector<char> namedOf(const TileUnion& made) {
    std::vector<char> isNamed(made.mesh().vertices.size(), 0);
    for (Index t = 0; t < static_cast<Index>(made.mesh().triangles.size()); ++t)
      if (!made.isOwn(t))
        for (const Index v : made.mesh().triangles[t].corners) isNamed[v] = 1;
    for (const MeshLink& link : made.mesh().links) isNamed[link.from[0]] = 1;
    return isNamed;
  }

  // Stores what is done with, and takes down what is not.
  void keepWithin(std::size_t i, const TileUnion& made, const SimplifierMemory& memory) {
    const auto count = static_cast<Index>(made.mesh().triangles.size());
    std::vector<char> isOver(static_cast<std::size_t>(count), 0);  // groups that lie over the border
    for (Index t = 0; t < count; ++t)
      if (!made.isOwn(t) && memory.groupOf[t] >= 0) isOver[memory.groupOf[t]] = 1;
    std::vector<Changed> kept;
    std::vector<char> isNamed = namedOf(made);
    std::map<Index, Index> partOfGroup;
    for (Index t = 0; t < count; ++t) {
      if (!made.isOwn(t)) continue;
      const Index group = memory.groupOf[t];
      if (group < 0 || isOver[group] == 0) {
        if (memory.alive[t] != 0) kept.push_back({t, memory.triangles[t]});
        continue;
      }
      for (const Index v : made.mesh().triangles[t].corners) isNamed[v] = 1;
      const auto [part, isNew] = partOfGroup.try_emplace(group, static_cast<Index>(groupParts_.size()));
      if (isNew) groupParts_.emplace_back();
      ++groupParts_[part->second].triangles;
      partsOf_[i].emplace_back(made.numberInTile(t), part->second);
    }
    std::sort(partsOf_[i].begin(), partsOf_[i].end());
    partTriangles_ += partsOf_[i].size();
    for (Index t = 0; t < count; ++t)
      if (const auto part = partOfGroup.find(memory.groupOf[t]); !made.isOwn(t) && part != partOfGroup.end())
        beside_.push_back({part->second, made.partOf(t).tile, made.numberInTile(t)});
    collectLinks(made);
    addWithLinks(made.tileOf(kept, isNamed));
  }

  // Links of the first part, by the names of their ends: whichever tile has them then.
  void collectLinks(const TileUnion& made) {
    const Tile& tile = made.firstPart();
    const auto own = static_cast<Index>(tile.places.size());
    for (const TileLink& link : tile.links) {
      NamedLink& named = links_.emplace_back();
      named.link = link;
      const std::array ends{link.from[0], link.from[1], link.to[0], link.to[1]};
      for (std::size_t k = 0; k < 4; ++k)
        named.ends[k] = ends[k] < own ? made.outsideOf(made.vertexOfPart(0, ends[k])) : tile.outside[ends[k] - own];
    }
  }

  void addWithLinks(Tile tile) {
    if (tile.triangles.empty()) return;  // there is a tile behind it that has these triangles
    for (NamedLink& named : links_) {
      const auto first = static_cast<Index>(tile.places.size() + tile.outside.size());
      for (TileOutside& end : named.ends) tile.outside.push_back(std::move(end));
      named.link.from = {first, first + 1};
      named.link.to = {first + 2, first + 3};
      tile.links.push_back(named.link);
    }
    links_.clear();
    stage_.add(tile, stage_.tiles);
  }

  // The first part of the whole group, of each part.
  [[nodiscard]] std::vector<Index> uniteParts() {
    DisjointSets sets(groupParts_.size());
    for (const Beside& beside : beside_) {
      const auto& parts = partsOf_[beside.tile];
      const auto found = std::lower_bound(parts.begin(), parts.end(), std::pair(beside.triangle, Index{0}));
      if (found != parts.end() && found->first == beside.triangle) sets.unite(beside.part, found->second);
    }
    beside_ = {};
    std::vector<Index> groupOf;
    for (Index p = 0; p < static_cast<Index>(groupParts_.size()); ++p) groupOf.push_back(sets.find(p));
    return groupOf;
  }

  void simplifyOverBorders() {
    const std::vector<Index> groupOf = uniteParts();
    std::vector<std::uint64_t> sizes(groupOf.size(), 0);
    for (std::size_t p = 0; p < groupOf.size(); ++p) sizes[groupOf[p]] += groupParts_[p].triangles;
    // Includes the triangles around them.
    const std::uint64_t largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
    stage_.require(2 * largest * kOfUnionTriangle + bytesKnown());
    const std::uint64_t most = (stage_.memory - bytesKnown()) / kOfUnionTriangle / 2;
    std::vector<Index> batchOf(groupOf.size(), -1);
    Index batches = 0;
    std::uint64_t size = most;
    for (std::size_t g = 0; g < sizes.size(); ++g) {
      if (sizes[g] == 0) continue;
      if (size + sizes[g] > most) {
        size = 0;
        ++batches;
      }
      size += sizes[g];
      batchOf[g] = batches - 1;
    }
    for (std::size_t p = 0; p < groupOf.size(); ++p) batchOf[p] = batchOf[groupOf[p]];
    for (Index batch = 0; batch < batches; ++batch) {
      context_.checkCancelled();
      simplifyBatch(batchOf, batch);
      returnFreedMemory();
      context_.progress(0.5 + 0.5 * static_cast<double>(batch + 1) / static_cast<double>(batches));
    }
  }

  /// One flag per triangle of a tile: it is in the batch; empty when none is.
  [[nodiscard]] std::vector<char> chosenOf(std::size_t i, const std::vector<Index>& batchOf, Index batch) const {
    std::vector<char> chosen;
    for (const auto& [triangle, part] : partsOf_[i]) {
      if (batchOf[part] != batch) continue;
      if (chosen.empty()) chosen.assign(given_[i].triangles, 0);
      chosen[triangle] = 1;
    }
    return chosen;
  }

  void simplifyBatch(const std::vector<Index>& batchOf, Index batch) {
    BorderNames names;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      const std::vector<char> chosen = chosenOf(i, batchOf, batch);
      if (chosen.empty()) continue;
      const Tile tile = chosenTriangles(stage_.store.read(given_[i].number), chosen);
      for (const TileBorder& border : tile.borders)
        names.numberOf(tile.places[border.vertex], border, static_cast<Index>(names.size()));
      boxes.push_back(boxAround(tile.places));
    }
    std::vector<TileUnion::Part> parts;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (std::none_of(boxes.begin(), boxes.end(), [&](const Box& box) { return touch(box, given_[i].box); })) continue;
      const Tile tile = stage_.store.read(given_[i].number);
      const std::vector<char> chosen = chosenOf(i, batchOf, batch);
      addPart(partOf(i, tile, trianglesAround(tile, chosen, names), chosen), parts);
    }
    const TileUnion made = unionOf(std::move(parts));
    const SimplifierMemory memory = simplified(made, context_);
    std::vector<Changed> kept;
    for (Index t = 0; t < static_cast<Index>(made.mesh().triangles.size()); ++t)
      if (made.isOwn(t) && memory.alive[t] != 0) kept.push_back({t, memory.triangles[t]});
    addWithLinks(made.tileOf(kept, namedOf(made)));
  }

  /// A link with the names of its ends.
  struct NamedLink {
    TileLink link;
    std::array<TileOutside, 4> ends;
  };

  TileStage& stage_;
  RunContext& context_;
  std::vector<StoredTile> given_;
  std::vector<GroupPart> groupParts_;
  std::vector<std::vector<PartTriangle>> partsOf_;  ///< parts of each tile; ascending
  std::uint64_t partTriangles_ = 0;                 ///< number of triangles in all of these
  std::vector<Beside> beside_;
  std::vector<NamedLink> links_;  ///< links that no tile has yet
};

}  // namespace

void simplifyTiles(TileStage& stage, RunContext& context) { TileSimplification(stage, context).run(); }

}  // namespace footfall::detail
