// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/surface_difference.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"
#include "core/compare/comparison_plan.hpp"
#include "core/compare/cover_triangles.hpp"

namespace footfall::detail {
namespace {

using comparison::CoverCorner;
using comparison::CoverPiece;
using comparison::CoverTriangle;
using comparison::DifferentPlane;

constexpr std::size_t kRange = 4096;

std::tuple<double, double, double> key(const Vec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

/// A triangle of one of both meshes by its corners, whatever their order.
struct Corners {
  std::array<Vec3, 3> at;
  std::uint32_t mesh, triangle;
};

bool sameCorners(const Corners& a, const Corners& b) { return a.at == b.at; }

Box boxOf(const NavigationMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

/// The triangles that matter to the difference: those of one mesh alone, and what lies beside them. A place that
/// triangles of one mesh alone cover keeps all that covers it; any other place is covered by both meshes or by none.
class Reduction {
 public:
  Reduction(const NavigationMesh& first, const NavigationMesh& second, RunContext& context)
      : meshes_{&first, &second}, context_(context) {}

  /// `height`: how far above or below it is beside.
  std::array<NavigationMesh, 2> run(double height) {
    findCommon();
    std::vector<Box> boxes;
    std::vector<std::int32_t> ids;
    for (std::size_t m = 0; m < 2; ++m) {
      for (std::uint32_t t = 0; t < kept_[m].size(); ++t) {
        if (kept_[m][t] == 0) continue;
        boxes.push_back(boxOf(*meshes_[m], t));
        boxes.back().lower[2] -= 2 * height;
        boxes.back().upper[2] += 2 * height;
        ids.push_back(static_cast<std::int32_t>(ids.size()));
      }
    }
    if (boxes.empty()) return {};
    TriangleTree tree;
    tree.build(boxes, ids, context_);
    std::array<NavigationMesh, 2> reduced;
    for (std::size_t m = 0; m < 2; ++m) {
      keepNeighbours(m, tree);
      reduced[m].vertices = meshes_[m]->vertices;
      for (std::uint32_t t = 0; t < kept_[m].size(); ++t)
        if (kept_[m][t] != 0) reduced[m].triangles.push_back(meshes_[m]->triangles[t]);
    }
    return reduced;
  }

 private:
  /// Marks what is not in both meshes.
  void findCommon() {
    std::vector<Corners> all(meshes_[0]->triangles.size() + meshes_[1]->triangles.size());
    const std::size_t split = meshes_[0]->triangles.size();
    forRanges(all.size(), kRange, [&](std::size_t first, std::size_t last) {
      context_.checkCancelled();
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t m = i < split ? 0 : 1;
        const auto number = static_cast<std::uint32_t>(i - m * split);
        const Triangle& t = meshes_[m]->triangles[number];
        Corners& corners = all[i];
        corners = {{meshes_[m]->vertices[t[0]], meshes_[m]->vertices[t[1]], meshes_[m]->vertices[t[2]]}, m, number};
        std::ranges::sort(corners.at, {}, key);
      }
    });
    parallelSort(all.begin(), all.end(), [](const Corners& a, const Corners& b) {
      for (std::size_t k = 0; k < 3; ++k)
        if (a.at[k] != b.at[k]) return key(a.at[k]) < key(b.at[k]);
      return std::pair(a.mesh, a.triangle) < std::pair(b.mesh, b.triangle);
    });
    context_.checkCancelled();
    for (std::size_t m = 0; m < 2; ++m) kept_[m].assign(meshes_[m]->triangles.size(), 0);
    for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
      for (next = i + 1; next < all.size() && sameCorners(all[next], all[i]);) ++next;
      if (all[i].mesh != all[next - 1].mesh) continue;
      for (std::size_t k = i; k < next; ++k) kept_[all[k].mesh][all[k].triangle] = 1;
    }
  }

  void keepNeighbours(std::size_t m, const TriangleTree& tree) {
    std::vector<char> beside(kept_[m].size(), 0);
    forRanges(kept_[m].size(), kRange, [&](std::size_t first, std::size_t last) {
      context_.checkCancelled();
      std::vector<std::int32_t> stack;
      for (std::size_t t = first; t < last; ++t) {
        if (kept_[m][t] != 0) continue;
        tree.visitOverlapping(boxOf(*meshes_[m], static_cast<std::uint32_t>(t)), stack, [&](std::int32_t) {
          beside[t] = 1;
          return false;
        });
      }
    });
    for (std::size_t t = 0; t < beside.size(); ++t)
      if (beside[t] != 0) kept_[m][t] = 1;
  }

  std::array<const NavigationMesh*, 2> meshes_;
  RunContext& context_;
  std::array<std::vector<char>, 2> kept_;
};

/// Turns a plane's corners into places.
class PlaneLift {
 public:
  PlaneLift(const DifferentPlane& plane, const comparison::Positions& positions)
      : plane_(plane), positions_(positions), x_((plane.axis + 1) % 3), y_((plane.axis + 2) % 3) {
    origin_ = coordinates(positions.places[plane.positions.front()]);
  }

