// Nearest and random places, many paths, and single layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/base/vector.hpp"
#include "core/navigation/path_ground.hpp"
#include "footfall/errors.hpp"
#include "footfall/ground.hpp"

namespace footfall {
using namespace detail;
namespace {

constexpr std::uint64_t kGoldenRatio = 0x9E3779B97F4A7C15;

/// The mixing function of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
  return x ^ (x >> 31);
}

/// Number `i` of the sequence that belongs to a seed: 53 bits, at least 0 and below 1.
double randomNumber(std::uint64_t mixedSeed, std::uint64_t i) {
  return static_cast<double>(mixed(mixedSeed + (i + 1) * kGoldenRatio) >> 11) * 0x1p-53;
}

/// Areas of the triangles that can be walked on, added up in their order.
std::vector<double> areaSums(const PathGround& ground) {
  const NavigationMesh& mesh = *ground.mesh;
  std::vector<double> sums;
  sums.reserve(mesh.triangles.size());
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& f = mesh.triangles[t];
    if (ground.topology.components[t] != kNoElement)
      sum += areaOf(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]);
    sums.push_back(sum);
  }
  return sums;
}

/// The triangle on which a sum falls. Never one without an area.
std::uint32_t triangleAt(const std::vector<double>& sums, double sum) {
  auto place = std::upper_bound(sums.begin(), sums.end(), sum);
  if (place == sums.end()) place = std::lower_bound(sums.begin(), sums.end(), sums.back());
  return static_cast<std::uint32_t>(place - sums.begin());
}

/// The place of two random numbers in a triangle: equal areas are equally likely.
Vec3 placeIn(const std::array<Vec3, 3>& f, double first, double second) {
  const double root = std::sqrt(first), a = 1 - root, b = root * (1 - second), c = root * second;
  return {a * f[0].x + b * f[1].x + c * f[2].x, a * f[0].y + b * f[1].y + c * f[2].y,
          a * f[0].z + b * f[1].z + c * f[2].z};
}

/// Copies the vertices that a layer uses, in their order.
class LayerVertices {
 public:
  explicit LayerVertices(const NavigationMesh& mesh) : mesh_(mesh), numbers_(mesh.vertices.size(), kNoElement) {}
  void use(std::uint32_t vertex) { numbers_[vertex] = 0; }
  void copyTo(NavigationMesh& layer) {
    for (std::size_t v = 0; v < numbers_.size(); ++v) {
      if (numbers_[v] == kNoElement) continue;
      numbers_[v] = static_cast<std::uint32_t>(layer.vertices.size());
      layer.vertices.push_back(mesh_.vertices[v]);
    }
  }
  [[nodiscard]] std::uint32_t operator[](std::uint32_t vertex) const { return numbers_[vertex]; }
  [[nodiscard]] std::array<std::uint32_t, 2> operator[](const std::array<std::uint32_t, 2>& edge) const {
    return {numbers_[edge[0]], numbers_[edge[1]]};
  }

 private:
  const NavigationMesh& mesh_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace

std::optional<SurfacePlace> nearestPlace(const PathFinder& finder, const Vec3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    throw InputError(FOOTFALL_TEXT("the place has a coordinate that is not finite; give three numbers"));
  return finder.inside()->places.nearest(p);
}

std::vector<SurfacePlace> randomPlaces(const PathFinder& finder, std::size_t count, std::uint64_t seed) {
  const PathGround& ground = *finder.inside();
  const std::vector<double> sums = areaSums(ground);
  const double area = sums.empty() ? 0 : sums.back();
  if (!(area > 0))
    throw InputError(
        FOOTFALL_TEXT("nothing is walkable, so there is no place to choose; check that the area is not 0"));
  if (!std::isfinite(area))
    throw InputError(FOOTFALL_TEXT("the walkable area is too large for random places; use a larger unit"));
  const std::uint64_t mixedSeed = mixed(seed + kGoldenRatio);
  std::vector<SurfacePlace> places(count);
  parallelRanges(count, 1024, [&](const NumberRange<std::size_t>& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const std::uint32_t t = triangleAt(sums, randomNumber(mixedSeed, 3 * i) * area);
      const Triangle& f = ground.mesh->triangles[t];
      const std::array<Vec3, 3> corners{ground.mesh->vertices[f[0]], ground.mesh->vertices[f[1]],
                                        ground.mesh->vertices[f[2]]};
      const Vec3 place = placeIn(corners, randomNumber(mixedSeed, 3 * i + 1), randomNumber(mixedSeed, 3 * i + 2));
      places[i] = ground.places.nearestInside(place, t);
      places[i].distance = 0;
    }
  });
  return places;
}

std::vector<PathResult> findPaths(const PathFinder& finder, std::span<const std::array<Vec3, 2>> pairs, double reach,
                                  const RunContext* context) {
  std::vector<PathResult> paths(pairs.size());
  parallelFor(pairs.size(), [&](std::size_t i) { paths[i] = finder.find(pairs[i][0], pairs[i][1], reach, context); });
  return paths;
}

NavigationMesh layerOf(const NavigationMesh& mesh, std::uint32_t layer) {
  const std::uint32_t layerCount = mesh.layers.empty() ? 0 : mesh.layerCount;
  if (layer >= layerCount)
    throw InputError(
        layerCount == 0
            ? Text(FOOTFALL_TEXT("the mesh has no layers; end the pipeline with a layer filter"))
            : Text(FOOTFALL_TEXT("there is no layer %1; give a number from 0 to %2"), layer, layerCount - 1));
  LayerVertices vertices(mesh);
  std::vector<std::uint32_t> numbers(mesh.triangles.size(), kNoElement);
  NavigationMesh only;
  only.frame = mesh.frame;
  only.layerCount = 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.layers[t] != layer) continue;
    for (const std::uint32_t vertex : mesh.triangles[t]) vertices.use(vertex);
  }
  vertices.copyTo(only);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.layers[t] != layer) continue;
    const Triangle& f = mesh.triangles[t];
    numbers[t] = static_cast<std::uint32_t>(only.triangles.size());
    only.triangles.push_back({vertices[f[0]], vertices[f[1]], vertices[f[2]]});
    if (!mesh.sourceTriangles.empty()) only.sourceTriangles.push_back(mesh.sourceTriangles[t]);
  }
  only.layers.assign(only.triangles.size(), 0);
  const auto isIn = [&](const std::array<std::uint32_t, 2>& edge) {
    return vertices[edge[0]] != kNoElement && vertices[edge[1]] != kNoElement;
  };
  for (const auto& edge : mesh.obstacleEdges)
    if (isIn(edge)) only.obstacleEdges.push_back(vertices[edge]);
  for (StepLink link : mesh.links) {
    if (numbers[link.fromTriangle] == kNoElement || numbers[link.toTriangle] == kNoElement) continue;
    link.from = vertices[link.from];
    link.to = vertices[link.to];
    link.fromTriangle = numbers[link.fromTriangle];
    link.toTriangle = numbers[link.toTriangle];
    only.links.push_back(link);
  }
  for (DropLink drop : mesh.drops) {
    if (numbers[drop.fromTriangle] == kNoElement || numbers[drop.toTriangle] == kNoElement) continue;
    drop.from = vertices[drop.from];
    drop.fromTriangle = numbers[drop.fromTriangle];
    drop.toTriangle = numbers[drop.toTriangle];
    only.drops.push_back(drop);
  }
  return only;
}

}  // namespace footfall
