// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/render_geometry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/geometry/coarse_geometry.hpp"
#include "ui/view/geometry/level_covers.hpp"
#include "ui/view/geometry/surface_triangles.hpp"

namespace footfall::ui {
namespace {

// Steeper surfaces are drawn as walls, because stripes on walls would only be noise.
constexpr double kWallNormalZ = 0.02;
constexpr double kFlatCosine = 0.999;

bool isFlat(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z > kFlatCosine; }

struct PositionHash {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t h = 0;
    for (const double d : {p.x, p.y, p.z}) h = (h ^ std::bit_cast<std::uint64_t>(d + 0.0)) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(h ^ (h >> 32U));
  }
};

// The triangles with each corner replaced by the first vertex at the same position, because soups repeat their
// vertices.
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

// The outermost corners in the 98 directions of a 5 x 5 x 5 grid's surface, each of which has an opposite one.
std::vector<Vec3> extremePoints(const std::vector<SurfaceVertex>& surface) {
  std::vector<std::array<float, 3>> directions;
  for (int direction = 0; direction < 125 / 2; ++direction) {
    const std::array<int, 3> d{direction % 5 - 2, direction / 5 % 5 - 2, direction / 25 - 2};
    if (std::ranges::any_of(d, [](int c) { return std::abs(c) == 2; }))
      directions.push_back({static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2])});
  }
  struct Farthest {
    float reach = -std::numeric_limits<float>::infinity();
    std::size_t vertex = 0;
    void include(const Farthest& other) {
      if (other.reach > reach) *this = other;
    }
  };
  using Ends = std::array<Farthest, 2>;
  // The work is done in blocks that fit into the nearest cache; otherwise a million triangles would be read from memory
  // for each direction.
  constexpr std::size_t kBlock = 512;
  constexpr std::size_t kBlocksPerTask = 64;
  const std::size_t blocks = (surface.size() + kBlock - 1) / kBlock;
  std::vector<std::vector<Ends>> parts((blocks + kBlocksPerTask - 1) / kBlocksPerTask);
  forRanges(parts.size(), 1, [&](std::size_t part, std::size_t) {
    std::vector<Ends>& ends = parts[part];
    ends.resize(directions.size());
    for (std::size_t block = part * kBlocksPerTask; block < std::min(blocks, (part + 1) * kBlocksPerTask); ++block) {
      const std::size_t end = std::min(surface.size(), (block + 1) * kBlock);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto& d = directions[i];
        auto [least, most] = ends[i];
        for (std::size_t v = block * kBlock; v < end; ++v) {
          const auto& p = surface[v].position;
          const float reach = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
          if (reach > most.reach) most = {reach, v};
          if (-reach > least.reach) least = {-reach, v};
        }
        ends[i] = {least, most};
      }
    }
  });
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < directions.size() && !surface.empty(); ++i) {
    Ends all;
    for (const std::vector<Ends>& part : parts) {
      for (std::size_t k = 0; k < 2; ++k) all[k].include(part[i][k]);
    }
    for (const Farthest& farthest : all) {
      const auto& far = surface[farthest.vertex].position;
      points.push_back({far[0], far[1], far[2]});
    }
  }
  return points;
}

// The corners of all triangles within a margin around the middle ones along x and y, where they take a small part of
// the extent.
std::optional<std::vector<SurfaceVertex>> detailOf(const std::vector<SurfaceVertex>& surface) {
  constexpr std::size_t kOutside = 50;  // one corner in this many is outside on either side
  constexpr float kSmallPart = 0.3F;
  if (surface.size() < 4 * kOutside) return std::nullopt;
  std::array<float, 2> lower{};
  std::array<float, 2> upper{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<float> values;
    values.reserve(surface.size());
    for (const SurfaceVertex& vertex : surface) values.push_back(vertex.position[axis]);
    const auto outside = static_cast<std::ptrdiff_t>(values.size() / kOutside);
    const auto low = values.begin() + outside;
    const auto high = values.end() - 1 - outside;
    std::nth_element(values.begin(), low, values.end());
    std::nth_element(low, high, values.end());
    lower[axis] = *low;
    upper[axis] = *high;
    const float extent = upper[axis] - lower[axis];
    const float all = *std::max_element(high, values.end()) - *std::min_element(values.begin(), low + 1);
    if (!(extent < kSmallPart * all)) return std::nullopt;
    lower[axis] -= 0.1F * extent;
    upper[axis] += 0.1F * extent;
  }
  std::vector<SurfaceVertex> detail;
  std::copy_if(surface.begin(), surface.end(), std::back_inserter(detail), [&](const SurfaceVertex& v) {
    return v.position[0] >= lower[0] && v.position[0] <= upper[0] && v.position[1] >= lower[1] &&
           v.position[1] <= upper[1];
  });
  return detail;
}

