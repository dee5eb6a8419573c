// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex buffers of walkable meshes; those of environments are in render_geometry.cpp.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/vector.hpp"
#include "core/mesh/storey_names.hpp"
#include "ui/view/geometry/floor_shares.hpp"
#include "ui/view/geometry/line_crowds.hpp"
#include "ui/view/geometry/link_lines.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/geometry/surface_triangles.hpp"

namespace footfall::ui {
namespace {

std::vector<LineSegment> toSegments(const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                    const std::vector<Vec3>& vertices, const Vec3& centre) {
  std::vector<LineSegment> segments;
  segments.reserve(pairs.size());
  for (const auto& [a, b] : pairs) segments.push_back({toFloats(vertices[a], centre), toFloats(vertices[b], centre)});
  return segments;
}

std::vector<std::uint32_t> surfaceLayersOf(const NavigationMesh& mesh, const EnvironmentLayers* environment) {
  if (!environment) return {};
  std::vector<std::uint32_t> layers(mesh.triangles.size(), kNoLayer);
  for (std::size_t t = 0; t < layers.size(); ++t) {
    const std::uint32_t source = t < mesh.sourceTriangles.size() ? mesh.sourceTriangles[t] : kNoLayer;
    const std::uint32_t below = source < environment->size() ? (*environment)[source] : kNoLayer;
    layers[t] = mesh.layers.empty() ? below : below == kNoLayer ? mesh.layers[t] | kFloorStays : mesh.layers[t];
  }
  return layers;
}

std::vector<LayerFigures> figuresOf(const NavigationMesh& mesh, const Vec3& centre) {
  std::vector<LayerFigures> figures(std::max<std::size_t>(mesh.layerCount, 1));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    LayerFigures& layer = figures[mesh.layers.empty() ? 0 : mesh.layers[t]];
    const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
    for (const Vec3* corner : corners) {
      const auto p = toFloats(*corner, centre);
      if (layer.triangles == 0 && corner == corners[0]) layer.lower = layer.upper = p;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        layer.lower[axis] = std::min(layer.lower[axis], p[axis]);
        layer.upper[axis] = std::max(layer.upper[axis], p[axis]);
      }
    }
    layer.area += areaOf(*corners[0], *corners[1], *corners[2]);
    ++layer.triangles;
  }
  const std::vector<std::string> storeys = storeyNames(mesh);
  for (std::size_t i = 0; i < storeys.size(); ++i) figures[i].storeys = storeys[i];
  return figures;
}

/// The layers at the edges of a mesh with layers, by the numbers of their vertices.
class EdgeLayers {
 public:
  explicit EdgeLayers(const NavigationMesh& mesh) : mesh_(mesh) {}

  /// Called in the order of forEachEdge(); kNoLayer without layers.
  LineLayers add(const SharedEdge& edge) {
    if (mesh_.layers.empty()) return {kNoLayer, kNoLayer};
    const LineLayers layers{mesh_.layers[edge.triangles.front()], mesh_.layers[edge.triangles.back()]};
    if (edge.triangles.size() == 1 || layers[0] != layers[1]) known_.push_back({edge.low, edge.high, layers});
    return layers;
  }

  /// Called after all edges have been added.
  [[nodiscard]] std::vector<LineLayers> of(const std::vector<std::array<std::uint32_t, 2>>& edges) const {
    std::vector<LineLayers> found;
    if (mesh_.layers.empty()) return found;
    found.reserve(edges.size());
    for (const auto& [a, b] : edges) {
      const std::array key{std::min(a, b), std::max(a, b)};
      const auto at = std::ranges::lower_bound(known_, key, {}, [](const Known& k) {
        return std::array{k.low, k.high};
      });
      const bool there = at != known_.end() && at->low == key[0] && at->high == key[1];
      found.push_back(there ? at->layers : LineLayers{kNoLayer, kNoLayer});
    }
    return found;
  }

 private:
  struct Known {
    std::uint32_t low, high;
    LineLayers layers;
  };
  const NavigationMesh& mesh_;
  std::vector<Known> known_;
};

}  // namespace

