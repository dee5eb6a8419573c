// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/render_geometry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/vector.hpp"
#include "core/mesh/adjacency.hpp"
#include "core/mesh/storey_names.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/coarse_geometry.hpp"
#include "ui/view/floor_shares.hpp"
#include "ui/view/level_covers.hpp"

namespace footfall::ui {
namespace {

// Steeper than this counts as a wall on screen: stripes on walls would only be noise.
constexpr double kWallNormalZ = 0.02;
// Edges whose triangles turn by more than about 25 degrees help to read a shape.
constexpr double kCreaseCosine = 0.9;
constexpr double kFlatCosine = 0.999;

std::array<float, 3> toFloats(const Vec3& p, const Vec3& centre) {
  return {static_cast<float>(p.x - centre.x), static_cast<float>(p.y - centre.y), static_cast<float>(p.z - centre.z)};
}

Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = normalOf(a, b, c);
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  return length > 0 ? Vec3{n.x / length, n.y / length, n.z / length} : Vec3{0, 0, 1};
}

bool isFlat(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z > kFlatCosine; }

bool isCrease(const Vec3& a, const Vec3& b) { return std::abs(a.x * b.x + a.y * b.y + a.z * b.z) < kCreaseCosine; }

std::int8_t toByte(double component) { return static_cast<std::int8_t>(std::lround(component * 127)); }

void addTriangle(std::vector<SurfaceVertex>& surface, const std::array<const Vec3*, 3>& corners, const Vec3& centre,
                 const Vec3& normal, const Paint& paint, bool takesFloorPaint) {
  SurfaceVertex vertex;
  vertex.normal = {toByte(normal.x), toByte(normal.y), toByte(normal.z), 0};
  setPaint(vertex, paint);
  if (takesFloorPaint) vertex.colour[3] = 0;
  for (const Vec3* corner : corners) {
    vertex.position = toFloats(*corner, centre);
    surface.push_back(vertex);
  }
}

std::array<const Vec3*, 3> cornersOf(const std::vector<Vec3>& vertices, const Triangle& triangle) {
  return {&vertices[triangle[0]], &vertices[triangle[1]], &vertices[triangle[2]]};
}

/// An edge of the triangles: its vertices, the smaller one first, and the triangles at it, ascending.
struct SharedEdge {
  std::uint32_t low = 0, high = 0;
  std::vector<std::uint32_t> triangles;
};

// Calls visit(edge) for each edge with two ends, in the order of their vertices.
template <typename Visit>
void forEachEdge(const std::vector<Triangle>& triangles, std::size_t vertexCount, Visit visit) {
  const TriangleCorners corners(triangles);
  const Adjacency adjacency = findEdges(corners, vertexCount);
  SharedEdge edge;
  for (Index e = 0; e < adjacency.edgeCount(); ++e) {
    const auto sides = adjacency.sidesOf(e);
    const auto [low, high] = std::minmax({corners.beginOf(sides[0]), corners.endOf(sides[0])});
    if (low == high) continue;
    edge.low = static_cast<std::uint32_t>(low);
    edge.high = static_cast<std::uint32_t>(high);
    edge.triangles.clear();
    for (const Index side : sides) edge.triangles.push_back(static_cast<std::uint32_t>(side / 3));
    visit(std::as_const(edge));
  }
}

struct PositionHash {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t h = 0;
    for (const double d : {p.x, p.y, p.z}) h = (h ^ std::bit_cast<std::uint64_t>(d + 0.0)) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(h ^ (h >> 32U));
  }
};

// The triangles, with the first vertex at the same position for each corner: soups repeat their vertices.
std::vector<Triangle> welded(const std::vector<Triangle>& triangles, const std::vector<Vec3>& vertices) {
  std::unordered_map<Vec3, std::uint32_t, PositionHash> firstAt;
  firstAt.reserve(vertices.size());
  std::vector<std::uint32_t> ids(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) ids[i] = firstAt.try_emplace(vertices[i], i).first->second;
  std::vector<Triangle> result;
  result.reserve(triangles.size());
  for (const Triangle& t : triangles) result.push_back({ids[t[0]], ids[t[1]], ids[t[2]]});
  return result;
}

