// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_gathering.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/sorted_list.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

/// Adds to a list that has one entry for each of so many triangles, or none.
template <class Entry>
void append(std::vector<Entry>& all, const std::vector<Entry>& added, std::size_t before, std::size_t count) {
  if (all.empty() && added.empty()) return;
  all.resize(before);
  all.insert(all.end(), added.begin(), added.end());
  all.resize(before + count);
}

}  // namespace

void TileGathering::add(const Tile& tile, const Poll& poll) {
  constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<Index>::max()) / 3;
  const std::size_t before = triangles_.size(), count = tile.triangles.size();
  if (count > kMost - before)
    throw RunError(
        FOOTFALL_TEXT("the tiles have more than %1 triangles together, which is more than one file can have; use "
                      "them one by one"),
        kMost);
  if (before > 0 && count > 0 && layers_.empty() != tile.layers.empty()) throw BadBytes("is damaged");
  std::vector<Index> numbers = numberVertices(tile, poll);
  std::size_t first = before;
  for (const TileFace& face : tile.faces) {
    if (face.triangles > 0) faces_.push_back({face, first});
    first += face.triangles;
  }
  for (std::size_t t = 0; t < count; ++t) {
    MeshTriangle triangle = tile.triangles[t];
    for (Index& v : triangle.corners) v = numbers[v];
    triangle.face = static_cast<Index>(tile.faces[tile.pieces.empty() ? triangle.face : tile.pieces[t].plane].source);
    triangles_.push_back(triangle);
  }
  std::vector<std::uint32_t> pieces;
  for (const TilePiece& piece : tile.pieces) pieces.push_back(piece.number);
  append(numbers_, pieces, before, count);
  append(layers_, tile.layers, before, count);
  addLinks(tile, numbers, poll);
}

// Numbers are below those of the vertices of the tile and outside.
void TileGathering::addLinks(const Tile& tile, std::vector<Index>& numbers, const Poll& poll) {
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

std::vector<Index> TileGathering::numberVertices(const Tile& tile, const Poll& poll) {
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
    if (numbers[v] == next) {
      places_.push_back(tile.places[v]);
      exact_.push_back(tile.exact[v]);
    }
    if (tile.geometry.vertices.empty()) continue;
    heights_.resize(places_.size());
    heights_[numbers[v]] = tile.geometry.vertices[v].z;
  }
  return numbers;
}

std::uint32_t TileGathering::numberOf(std::size_t triangle) const { return numbers_.empty() ? 0 : numbers_[triangle]; }

void TileGathering::addTriangle(std::size_t added, Whole& whole) {
  MeshTriangle triangle = triangles_[added];
  PlacedMesh& mesh = whole.mesh;
  const auto source = static_cast<std::uint32_t>(triangle.face);
  if (mesh.sources.empty() || mesh.sources.back() != source) mesh.sources.push_back(source);
  triangle.face = static_cast<Index>(mesh.sources.size()) - 1;
  for (Index& v : triangle.corners) {
    if (renumbered_[v] < 0) {
      renumbered_[v] = static_cast<Index>(mesh.places.size());
      mesh.places.push_back(places_[v]);
      mesh.exact.push_back(exact_[v]);
      if (!heights_.empty()) whole.heights.push_back(heights_[v]);
    }
    v = renumbered_[v];
  }
  mesh.triangles.push_back(triangle);
  if (!layers_.empty()) mesh.layers.push_back(layers_[added]);
  whole.addedAs.push_back(static_cast<Index>(added));
}

TileGathering::Whole TileGathering::take(RunContext& context) {
  borders_ = {};
  if (!heights_.empty()) heights_.resize(places_.size());
  for (const std::uint32_t layer : layers_)
    if (layer >= layers_.size()) throw BadBytes("is damaged");
  parallelSort(faces_.begin(), faces_.end(),
               [](const AddedFace& a, const AddedFace& b) { return comesBefore(a.face, b.face); });
  context.checkCancelled();
  Whole whole;
  whole.mesh.triangles.reserve(triangles_.size());
  renumbered_.assign(places_.size(), -1);
  std::vector<std::size_t> ofFace;  // triangles that several tiles have of one face
  std::size_t polled = 0;
  for (auto first = faces_.begin(); first != faces_.end();) {
    if (++polled % 4096 == 0) context.checkCancelled();
    const auto last = std::find_if(first + 1, faces_.end(),
                                   [&first](const AddedFace& other) { return comesBefore(first->face, other.face); });
    ofFace.clear();
    for (auto face = first; face != last; ++face)
      for (std::size_t i = 0; i < face->face.triangles; ++i) ofFace.push_back(face->firstTriangle + i);
    if (last - first > 1)
      std::sort(ofFace.begin(), ofFace.end(),
                [this](std::size_t a, std::size_t b) { return std::pair(numberOf(a), a) < std::pair(numberOf(b), b); });
    for (const std::size_t added : ofFace) addTriangle(added, whole);
    first = last;
  }
  for (MeshLink link : links_) {
    for (std::array<Index, 2>* edge : {&link.from, &link.to})
      for (Index& v : *edge) v = renumbered_[v];
    const auto isThere = [](const std::array<Index, 2>& edge) { return edge[0] >= 0 && edge[1] >= 0; };
    if (isThere(link.from) && isThere(link.to)) whole.mesh.links.push_back(link);
  }
  sortOnce(whole.mesh.links);
  *this = {};
  return whole;
}

}  // namespace footfall::detail
