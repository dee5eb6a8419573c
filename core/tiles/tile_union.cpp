// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_union.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/base/sorted_list.hpp"
#include "core/tiles/border_names.hpp"
#include "core/tiles/tile_geometry.hpp"

namespace footfall::detail {
namespace {

TileFace sourceFaceOf(const TileSource& triangle, const std::vector<Vec3>& corners) {
  const auto at = [&](std::size_t k) { return corners[triangle.corners[k]]; };
  return {triangle.number, 0, {at(0), at(1), at(2)}};
}

}  // namespace

TileUnion::TileUnion(std::vector<Part> parts, const Grid& grid, RunContext& context) : parts_(std::move(parts)) {
  makeKernel(grid, context);
  addMesh(context);
}

// All triangles of the environment that the parts name, each once. They are sorted as the mesh sorts them.
void TileUnion::makeKernel(const Grid& grid, RunContext& context) {
  std::vector<TileFace> all;
  for (const Part& part : parts_) {
    all.insert(all.end(), part.triangles.faces.begin(), part.triangles.faces.end());
    const TileGeometry& geometry = part.triangles.geometry;
    for (const TileSource& triangle : geometry.triangles) all.push_back(sourceFaceOf(triangle, geometry.corners));
  }
  std::sort(all.begin(), all.end(), comesBefore);
  const auto isSame = [](const TileFace& a, const TileFace& b) { return !comesBefore(a, b); };  // Both are sorted.
  all.erase(std::unique(all.begin(), all.end(), isSame), all.end());
  context.checkCancelled();
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> numbers;
  for (const TileFace& face : all) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), face.corners.begin(), face.corners.end());
    triangles.push_back({first, first + 1, first + 2});
    numbers.push_back(face.source);
  }
  std::vector<std::size_t> firstCorner;
  std::vector<double> heights;
  for (const Part& part : parts_) {
    const TileGeometry& geometry = part.triangles.geometry;
    firstCorner.push_back(vertices.size());
    vertices.insert(vertices.end(), geometry.corners.begin(), geometry.corners.end());
    if (geometry.heights.size() > heights.size()) heights = geometry.heights;  // others are the first of these
  }
  SoupView soup(vertices, triangles, numbers);
  soup.grid = grid;
  const auto mesh = std::make_shared<const SourceMesh>(makeSourceMesh(soup, false, nullptr, context));
  kernel_ = std::make_shared<const PlanKernel>(mesh, std::move(heights));
  const auto idOf = [&all](const TileFace& face) {
    return static_cast<Index>(std::lower_bound(all.begin(), all.end(), face, comesBefore) - all.begin());
  };
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Tile& tile = parts_[p].triangles;
    auto& faces = faces_.emplace_back();
    for (const TileFace& face : tile.faces) faces.push_back(idOf(face));
    auto& sources = sources_.emplace_back();
    for (const TileSource& triangle : tile.geometry.triangles)
      sources.push_back(idOf(sourceFaceOf(triangle, tile.geometry.corners)));
    auto& corners = corners_.emplace_back();
    for (std::size_t c = 0; c < tile.geometry.corners.size(); ++c) corners.push_back(mesh->welded[firstCorner[p] + c]);
  }
}

MeshVertex TileUnion::vertexOf(const Origin& origin) const {
  MeshVertex vertex = parts_[origin.part].triangles.geometry.vertices[origin.number];
  const std::vector<Index>&corners = corners_[origin.part], &sources = sources_[origin.part];
  const std::vector<Index>& planIds = kernel_->mesh().planIds;
  vertex.point = renumbered(
      vertex.point, [&](Index c) { return planIds[corners[c]]; }, [&](Index c) { return corners[c]; },
      [&](Index t) { return sources[t]; });
  vertex.face = sources[vertex.face];
  if (vertex.source >= 0) vertex.source = corners[vertex.source];
  return vertex;
}

// Order of the whole: triangles by their faces and numbers, vertices by their first use.
void TileUnion::addMesh(RunContext& context) {
  using Place = std::tuple<Index, std::uint32_t, std::uint32_t, Index>;  // face, number there, part, number there
  std::vector<Place> order;
  std::vector<std::vector<Index>> numbers;  // numbers of the vertices of each part
  BorderNames names;
  std::vector<Origin> added;
  bool isLayered = false;
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    const Tile& tile = parts_[p].triangles;
    isLayered = isLayered || !tile.layers.empty();
    for (std::size_t t = 0; t < tile.triangles.size(); ++t)
      order.emplace_back(faces_[p][tile.triangles[t].face], tile.pieces[t].number, p, static_cast<Index>(t));
    std::vector<Index>& own = numbers.emplace_back();
    auto border = tile.borders.begin();
    for (Index v = 0; v < static_cast<Index>(tile.places.size()); ++v) {
      const auto next = static_cast<Index>(added.size());
      own.push_back(next);
      if (border != tile.borders.end() && border->vertex == v) {
        own.back() = names.numberOf(tile.places[v], *border, next);
        ++border;
      }
      if (own.back() == next) added.push_back({p, v});
    }
  }
  std::sort(order.begin(), order.end());
  context.checkCancelled();
  std::vector<Index> renumbered(added.size(), -1);
  for (const auto& [face, piece, p, t] : order) {
    const Tile& tile = parts_[p].triangles;
    MeshTriangle triangle = tile.triangles[t];
    triangle.face = faces_[p][tile.pieces[t].plane];
    for (Index& v : triangle.corners) {
      Index& number = renumbered[numbers[p][v]];
      if (number < 0) {
        number = static_cast<Index>(vertices_.size());
        vertices_.push_back(added[numbers[p][v]]);
      }
      v = number;
    }
    mesh_.triangles.push_back(triangle);
    triangles_.push_back({p, t});
    if (isLayered) mesh_.layers.push_back(tile.layers[t]);
  }
  for (const Origin& origin : vertices_) mesh_.vertices.push_back(vertexOf(origin));
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    for (Index& v : numbers[p]) v = renumbered[v];
    const std::vector<char>& isLinked = parts_[p].isLinked;
    for (std::size_t v = 0; v < isLinked.size(); ++v) {
      const Index number = numbers[p][v];
      if (isLinked[v] != 0) mesh_.links.push_back({{number, number}, {number, number}});
    }
  }
  numbers_ = std::move(numbers);
}