// The outermost corners in the 98 directions of a 5 x 5 x 5 grid's surface.
std::vector<Vec3> extremePoints(const std::vector<SurfaceVertex>& surface) {
  std::vector<std::array<float, 3>> directions;
  for (int direction = 0; direction < 125; ++direction) {
    const std::array<int, 3> d{direction % 5 - 2, direction / 5 % 5 - 2, direction / 25 - 2};
    if (std::ranges::any_of(d, [](int c) { return std::abs(c) == 2; }))
      directions.push_back({static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2])});
  }
  struct Farthest {
    float reach = -std::numeric_limits<float>::infinity();
    std::size_t vertex = 0;
  };
  std::vector<Farthest> farthest(directions.size());
  // In blocks that stay in the nearest cache, or a million triangles would be read from memory for each direction.
  constexpr std::size_t kBlock = 512;
  for (std::size_t begin = 0; begin < surface.size(); begin += kBlock) {
    const std::size_t end = std::min(surface.size(), begin + kBlock);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto& d = directions[i];
      Farthest best = farthest[i];
      for (std::size_t v = begin; v < end; ++v) {
        const auto& p = surface[v].position;
        const float reach = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
        if (reach > best.reach) best = {reach, v};
      }
      farthest[i] = best;
    }
  }
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < directions.size() && !surface.empty(); ++i) {
    const auto& far = surface[farthest[i].vertex].position;
    points.push_back({far[0], far[1], far[2]});
  }
  return points;
}

// The corners of all triangles within a margin around the middle ones along x and y; all of them unless that leaves a
// small part of the extent.
std::vector<SurfaceVertex> detailOf(const std::vector<SurfaceVertex>& surface) {
  constexpr std::size_t kOutside = 50;  // one corner in so many on either side
  constexpr float kSmallPart = 0.3F;
  if (surface.size() < 4 * kOutside) return surface;
  std::array<float, 2> lower{};
  std::array<float, 2> upper{};
  bool small = true;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<float> values;
    values.reserve(surface.size());
    for (const SurfaceVertex& vertex : surface) values.push_back(vertex.position[axis]);
    std::sort(values.begin(), values.end());
    lower[axis] = values[values.size() / kOutside];
    upper[axis] = values[values.size() - 1 - values.size() / kOutside];
    const float extent = upper[axis] - lower[axis];
    small = small && extent < kSmallPart * (values.back() - values.front());
    lower[axis] -= 0.1F * extent;
    upper[axis] += 0.1F * extent;
  }
  if (!small) return surface;
  std::vector<SurfaceVertex> detail;
  std::copy_if(surface.begin(), surface.end(), std::back_inserter(detail), [&](const SurfaceVertex& v) {
    return v.position[0] >= lower[0] && v.position[0] <= upper[0] && v.position[1] >= lower[1] &&
           v.position[1] <= upper[1];
  });
  return detail;
}

std::vector<LineSegment> toSegments(const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                    const std::vector<Vec3>& vertices, const Vec3& centre) {
  std::vector<LineSegment> segments;
  segments.reserve(pairs.size());
  for (const auto& [a, b] : pairs) segments.push_back({toFloats(vertices[a], centre), toFloats(vertices[b], centre)});
  return segments;
}

using VertexPair = std::array<std::uint32_t, 2>;

// Four lines a link: like a rung between two rails.
constexpr std::size_t kLinesOfStep = 4;

std::vector<VertexPair> stepLines(const std::vector<StepLink>& links) {
  std::vector<VertexPair> lines;
  lines.reserve(kLinesOfStep * links.size());
  for (const StepLink& link : links)
    if (link.kind == StepKind::Step)
      lines.insert(lines.end(), {link.from, link.to, {link.from[0], link.to[1]}, {link.from[1], link.to[0]}});
  return lines;
}

