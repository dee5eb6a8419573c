// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_join.hpp"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "core/base/sorted_list.hpp"
#include "core/filters/rounding/placed_mesh.hpp"
#include "core/tiles/border_names.hpp"

namespace footfall::detail {
namespace {

/// A face of some tile, with the place of its triangles among all that were added.
struct AddedFace {
  TileFace face;
  std::size_t firstTriangle = 0;
};

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }

// The order of SourceMesh::triangles: its vertices are in the order of their coordinates.
bool comesBefore(const AddedFace& a, const AddedFace& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (const Place p = placeOf(a.face.corners[k]), q = placeOf(b.face.corners[k]); p != q) return p < q;
  return a.face.source < b.face.source;
}

}  // namespace

struct TileJoiner::State {
 public:
  void add(const Tile& tile, const Poll& poll) {
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<Index>::max()) / 3;
    if (tile.triangles.size() > kMost - triangles_.size())
      throw RunError(
          FOOTFALL_TEXT("the tiles have more than %1 triangles together, which is more than one file can have; use "
                        "them one by one"),
          kMost);
    std::vector<Index> numbers = numberVertices(tile, poll);
    std::size_t first = triangles_.size();
    for (const TileFace& face : tile.faces) {
      faces_.push_back({face, first});
      first += face.triangles;
    }
    for (MeshTriangle triangle : tile.triangles) {
      for (Index& v : triangle.corners) v = numbers[v];
      triangles_.push_back(triangle);
    }
    addLinks(tile, numbers, poll);
  }

  // Triangles in the order of their faces; vertices in the order of their first use.
  PlacedMesh joined(RunContext& context) {
    borders_ = {};
    tbb::parallel_sort(faces_.begin(), faces_.end(), comesBefore);
    context.checkCancelled();
    PlacedMesh mesh;
    mesh.triangles.reserve(triangles_.size());
    mesh.sources.reserve(faces_.size());
    std::vector<Index> numbers(places_.size(), -1);
    for (const AddedFace& added : faces_) {
      if (mesh.sources.size() % 4096 == 0) context.checkCancelled();
      for (std::size_t i = 0; i < added.face.triangles; ++i) {
        MeshTriangle triangle = triangles_[added.firstTriangle + i];
        triangle.face = static_cast<Index>(mesh.sources.size());
        for (Index& v : triangle.corners) {
          if (numbers[v] < 0) {
            numbers[v] = static_cast<Index>(mesh.places.size());
            mesh.places.push_back(places_[v]);
            mesh.exact.push_back(exact_[v]);
          }
          v = numbers[v];
        }
        mesh.triangles.push_back(triangle);
      }
      mesh.sources.push_back(added.face.source);
    }
    for (MeshLink link : links_) {
      for (std::array<Index, 2>* edge : {&link.from, &link.to})
        for (Index& v : *edge) v = numbers[v];
      const auto isThere = [](const std::array<Index, 2>& edge) { return edge[0] >= 0 && edge[1] >= 0; };
      if (isThere(link.from) && isThere(link.to)) mesh.links.push_back(link);
    }
    sortOnce(mesh.links);
    return mesh;
  }

 private:
  // Numbers are below those of the vertices of the tile and outside.
  void addLinks(const Tile& tile, std::vector<Index>& numbers, const Poll& poll) {
    for (const TileOutside& vertex : tile.outside) {
      poll();
      const auto next = static_cast<Index>(places_.size());
      numbers.push_back(borders_.numberOf(vertex, next));
      if (numbers.back() != next) continue;
      places_.push_back(vertex.place);
      exact_.push_back(static_cast<char>(vertex.exact.empty()));
    }
    for (const TileLink& link : tile.links) {
      const auto numbered = [&](const std::array<Index, 2>& edge) {
        return std::array{numbers[edge[0]], numbers[edge[1]]};
      };
      links_.push_back({numbered(link.from), numbered(link.to), link.isGap});
    }
  }

  std::vector<Index> numberVertices(const Tile& tile, const Poll& poll) {
    std::vector<Index> numbers(tile.places.size());
    auto border = tile.borders.begin();
    for (std::size_t v = 0; v < numbers.size(); ++v) {
      if (v % 32768 == 0) poll();
      const auto next = static_cast<Index>(places_.size());
      numbers[v] = next;
      if (border != tile.borders.end() && static_cast<std::size_t>(border->vertex) == v) {
        numbers[v] = borders_.numberOf(tile.places[v], *border, next);
        ++border;
      }
      if (numbers[v] != next) continue;
      places_.push_back(tile.places[v]);
      exact_.push_back(tile.exact[v]);
    }
    return numbers;
  }

  std::vector<AddedFace> faces_;
  std::vector<MeshTriangle> triangles_;
  std::vector<Vec3> places_;
  std::vector<char> exact_;
  std::vector<MeshLink> links_;
  BorderNames borders_;
};

TileJoiner::TileJoiner() : state_(std::make_unique<State>()) {}
TileJoiner::~TileJoiner() = default;

void TileJoiner::add(const Tile& tile, const Poll& poll) { state_->add(tile, poll); }

std::shared_ptr<NavigationMesh> TileJoiner::join(RunContext& context) {
  const PlacedMesh mesh = state_->joined(context);
  state_ = nullptr;
  return makeNavigationMesh(mesh, context);
}

namespace {

// Each slice once, all of one environment and pipeline.
void checkSlices(std::span<const std::string> folders, const std::vector<TileSet>& sets) {
  const TileSet& first = sets.front();
  std::vector<char> isThere(sets.size(), 0);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const TileSet& set = sets[i];
    if (set.environment != first.environment || set.pipeline != first.pipeline || set.bothSides != first.bothSides ||
        set.slice.count != first.slice.count || set.frame.up != first.frame.up ||
        set.frame.metresPerUnit != first.frame.metresPerUnit)
      throw InputError(
          FOOTFALL_TEXT("%1 and %2 are tiles of different environments, pipelines or slices; give folders of one "
                        "run"),
          folders.front(), folders[i]);
    if (set.slice.number > sets.size() || std::exchange(isThere[set.slice.number - 1], 1) != 0 ||
        set.slice.count != sets.size())
      throw InputError(
          FOOTFALL_TEXT("%1 is slice %2 of %3, and the folders given are not all of them, each once; give all"),
          folders[i], set.slice.number, set.slice.count);
  }
}

}  // namespace

JoinedTiles joinTiles(std::span<const std::string> folders, RunContext& context) {
  JoinedTiles joined;
  std::size_t tiles = 0, added = 0;
  for (const std::string& folder : folders) {
    joined.sets.push_back(readTileIndex(folder, &context));
    tiles += joined.sets.back().tiles.size();
  }
  checkSlices(folders, joined.sets);
  TileJoiner joiner;
  for (std::size_t i = 0; i < folders.size(); ++i)
    for (const TileEntry& entry : joined.sets[i].tiles) {
      context.checkCancelled();
      joiner.add(readTile(folders[i], entry, &context), context);
      context.progress(0.5 * static_cast<double>(++added) / static_cast<double>(tiles));
    }
  const std::shared_ptr<NavigationMesh> mesh = joiner.join(context);
  mesh->frame = joined.sets.front().frame;
  joined.mesh = mesh;
  return joined;
}

}  // namespace footfall::detail