  [[nodiscard]] Vec3 at(const CoverCorner& corner) const {
    if (corner.point != CoverCorner::kNoPoint) return positions_.places[plane_.positions[corner.point]];
    std::array<double, 3> p{};
    p[x_] = std::ldexp(corner.x, positions_.unit);
    p[y_] = std::ldexp(corner.y, positions_.unit);
    p[plane_.axis] = origin_[plane_.axis] - plane_.numbers[x_] / plane_.numbers[plane_.axis] * (p[x_] - origin_[x_]) -
                     plane_.numbers[y_] / plane_.numbers[plane_.axis] * (p[y_] - origin_[y_]);
    return {p[0], p[1], p[2]};
  }

 private:
  static std::array<double, 3> coordinates(const Vec3& p) { return {p.x, p.y, p.z}; }

  const DifferentPlane& plane_;
  const comparison::Positions& positions_;
  std::size_t x_, y_;
  std::array<double, 3> origin_{};
};

/// Triangles of one mesh's part, with numbers of what hangs together in their planes.
struct PartTriangles {
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<std::uint32_t> groups;
  std::uint32_t groupCount = 0;

  void add(const std::vector<std::array<Vec3, 3>>& more, const std::vector<std::uint32_t>& group) {
    std::uint32_t most = 0;
    for (std::size_t i = 0; i < more.size(); ++i) {
      triangles.push_back(more[i]);
      groups.push_back(groupCount + group[i]);
      most = std::max(most, group[i] + 1);
    }
    groupCount += most;
  }
};

/// The place of a corner in the plane of a triangle that is not vertical.
Vec3 liftedTo(const std::array<Vec3, 3>& f, const CoverCorner& corner) {
  const double ux = f[1].x - f[0].x, uy = f[1].y - f[0].y, vx = f[2].x - f[0].x, vy = f[2].y - f[0].y;
  const double area = ux * vy - uy * vx, px = corner.x - f[0].x, py = corner.y - f[0].y;
  const double a = (px * vy - py * vx) / area, b = (ux * py - uy * px) / area;
  return {corner.x, corner.y, f[0].z + a * (f[1].z - f[0].z) + b * (f[2].z - f[0].z)};
}

void addUncovered(const comparison::ComparedSurfaces& surfaces, const SetDifference& sets, double height,
                  std::array<PartTriangles, 2>& parts, SurfaceDifference& difference, RunContext& context) {
  const auto uncovered = findUncoveredParts(surfaces, sets, height, context);
  const std::vector<Vec3>& places = surfaces.positions.places;
  for (std::size_t m = 0; m < 2; ++m) {
    for (const comparison::UncoveredPart& part : uncovered[m]) {
      const Triangle& t = surfaces.surfaces[m].triangles[part.triangle];
      const std::array<Vec3, 3> f{places[t[0]], places[t[1]], places[t[2]]};
      std::vector<std::array<Vec3, 3>> triangles;
      std::vector<std::uint32_t> groups;
      for (const CoverTriangle& piece : part.triangles) {
        std::array<Vec3, 3>& corners = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const CoverCorner& corner = piece.corners[k];
          corners[k] = corner.point == CoverCorner::kNoPoint ? liftedTo(f, corner) : places[corner.point];
          if (corner.point != t[0] && corner.point != t[1] && corner.point != t[2])
            corners[k].z = liftedTo(f, corner).z;
        }
        groups.push_back(piece.region);
      }
      parts[m].add(triangles, groups);
      difference.hasArea[m] = true;
      difference.areas[m].surface += part.areas.surface;
      difference.areas[m].plan += part.areas.plan;
    }
  }
}

void addPlanes(const comparison::DifferenceBorders& borders, const comparison::Positions& positions,
               std::array<PartTriangles, 2>& parts, RunContext& context) {
  struct Lifted {
    std::array<std::vector<std::array<Vec3, 3>>, 2> triangles;
    std::array<std::vector<std::uint32_t>, 2> groups;
  };
  std::vector<Lifted> lifted(borders.planes.size());
  forRanges(lifted.size(), 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const DifferentPlane& plane = borders.planes[i];
      const PlaneLift lift(plane, positions);
      for (std::size_t m = 0; m < 2; ++m) {
        std::vector<CoverPiece> pieces;
        for (const CoverPiece& piece : plane.borders)
          if (piece.part == m) pieces.push_back(piece);
        for (const CoverTriangle& t : triangulatePart(pieces, context)) {
          lifted[i].triangles[m].push_back({lift.at(t.corners[0]), lift.at(t.corners[1]), lift.at(t.corners[2])});
          lifted[i].groups[m].push_back(t.region);
        }
      }
    }
  });
  for (const Lifted& plane : lifted)
    for (std::size_t m = 0; m < 2; ++m) parts[m].add(plane.triangles[m], plane.groups[m]);
}