// Both edges of a gap as dashes, beside each other, and its ends: so gaps are told from steps without colours, too.
void addGaps(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  constexpr double kDashOfWidth = 4, kMostDashes = 24;
  for (const StepLink& link : mesh.links) {
    if (link.kind != StepKind::Gap) continue;
    const std::array<Vec3, 2> first{mesh.vertices[link.from[0]], mesh.vertices[link.from[1]]};
    const std::array<Vec3, 2> second{mesh.vertices[link.to[1]], mesh.vertices[link.to[0]]};
    const double size = length(first[1] - first[0]);
    const auto dashes = static_cast<int>(std::clamp(size / (2 * kDashOfWidth * link.width), 2.0, kMostDashes));
    const auto add = [&](const Vec3& a, const Vec3& b) {
      geometry.gaps.push_back({toFloats(a, centre), toFloats(b, centre)});
      if (!mesh.layers.empty())
        geometry.gapLayers.push_back({mesh.layers[link.fromTriangle], mesh.layers[link.toTriangle]});
    };
    for (const auto& [a, b] : {first, second})
      for (int i = 0; i < dashes; ++i) {
        const double begin = 2.0 * i / (2 * dashes - 1), end = (2.0 * i + 1) / (2 * dashes - 1);
        add(a + begin * (b - a), a + end * (b - a));
      }
    add(first[0], second[0]);
    add(first[1], second[1]);
  }
}

std::vector<LineLayers> stepLayers(const NavigationMesh& mesh) {
  std::vector<LineLayers> layers;
  layers.reserve(kLinesOfStep * mesh.links.size());
  for (const StepLink& link : mesh.links)
    if (link.kind == StepKind::Step)
      layers.insert(layers.end(), kLinesOfStep, {mesh.layers[link.fromTriangle], mesh.layers[link.toTriangle]});
  return layers;
}

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

// The stretch that one drops from, and arrows as far from each other as the drop is deep, a few at most.
void addDropLines(const DropLink& drop, const Vec3& centre, std::vector<LineSegment>& lines) {
  constexpr double kMostArrows = 8, kHead = 0.25, kHeadWidth = 0.35;
  const auto add = [&](const Vec3& a, const Vec3& b) { lines.push_back({toFloats(a, centre), toFloats(b, centre)}); };
  add(drop.start[0], drop.start[1]);
  const double arrows = std::clamp(std::round(drop.width / std::max(drop.depth, 1e-300)), 1.0, kMostArrows);
  // Half the width of a head, as a share of the stretch: it stays inside, and is no wider than the fall is deep.
  const double half = std::min(0.4 / arrows, kHead * kHeadWidth * drop.depth / std::max(drop.width, 1e-300));
  for (double i = 0; i < arrows; ++i) {
    const double t = (i + 0.5) / arrows;
    const Vec3 tip = between(drop.landing[0], drop.landing[1], t);
    add(between(drop.start[0], drop.start[1], t), tip);
    for (const double side : {t - half, t + half})
      add(between(between(drop.landing[0], drop.landing[1], side), between(drop.start[0], drop.start[1], side), kHead),
          tip);
  }
}

