// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_geometry.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace footfall::detail {
namespace {

/// Finds out which corners and triangles of a larger list some vertices need, and numbers these alone.
class GeometryChoice {
 public:
  GeometryChoice(std::size_t corners, std::size_t triangles) : corners_(corners, -1), triangles_(triangles, -1) {}

  /// `cornersOf(triangle)` gives the three corners of one; `cornerAt(corner)` their places, `numberOf(triangle)` its
  /// number in the environment.
  template <class CornersOf, class CornerAt, class NumberOf>
  TileGeometry make(std::vector<MeshVertex> vertices, CornersOf cornersOf, CornerAt cornerAt, NumberOf numberOf) {
    constexpr Index kUsed = 0;
    const auto corner = [&](Index c) { return corners_[c] = kUsed; };
    const auto triangle = [&](Index t) { return triangles_[t] = kUsed; };
    for (const MeshVertex& vertex : vertices) {
      renumbered(vertex.point, corner, corner, triangle);
      triangle(vertex.face);
      if (vertex.source >= 0) corner(vertex.source);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (triangles_[t] == kUsed)
        for (const Index c : cornersOf(static_cast<Index>(t))) corner(c);
    TileGeometry made;
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (corners_[c] != kUsed) continue;
      corners_[c] = static_cast<Index>(made.corners.size());
      made.corners.push_back(cornerAt(static_cast<Index>(c)));
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (triangles_[t] != kUsed) continue;
      triangles_[t] = static_cast<Index>(made.triangles.size());
      TileSource source{{}, numberOf(static_cast<Index>(t))};
      const auto corners = cornersOf(static_cast<Index>(t));
      for (std::size_t k = 0; k < 3; ++k) source.corners[k] = corners_[corners[k]];
      made.triangles.push_back(source);
    }
    const auto newCorner = [this](Index c) { return corners_[c]; };
    const auto newTriangle = [this](Index t) { return triangles_[t]; };
    for (MeshVertex& vertex : vertices) {
      vertex.point = renumbered(vertex.point, newCorner, newCorner, newTriangle);
      vertex.face = newTriangle(vertex.face);
      if (vertex.source >= 0) vertex.source = newCorner(vertex.source);
    }
    made.vertices = std::move(vertices);
    return made;
  }

 private:
  std::vector<Index> corners_, triangles_;  ///< new numbers; -1 where nothing needs it
};

TileGeometry chosenGeometry(const TileGeometry& geometry, std::vector<MeshVertex> vertices) {
  TileGeometry made =
      GeometryChoice(geometry.corners.size(), geometry.triangles.size())
          .make(
              std::move(vertices), [&](Index t) { return geometry.triangles[t].corners; },
              [&](Index c) { return geometry.corners[c]; }, [&](Index t) { return geometry.triangles[t].number; });
  made.heights = geometry.heights;
  return made;
}

/// Copies faces and vertices in the order of their first use.
class TileCopy {
 public:
  explicit TileCopy(const Tile& tile) : tile_(tile), faces_(tile.faces.size(), 0), numbers_(tile.places.size(), -1) {}

  Tile make(const std::vector<char>& chosen) {
    chooseFaces(chosen);
    for (std::size_t t = 0; t < tile_.triangles.size(); ++t)
      if (chosen[t] != 0) add(t);
    for (TileBorder border : tile_.borders) {
      border.vertex = numbers_[border.vertex];
      if (border.vertex >= 0) kept_.borders.push_back(std::move(border));
    }
    std::sort(kept_.borders.begin(), kept_.borders.end(),
              [](const TileBorder& a, const TileBorder& b) { return a.vertex < b.vertex; });
    if (!vertices_.empty()) kept_.geometry = chosenGeometry(tile_.geometry, std::move(vertices_));
    return std::move(kept_);
  }
  [[nodiscard]] const std::vector<Index>& numbers() const { return numbers_; }

 private:
  void chooseFaces(const std::vector<char>& chosen) {
    constexpr Index kUsed = 1;
    for (std::size_t t = 0; t < tile_.triangles.size(); ++t) {
      if (chosen[t] == 0) continue;
      faces_[tile_.triangles[t].face] = kUsed;
      if (!tile_.pieces.empty()) faces_[tile_.pieces[t].plane] = kUsed;
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (faces_[f] == 0) continue;
      faces_[f] = static_cast<Index>(kept_.faces.size());
      kept_.faces.push_back(tile_.faces[f]);
      kept_.faces.back().triangles = 0;
    }
  }

  void add(std::size_t t) {
    MeshTriangle triangle = tile_.triangles[t];
    triangle.face = faces_[triangle.face];
    ++kept_.faces[triangle.face].triangles;
    for (Index& v : triangle.corners) {
      if (numbers_[v] < 0) {
        numbers_[v] = static_cast<Index>(kept_.places.size());
        kept_.places.push_back(tile_.places[v]);
        kept_.exact.push_back(tile_.exact[v]);
        if (!tile_.geometry.vertices.empty()) vertices_.push_back(tile_.geometry.vertices[v]);
      }
      v = numbers_[v];
    }
    kept_.triangles.push_back(triangle);
    if (!tile_.pieces.empty()) kept_.pieces.push_back({tile_.pieces[t].number, faces_[tile_.pieces[t].plane]});
    if (!tile_.layers.empty()) kept_.layers.push_back(tile_.layers[t]);
  }

  const Tile& tile_;
  Tile kept_;
  std::vector<Index> faces_, numbers_;
  std::vector<MeshVertex> vertices_;
};

}  // namespace

bool comesBefore(const TileFace& a, const TileFace& b) {
  const auto placeOf = [](const Vec3& v) { return std::tuple(v.x, v.y, v.z); };
  for (std::size_t k = 0; k < 3; ++k)
    if (const auto p = placeOf(a.corners[k]), q = placeOf(b.corners[k]); p != q) return p < q;
  return a.source < b.source;
}

TileGeometry geometryOf(const PlanKernel& kernel, std::vector<MeshVertex> vertices,
                        const std::vector<std::uint32_t>& numbers) {
  const SourceMesh& mesh = kernel.mesh();
  TileGeometry made = GeometryChoice(mesh.vertices.size(), mesh.triangles.size())
                          .make(
                              std::move(vertices), [&](Index t) { return mesh.triangles[t]; },
                              [&](Index c) { return mesh.vertices[c]; },
                              [&](Index t) {
                                const std::uint32_t input = mesh.inputTriangles[t];
                                return numbers.empty() ? input : numbers[input];
                              });
  made.heights = kernel.heights();
  return made;
}

TileBorder borderOf(const PlanKernel& kernel, const MeshVertex& vertex, bool isExact, Index number,
                    std::uint32_t face) {
  TileBorder border{number, face, {}};
  if (isExact) return border;
  const std::array<mpq_class, 3> place = kernel.exactPosition(vertex.point, vertex.face);
  border.exact = place[0].get_str() + ' ' + place[1].get_str() + ' ' + place[2].get_str();
  return border;
}

Tile chosenTriangles(const Tile& tile, const std::vector<char>& chosen, std::vector<Index>* numbers) {
  TileCopy copy(tile);
  Tile made = copy.make(chosen);
  if (numbers != nullptr) *numbers = copy.numbers();
  return made;
}

}  // namespace footfall::detail