std::shared_ptr<const EnvironmentLayers> makeEnvironmentLayers(const NavigationMesh& mesh,
                                                               const Environment& environment,
                                                               const std::vector<FloorShare>& shares) {
  if (mesh.layers.empty()) return nullptr;
  constexpr std::uint32_t kNotSeen = kNoLayer - 1;
  auto layers = std::make_shared<EnvironmentLayers>(environment.triangles.size(), kNotSeen);
  const auto add = [&](std::uint32_t floor, std::uint32_t of) {
    std::uint32_t& layer = (*layers)[floor];
    layer = layer == kNotSeen || layer == of ? of : kNoLayer;
  };
  for (const FloorShare& share : shares) add(share.floor, mesh.layers[share.piece]);
  for (const DoubledFloor& doubled : doubledFloors(shares, environment)) add(doubled.floor, (*layers)[doubled.named]);
  std::ranges::replace(*layers, kNotSeen, kNoLayer);
  return layers;
}

std::shared_ptr<const NavigationMeshGeometry> makeMeshGeometry(const NavigationMesh& mesh, const Vec3& centre,
                                                               const std::optional<Paint>& paint,
                                                               const EnvironmentLayers* environmentLayers) {
  auto geometry = std::make_shared<NavigationMeshGeometry>();
  geometry->layers = mesh.layerCount;
  geometry->surface.reserve(mesh.triangles.size() * 3);
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
    const Paint colour = paint ? *paint : mesh.layers.empty() ? walkablePaint() : layerPaint(mesh.layers[t]);
    normals.push_back(unitNormal(*corners[0], *corners[1], *corners[2]));
    addTriangle(geometry->surface, corners, centre, normals.back(), colour, false);
  }
  geometry->sources = mesh.sourceTriangles;
  geometry->surfaceLayers = surfaceLayersOf(mesh, environmentLayers);
  if (paint) return geometry;  // removed floors show no lines
  geometry->figures = figuresOf(mesh, centre);
  EdgeLayers edgeLayers(mesh);
  forEachEdge(mesh.triangles, mesh.vertices.size(), [&](const SharedEdge& edge) {
    const LineLayers layers = edgeLayers.add(edge);
    const auto& around = edge.triangles;
    const bool sharp = around.size() == 2 && isCrease(normals[around[0]], normals[around[1]]);
    if (around.size() != 1 && !sharp) return;
    (sharp ? geometry->creases : geometry->outline)
        .push_back({toFloats(mesh.vertices[edge.low], centre), toFloats(mesh.vertices[edge.high], centre)});
    if (!mesh.layers.empty()) (sharp ? geometry->creaseLayers : geometry->outlineLayers).push_back(layers);
  });
  geometry->obstacleEdges = toSegments(mesh.obstacleEdges, mesh.vertices, centre);
  geometry->connections = toSegments(mesh.connections, mesh.vertices, centre);
  geometry->obstacleEdgeLayers = edgeLayers.of(mesh.obstacleEdges);
  geometry->connectionLayers = edgeLayers.of(mesh.connections);
  addLinkLines(mesh, centre, *geometry);
  for (std::vector<LineSegment>* lines : {&geometry->creases, &geometry->outline, &geometry->obstacleEdges,
                                          &geometry->connections, &geometry->steps, &geometry->gaps, &geometry->drops})
    setCrowds(*lines);
  return geometry;
}

void addSourceEdges(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  geometry.creases.clear();
  geometry.creaseLayers.clear();
  EdgeLayers edgeLayers(mesh);
  forEachEdge(mesh.triangles, mesh.vertices.size(), [&](const SharedEdge& edge) {
    const LineLayers layers = edgeLayers.add(edge);
    const auto& around = edge.triangles;
    if (around.size() == 2 && mesh.sourceTriangles[around[0]] == mesh.sourceTriangles[around[1]]) return;
    geometry.creases.push_back({toFloats(mesh.vertices[edge.low], centre), toFloats(mesh.vertices[edge.high], centre)});
    if (!mesh.layers.empty()) geometry.creaseLayers.push_back(layers);
  });
  setCrowds(geometry.creases);
}

}  // namespace footfall::ui