void addDrops(const NavigationMesh& mesh, const Vec3& centre, NavigationMeshGeometry& geometry) {
  for (const DropLink& drop : mesh.drops) {
    addDropLines(drop, centre, geometry.drops);
    if (!mesh.layers.empty())
      geometry.dropLayers.resize(geometry.drops.size(), {mesh.layers[drop.fromTriangle], mesh.layers[drop.toTriangle]});
  }
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

  /// In the order of forEachEdge(); kNoLayer without layers.
  LineLayers add(const SharedEdge& edge) {
    if (mesh_.layers.empty()) return {kNoLayer, kNoLayer};
    const LineLayers layers{mesh_.layers[edge.triangles.front()], mesh_.layers[edge.triangles.back()]};
    if (edge.triangles.size() == 1 || layers[0] != layers[1]) known_.push_back({edge.low, edge.high, layers});
    return layers;
  }

  /// After all have been added.
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

void markCovers(EnvironmentGeometry& geometry, DisjointSets& sets) {
  std::vector<std::uint32_t> regions(geometry.surface.size() / 3);
  for (std::uint32_t t = 0; t < regions.size(); ++t)
    regions[t] = static_cast<std::uint32_t>(sets.find(static_cast<Index>(t)));
  const std::vector<bool> covers = findCovers(geometry.surface, regions);
  for (std::size_t t = 0; t < covers.size(); ++t) {
    for (std::size_t k = 0; covers[t] && k < 3; ++k) geometry.surface[3 * t + k].normal[3] |= kCover;
    geometry.covered = geometry.covered || covers[t];
  }
}

// Bins of height with more level floor than their neighbours and than one twentieth of the fullest.
std::vector<double> findFloors(const EnvironmentGeometry& geometry) {
  constexpr std::size_t kBins = 400;
  constexpr double kWorth = 0.05;
  constexpr float kLevelNormal = 0.9F * 127;
  const double height = geometry.upper.z - geometry.lower.z;
  if (!(height > 0)) return {};
  struct Bin {
    double area = 0, areaTimesHeight = 0;
  };
  std::vector<Bin> bins(kBins);
  for (std::size_t v = 0; v + 2 < geometry.surface.size(); v += 3) {
    const SurfaceVertex* corner = &geometry.surface[v];
    if (static_cast<float>(corner->normal[2]) < kLevelNormal) continue;
    const auto at = [&](std::size_t k) {
      return Vec3{corner[k].position[0], corner[k].position[1], corner[k].position[2]};
    };
    const double middle = (at(0).z + at(1).z + at(2).z) / 3;
    const double place = (middle - geometry.lower.z) / height * kBins;
    Bin& bin = bins[static_cast<std::size_t>(std::clamp(place, 0.0, kBins - 1.0))];
    const double area = areaOf(at(0), at(1), at(2));
    bin.area += area;
    bin.areaTimesHeight += area * middle;
  }
  const double most = std::ranges::max_element(bins, {}, &Bin::area)->area;
  constexpr std::size_t kReach = 6;  // of one floor: steps and thresholds are no storeys
  std::vector<double> floors;
  for (std::size_t i = 0; i < kBins; ++i) {
    bool peak = bins[i].area > kWorth * most;
    for (std::size_t k = i > kReach ? i - kReach : 0; peak && k < std::min(kBins, i + kReach + 1); ++k)
      peak = bins[k].area < bins[i].area || (bins[k].area == bins[i].area && k >= i);
    if (peak) floors.push_back(bins[i].areaTimesHeight / bins[i].area);
  }
  return floors;
}

}  // namespace