TileOutside TileUnion::outsideOf(Index vertex) const {
  Tile tile;
  addVertex(vertex, true, tile);
  return {tile.places[0], tile.borders[0].face, tile.borders[0].exact};
}

bool TileUnion::isOwn(Index triangle) const {
  const Origin& origin = triangles_[triangle];
  const std::vector<char>& isOwn = parts_[origin.part].isOwn;
  return isOwn.empty() || isOwn[origin.number] != 0;
}

Index TileUnion::numberInTile(Index triangle) const {
  const Origin& origin = triangles_[triangle];
  const std::vector<Index>& numbers = parts_[origin.part].numbers;
  return numbers.empty() ? origin.number : numbers[origin.number];
}

const TileBorder* TileUnion::borderAt(const Origin& vertex) const {
  const std::vector<TileBorder>& borders = parts_[vertex.part].triangles.borders;
  const auto found = std::lower_bound(borders.begin(), borders.end(), vertex.number,
                                      [](const TileBorder& border, Index number) { return border.vertex < number; });
  return found != borders.end() && found->vertex == vertex.number ? &*found : nullptr;
}

// The triangle of the environment in whose place a triangle is.
Index TileUnion::faceOf(Index triangle) const {
  const Origin& origin = triangles_[triangle];
  return faces_[origin.part][parts_[origin.part].triangles.triangles[origin.number].face];
}

void TileUnion::addVertex(Index vertex, bool isNamed, Tile& tile) const {
  const Origin& from = vertices_[vertex];
  const Tile& given = parts_[from.part].triangles;
  const auto number = static_cast<Index>(tile.places.size());
  tile.places.push_back(given.places[from.number]);
  tile.exact.push_back(given.exact[from.number]);
  if (const TileBorder* border = borderAt(from)) {
    tile.borders.push_back(*border);
    tile.borders.back().vertex = number;
  } else if (isNamed) {
    const MeshVertex& exact = mesh_.vertices[vertex];
    tile.borders.push_back(
        borderOf(*kernel_, exact, tile.exact.back() != 0, number, kernel_->mesh().inputTriangles[exact.face]));
  }
}

Tile TileUnion::tileOf(std::span<const Changed> triangles, const std::vector<char>& isNamed) const {
  const SourceMesh& source = kernel_->mesh();
  Tile tile;
  std::vector<Index> faces;
  for (const auto& [t, now] : triangles) {
    faces.push_back(faceOf(t));
    faces.push_back(now.face);
  }
  sortOnce(faces);
  for (const Index id : faces) {
    TileFace face{source.inputTriangles[id], 0, {}};
    for (std::size_t k = 0; k < 3; ++k) face.corners[k] = source.vertices[source.triangles[id][k]];
    tile.faces.push_back(face);
  }
  const auto numberOf = [&faces](Index id) {
    return static_cast<Index>(std::lower_bound(faces.begin(), faces.end(), id) - faces.begin());
  };
  std::vector<Index> numbers(mesh_.vertices.size(), -1);
  std::vector<MeshVertex> vertices;
  for (const auto& [t, now] : triangles) {
    MeshTriangle triangle = now;
    triangle.face = numberOf(faceOf(t));
    ++tile.faces[triangle.face].triangles;
    for (Index& v : triangle.corners) {
      if (numbers[v] < 0) {
        numbers[v] = static_cast<Index>(vertices.size());
        vertices.push_back(mesh_.vertices[v]);
        addVertex(v, isNamed[v] != 0, tile);
      }
      v = numbers[v];
    }
    tile.triangles.push_back(triangle);
    const Origin& origin = triangles_[t];
    const Tile& given = parts_[origin.part].triangles;
    tile.pieces.push_back({given.pieces[origin.number].number, numberOf(now.face)});
    if (!given.layers.empty()) tile.layers.push_back(given.layers[origin.number]);
  }
  if (!vertices.empty()) tile.geometry = geometryOf(*kernel_, std::move(vertices), {});
  return tile;
}

}  // namespace footfall::detail
