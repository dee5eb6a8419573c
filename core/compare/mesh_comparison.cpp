// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/base/disjoint_sets.hpp"
#include "core/compare/comparison_distances.hpp"
#include "core/compare/comparison_plan.hpp"
#include "core/compare/link_difference.hpp"
#include "core/mesh/adjacency.hpp"
#include "footfall/compare.hpp"
#include "footfall/errors.hpp"

namespace footfall {
using namespace detail;
namespace {

using comparison::ComparedSurfaces;

using Edge = std::array<std::uint32_t, 2>;

double length(const NavigationMesh& mesh, const std::vector<Edge>& edges) {
  long double sum = 0;
  for (const Edge& edge : edges) {
    const Vec3 &a = mesh.vertices[edge[0]], &b = mesh.vertices[edge[1]];
    sum += std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
  }
  return static_cast<double>(sum);
}

/// Components of each layer; everything is layer 0 where `layered` is false.
std::vector<std::size_t> countComponents(const NavigationMesh& mesh, const Adjacency& adjacency, bool layered) {
  const auto layerOf = [&](Index triangle) { return layered ? mesh.layers[triangle] : 0; };
  std::vector<std::size_t> counts(layered ? mesh.layerCount : 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) ++counts[layerOf(static_cast<Index>(t))];
  DisjointSets sets(mesh.triangles.size());
  std::vector<Index> around;  // triangles at one edge, by layer
  for (Index e = 0; e < adjacency.edgeCount(); ++e) {
    around.clear();
    for (const Index side : adjacency.sidesOf(e)) around.push_back(side / 3);
    std::ranges::stable_sort(around, {}, layerOf);
    for (std::size_t i = 1; i < around.size(); ++i)
      if (layerOf(around[i]) == layerOf(around[i - 1]) && sets.unite(around[i - 1], around[i]))
        --counts[layerOf(around[i])];
  }
  for (const StepLink& link : mesh.links) {
    const auto from = static_cast<Index>(link.fromTriangle), to = static_cast<Index>(link.toTriangle);
    if (layerOf(from) == layerOf(to) && sets.unite(from, to)) --counts[layerOf(from)];
  }
  return counts;
}

/// Adds up in more digits than the result has.
struct AreaSum {
  long double surface = 0, plan = 0;
  void add(const SurfaceArea& areas) {
    surface += areas.surface;
    plan += areas.plan;
  }
  [[nodiscard]] SurfaceArea total() const { return {static_cast<double>(surface), static_cast<double>(plan)}; }
};

struct PartSums {
  std::size_t triangles = 0, proper = 0;
  AreaSum areas, uncovered;
  void addTo(MeshPart& part) const {
    part.triangles = triangles;
    part.degenerate = triangles - proper;
    part.areas = areas.total();
    part.uncovered = uncovered.total();
  }
};

void describeLinks(const NavigationMesh& mesh, MeshDescription& description) {
  description.links = mesh.links.size();
  long double sum = 0;
  for (const StepLink& link : mesh.links) {
    const auto& edge = comparison::isAlongFirstEdge(mesh, link) ? link.from : link.to;
    const Vec3 &a = mesh.vertices[edge[0]], &b = mesh.vertices[edge[1]];
    sum += std::hypot(b.x - a.x, b.y - a.y);
    description.highestLink = std::max(description.highestLink, link.height);
    description.gaps += link.kind == StepKind::Gap ? 1 : 0;
    description.widestGap = std::max(description.widestGap, link.width);
  }
  description.linkLength = static_cast<double>(sum);
}

void describeDrops(const NavigationMesh& mesh, MeshDescription& description) {
  description.drops = mesh.drops.size();
  long double sum = 0;
  for (const DropLink& drop : mesh.drops) {
    sum += drop.width;
    description.deepestDrop = std::max(description.deepestDrop, drop.depth);
  }
  description.dropLength = static_cast<double>(sum);
}

/// Starts and landings, in an order of their own.
std::vector<std::array<Vec3, 4>> dropPlaces(const NavigationMesh& mesh) {
  std::vector<std::array<Vec3, 4>> places;
  for (const DropLink& drop : mesh.drops)
    places.push_back({drop.start[0], drop.start[1], drop.landing[0], drop.landing[1]});
  const auto before = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::sort(places.begin(), places.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
  return places;
}

MeshDescription describe(const NavigationMesh& mesh, const comparison::Surface& surface,
                         const std::vector<SurfaceArea>& areas, const std::vector<SurfaceArea>& uncovered,
                         RunContext& context) {
  MeshDescription description;
  description.vertices = mesh.vertices.size();
  description.positions = surface.positions.size();
  description.connections = mesh.connections.size();
  description.connectionLength = length(mesh, mesh.connections);
  description.obstacleEdges = mesh.obstacleEdges.size();
  description.obstacleEdgeLength = length(mesh, mesh.obstacleEdges);
  describeLinks(mesh, description);
  describeDrops(mesh, description);

  PartSums whole;
  std::vector<PartSums> layers(mesh.layers.empty() ? 0 : mesh.layerCount);
  const auto forPartsOf = [&](std::size_t triangle, const auto& change) {
    change(whole);
    if (!layers.empty()) change(layers[mesh.layers[triangle]]);
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) forPartsOf(i, [](PartSums& part) { ++part.triangles; });
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    forPartsOf(surface.numbers[i], [&](PartSums& part) {
      ++part.proper;
      part.areas.add(areas[i]);
      part.uncovered.add(uncovered[i]);
    });
  }
  context.checkCancelled();
  whole.addTo(description.whole);
  const Adjacency adjacency = findEdges(mesh.triangles, mesh.vertices.size(), context);
  description.whole.components = countComponents(mesh, adjacency, false)[0];
  if (layers.empty()) return description;
  context.checkCancelled();
  const std::vector<std::size_t> components = countComponents(mesh, adjacency, true);
  for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
    MeshPart& part = description.layers.emplace_back();
    part.name = "layer_" + std::to_string(layer);
    layers[layer].addTo(part);
    part.components = components[layer];
  }
  return description;
}

/// The largest coordinate, and the diagonal of the box around both meshes, in doubles.
struct Extent {
  double largest = 0, diagonal = 0;
};

Extent extentOf(const NavigationMesh& a, const NavigationMesh& b) {
  Extent extent;
  std::array<double, 3> low{}, high{};
  bool first = true;
  for (const NavigationMesh* mesh : {&a, &b}) {
    for (const Triangle& triangle : mesh->triangles) {
      for (const std::uint32_t v : triangle) {
        const std::array<double, 3> p = {mesh->vertices[v].x, mesh->vertices[v].y, mesh->vertices[v].z};
        for (std::size_t k = 0; k < 3; ++k) {
          extent.largest = std::max(extent.largest, std::fabs(p[k]));
          low[k] = first ? p[k] : std::min(low[k], p[k]);
          high[k] = first ? p[k] : std::max(high[k], p[k]);
        }
        first = false;
      }
    }
  }
  extent.diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  return extent;
}

/// The power of two at or below x, so that a height of x costs no digits; 0 for 0.
double powerOfTwo(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return x > 0 ? std::ldexp(1.0, exponent - 1) : 0;
}

/// A bound of the distance from each triangle to the other surface. A triangle shrunk by a factor f towards one of its
/// points lies inside it, within f diameters of that point. When the part that is not covered is smaller than the
/// shrunk triangle, so is a covered point within that distance, and the other surface within the height of it.
std::vector<double> knownDistances(const ComparedSurfaces& surfaces, std::size_t set, const SetDifference& sets,
                                   const std::vector<SurfaceArea>& uncovered, double height) {
  constexpr double kRounding = 1 + 0x1p-20;  // far more than the few operations below need
  const auto& places = surfaces.positions.places;
  std::vector<double> known(uncovered.size(), 0);
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (sets.covered[set][i] != 0) continue;
    double diameter = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = places[surfaces.surfaces[set].triangles[i][k]],
                 &b = places[surfaces.surfaces[set].triangles[i][(k + 1) % 3]];
      diameter = std::max(diameter, std::hypot(b.x - a.x, b.y - a.y, b.z - a.z));
    }
    // The second summand is for corners that were rounded to 2^-192 of the extent, even where the triangle is so thin
    // that its height is 2^-90 of that.
    const double share = uncovered[i].surface / sets.triangleAreas[set][i].surface + 0x1p-100;
    known[i] = share < 1 && sets.triangleAreas[set][i].plan > 0 ? kRounding * (height + diameter * std::sqrt(share))
                                                                : std::numeric_limits<double>::infinity();
  }
  return known;
}

}  // namespace