std::shared_ptr<const EnvironmentGeometry> makeEnvironmentGeometry(const Environment& environment,
                                                                   const std::optional<Vec3>& givenCentre,
                                                                   bool withCovers) {
  auto geometry = std::make_shared<EnvironmentGeometry>();
  const std::vector<Vec3>& vertices = environment.vertices;
  Vec3 lower =
      environment.triangles.empty() ? givenCentre.value_or(Vec3{}) : vertices[environment.triangles.front()[0]];
  Vec3 upper = lower;
  for (const Triangle& triangle : environment.triangles) {
    for (const Vec3* p : cornersOf(vertices, triangle)) {
      lower = {std::min(lower.x, p->x), std::min(lower.y, p->y), std::min(lower.z, p->z)};
      upper = {std::max(upper.x, p->x), std::max(upper.y, p->y), std::max(upper.z, p->z)};
    }
  }
  // Halves first: the sum of two large bounds may overflow.
  const Vec3 middle{lower.x / 2 + upper.x / 2, lower.y / 2 + upper.y / 2, lower.z / 2 + upper.z / 2};
  const Vec3 centre = givenCentre.value_or(middle);
  geometry->centre = centre;
  geometry->lower = {lower.x - centre.x, lower.y - centre.y, lower.z - centre.z};
  geometry->upper = {upper.x - centre.x, upper.y - centre.y, upper.z - centre.z};

  std::vector<Vec3> normals;
  normals.reserve(environment.triangles.size());
  geometry->surface.reserve(environment.triangles.size() * 3);
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    const auto corners = cornersOf(vertices, environment.triangles[t]);
    const bool mayBeFloor = environment.obstacleOnly.empty() || environment.obstacleOnly[t] == 0;
    const Vec3 normal = unitNormal(*corners[0], *corners[1], *corners[2]);
    normals.push_back(normal);
    const double up = environment.bothSides ? std::abs(normal.z) : normal.z;
    addTriangle(geometry->surface, corners, centre, normal, wallPaint(), mayBeFloor && up > kWallNormalZ);
  }

  geometry->extremes = extremePoints(geometry->surface);
  geometry->detailExtremes = extremePoints(detailOf(geometry->surface));

  DisjointSets regions(environment.triangles.size());
  forEachEdge(welded(environment.triangles, vertices), vertices.size(), [&](const SharedEdge& edge) {
    const std::uint32_t first = edge.triangles.front(), last = edge.triangles.back();
    bool crease = edge.triangles.size() != 2;
    if (!crease && isFlat(normals[first], normals[last]))
      regions.unite(static_cast<Index>(first), static_cast<Index>(last));
    if (!crease) crease = isCrease(normals[first], normals[last]);
    if (crease) {
      geometry->creases.push_back({toFloats(vertices[edge.low], centre), toFloats(vertices[edge.high], centre)});
      geometry->creaseTriangles.push_back(edge.triangles.size() > 2 ? std::array{kNoLayer, kNoLayer}
                                                                    : std::array{first, last});
    }
  });
  if (withCovers && !environment.bothSides) markCovers(*geometry, regions);
  geometry->coarse.surface = coarsened(geometry->surface, geometry->coarse.triangles);
  geometry->bothSides = environment.bothSides;
  geometry->floors = findFloors(*geometry);
  return geometry;
}

void setPaint(SurfaceVertex& vertex, const Paint& paint) {
  vertex.normal[3] = static_cast<std::int8_t>((vertex.normal[3] & kCover) | static_cast<int>(paint.pattern));
  vertex.colour = {static_cast<std::uint8_t>(paint.colour.red()), static_cast<std::uint8_t>(paint.colour.green()),
                   static_cast<std::uint8_t>(paint.colour.blue()), 255};
}

std::shared_ptr<const EnvironmentLayers> makeEnvironmentLayers(const NavigationMesh& mesh,
                                                               const Environment& environment) {
  if (mesh.layers.empty()) return nullptr;
  constexpr std::uint32_t kNotSeen = kNoLayer - 1;
  auto layers = std::make_shared<EnvironmentLayers>(environment.triangles.size(), kNotSeen);
  for (const FloorShare& share : floorsUnder(mesh, environment)) {
    std::uint32_t& layer = (*layers)[share.floor];
    const std::uint32_t piece = mesh.layers[share.piece];
    layer = layer == kNotSeen || layer == piece ? piece : kNoLayer;
  }
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
  if (paint) return geometry;  // what was removed shows no lines
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
  const std::vector<VertexPair> steps = stepLines(mesh.links);
  geometry->steps = toSegments(steps, mesh.vertices, centre);
  if (!mesh.layers.empty()) geometry->stepLayers = stepLayers(mesh);
  addGaps(mesh, centre, *geometry);
  addDrops(mesh, centre, *geometry);
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
}

}  // namespace footfall::ui