/// Joins groups whose corners meet, and lists what comes out.
void addRegions(const PartTriangles& part, std::uint32_t mesh, SurfaceDifference& difference) {
  DisjointSets sets(part.groupCount);
  std::map<std::tuple<double, double, double>, std::uint32_t> at;
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    for (const Vec3& corner : part.triangles[i]) {
      const auto [known, isNew] = at.emplace(key(corner), part.groups[i]);
      if (!isNew) sets.unite(static_cast<Index>(known->second), static_cast<Index>(part.groups[i]));
    }
  }
  std::map<Index, std::uint32_t> numbers;
  std::vector<std::uint32_t>& regionOf = difference.regionOf[mesh];
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto next = static_cast<std::uint32_t>(difference.regions.size());
    const auto [number, isNew] = numbers.emplace(sets.find(static_cast<Index>(part.groups[i])), next);
    if (isNew) {
      const Vec3& p = part.triangles[i][0];
      difference.regions.push_back({mesh, 0, p, p});
    }
    DifferentRegion& region = difference.regions[number->second];
    region.area += areaOf(part.triangles[i][0], part.triangles[i][1], part.triangles[i][2]);
    for (const Vec3& p : part.triangles[i]) {
      region.lower = {std::min(region.lower.x, p.x), std::min(region.lower.y, p.y), std::min(region.lower.z, p.z)};
      region.upper = {std::max(region.upper.x, p.x), std::max(region.upper.y, p.y), std::max(region.upper.z, p.z)};
    }
    regionOf.push_back(number->second);
  }
}

void sortRegions(SurfaceDifference& difference) {
  std::vector<std::uint32_t> order(difference.regions.size()), place(order.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::uint32_t i) { return difference.regions[i].area; });
  std::vector<DifferentRegion> sorted;
  sorted.reserve(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted.push_back(difference.regions[order[i]]);
  }
  difference.regions = std::move(sorted);
  for (std::vector<std::uint32_t>& regionOf : difference.regionOf)
    for (std::uint32_t& region : regionOf) region = place[region];
}

}  // namespace

double roundingHeight(const NavigationMesh& first, const NavigationMesh& second) {
  double largest = 0;
  for (const NavigationMesh* mesh : {&first, &second})
    for (const Vec3& p : mesh->vertices) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > 0 ? std::ldexp(1.0, exponent - 1 - 30) : 0;
}

SurfaceDifference subtractSurfaces(const NavigationMesh& first, const NavigationMesh& second, RunContext& context,
                                   double height) {
  SurfaceDifference difference;
  const std::array<NavigationMesh, 2> meshes = Reduction(first, second, context).run(height);
  if (meshes[0].triangles.empty() && meshes[1].triangles.empty()) return difference;
  const comparison::ComparedSurfaces surfaces = comparison::makeSurfaces(meshes[0], meshes[1], height, context);
  comparison::DifferenceBorders borders;
  const bool isExact = height == 0;
  const SetDifference sets = subtractSets(surfaces, context, isExact ? &borders : nullptr);
  std::array<PartTriangles, 2> parts;
  if (!isExact) addUncovered(surfaces, sets, height, parts, difference, context);
  for (std::uint32_t m = 0; isExact && m < 2; ++m) {
    difference.hasArea[m] = sets.hasArea[m];
    difference.areas[m] = sets.areas[m];
    for (const std::uint32_t t : borders.triangles[m]) {
      const Triangle& f = surfaces.surfaces[m].triangles[t];
      const auto& places = surfaces.positions.places;
      parts[m].add({{places[f[0]], places[f[1]], places[f[2]]}}, {0});
    }
  }
  addPlanes(borders, surfaces.positions, parts, context);
  for (std::uint32_t m = 0; m < 2; ++m) {
    addRegions(parts[m], m, difference);
    difference.triangles[m] = std::move(parts[m].triangles);
    context.checkCancelled();
  }
  sortRegions(difference);
  return difference;
}

}  // namespace footfall::detail