double MeshComparison::covered() const {
  const MeshPart& a = meshes[0].whole;
  return a.areas.surface > 0 ? std::max(0.0, 1 - a.uncovered.surface / a.areas.surface) : 1;
}

std::optional<double> MeshComparison::areaRatio() const {
  if (!(meshes[0].whole.areas.surface > 0)) return std::nullopt;
  return meshes[1].whole.areas.surface / meshes[0].whole.areas.surface;
}

MeshComparison compareMeshes(const NavigationMesh& a, const NavigationMesh& b, const ComparisonOptions& options,
                             RunContext* givenContext) {
  RunContext ownContext;
  RunContext& context = givenContext != nullptr ? *givenContext : ownContext;
  const Extent extent = extentOf(a, b);
  MeshComparison result;
  result.height = options.height.value_or(powerOfTwo(extent.largest * 0x1p-30));
  result.error = options.error.value_or(extent.diagonal / 1000);
  if (!(std::isfinite(result.height) && result.height >= 0 && result.height <= 1e100))
    throw InputError(FOOTFALL_TEXT("the height must be a length in the files' units: 0 or more"));
  if (!(std::isfinite(result.error) && (result.error > 0 || !options.error)))
    throw InputError(FOOTFALL_TEXT("the error must be a length in the files' units: above 0"));

  context.beginStep(0, "reading positions");
  const ComparedSurfaces surfaces = comparison::makeSurfaces(a, b, result.height, context);
  context.endStep();
  context.beginStep(1, "exact sets");
  result.sets = comparison::subtractSets(surfaces, context);
  result.links = comparison::subtractLinks(surfaces, a, b, context);
  result.equalDrops = dropPlaces(a) == dropPlaces(b);
  context.endStep();
  context.beginStep(2, "plan");
  const auto uncovered = comparison::findUncovered(surfaces, result.sets, result.height, context);
  std::array<std::vector<double>, 2> known;
  for (const std::size_t set : {0, 1}) {
    known[set] = knownDistances(surfaces, set, result.sets, uncovered[set], result.height);
    result.meshes[set] =
        describe(set == 0 ? a : b, surfaces.surfaces[set], result.sets.triangleAreas[set], uncovered[set], context);
  }
  context.endStep();
  context.beginStep(3, "distances");
  if (!surfaces.surfaces[0].triangles.empty() && !surfaces.surfaces[1].triangles.empty())
    result.distances = comparison::measureDistances(surfaces, known, result.error, context);
  context.endStep();
  return result;
}

}  // namespace footfall