std::vector<Vec3> detailExtremesOf(const std::vector<SurfaceVertex>& surface, const std::vector<Vec3>& extremes) {
  const auto detail = detailOf(surface);
  return detail ? extremePoints(*detail) : extremes;
}

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

// Bins of height with more level floor than their neighbours and than one twentieth of the fullest bin.
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
  constexpr std::size_t kReach = 6;  // bins of one floor: steps and thresholds are no storeys
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
                                                                   bool withCovers,
                                                                   std::shared_ptr<const WholeBounds> whole) {
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
  // The bounds are halved first, because the sum of two large bounds may overflow.
  const Vec3 middle{lower.x / 2 + upper.x / 2, lower.y / 2 + upper.y / 2, lower.z / 2 + upper.z / 2};
  const Vec3 centre = whole ? whole->centre : givenCentre.value_or(middle);
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

  if (!whole) {
    geometry->extremes = extremePoints(geometry->surface);
    geometry->detailExtremes = detailExtremesOf(geometry->surface, geometry->extremes);
  }

  const auto isFloor = [&](std::uint32_t t) { return geometry->surface[std::size_t{3} * t].colour[3] == 0; };
  DisjointSets regions(environment.triangles.size());
  forEachEdge(welded(environment.triangles, vertices), vertices.size(), [&](const SharedEdge& edge) {
    const std::uint32_t first = edge.triangles.front(), last = edge.triangles.back();
    bool crease = edge.triangles.size() != 2;
    if (!crease && isFlat(normals[first], normals[last]))
      regions.unite(static_cast<Index>(first), static_cast<Index>(last));
    if (!crease) crease = isCrease(normals[first], normals[last]);
    if (crease) {
      geometry->creases.push_back({toFloats(vertices[edge.low], centre), toFloats(vertices[edge.high], centre)});
      const bool some = edge.triangles.size() > 2 && !std::ranges::all_of(edge.triangles, isFloor);
      geometry->creaseTriangles.push_back(some ? std::array{kNoLayer, kNoLayer} : std::array{first, last});
    }
  });
  if (withCovers && !environment.bothSides) markCovers(*geometry, regions);
  geometry->coarse.surface = coarsened(geometry->surface, geometry->coarse.triangles);
  geometry->bothSides = environment.bothSides;
  geometry->floors = findFloors(*geometry);
  if (whole) {
    geometry->lower = whole->lower;
    geometry->upper = whole->upper;
    geometry->extremes = whole->extremes;
    geometry->detailExtremes = whole->detailExtremes;
    geometry->whole = std::move(whole);
  }
  return geometry;
}

std::shared_ptr<const WholeBounds> makeWholeBounds(const Vec3& lower, const Vec3& upper, const Vec3& centre,
                                                   const std::vector<SurfaceVertex>& surface) {
  WholeBounds bounds{centre, lower - centre, upper - centre, extremePoints(surface), {}};
  bounds.detailExtremes = detailExtremesOf(surface, bounds.extremes);
  return std::make_shared<const WholeBounds>(std::move(bounds));
}

void setPaint(SurfaceVertex& vertex, const Paint& paint) {
  vertex.normal[3] = static_cast<std::int8_t>((vertex.normal[3] & kCover) | static_cast<int>(paint.pattern));
  vertex.colour = {static_cast<std::uint8_t>(paint.colour.red()), static_cast<std::uint8_t>(paint.colour.green()),
                   static_cast<std::uint8_t>(paint.colour.blue()), 255};
}

}  // namespace footfall::ui
