// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_regions.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/vector.hpp"
#include "core/filters/root_sum.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "core/tiles/tile_geometry.hpp"

namespace footfall::detail {
namespace {

/// Areas of a tile's triangles, in scaled coordinates.
class TileAreas {
 public:
  TileAreas(const Tile& tile, const Grid& grid) : tile_(tile), scale_(grid.scaleExponent()) {}

  /// Twice the area.
  [[nodiscard]] ErrorDouble of(const MeshTriangle& triangle) const {
    std::array<ErrorDouble, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = triangle.corners[k];
      x[k] = scaled(tile_.places[v].x, tile_.exact[v] != 0);
      y[k] = scaled(tile_.places[v].y, tile_.exact[v] != 0);
    }
    const ErrorDouble plan = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const std::array<Vec3, 3>& f = tile_.faces[triangle.face].corners;
    const auto side = [&](std::size_t k) {
      return std::array<ErrorDouble, 3>{scaled(f[k].x, true) - scaled(f[0].x, true),
                                        scaled(f[k].y, true) - scaled(f[0].y, true),
                                        scaled(f[k].z, true) - scaled(f[0].z, true)};
    };
    const auto n = cross(side(1), side(2));
    return plan * squareRoot(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / n[2];
  }

 private:
  // The nearest double is at most half a unit in its last place away, or half of the smallest double.
  [[nodiscard]] ErrorDouble scaled(double x, bool isExact) const {
    const double value = std::ldexp(x, scale_);
    return isExact ? ErrorDouble(value)
                   : ErrorDouble(value, std::fabs(value) * 0x1p-52 + std::ldexp(0x1p-1074, scale_));
  }

  const Tile& tile_;
  int scale_;
};

}  // namespace

TileRegions findTileRegions(const Tile& tile, const Grid& grid, Poll poll) {
  TileRegions regions;
  std::vector<char> isBorder(tile.places.size(), 0);
  for (const TileBorder& border : tile.borders) isBorder[static_cast<std::size_t>(border.vertex)] = 1;
  const TriangleCorners corners(tile.triangles);
  const Adjacency edges = findEdges(tile.triangles, tile.places.size(), poll);
  DisjointSets sets(tile.triangles.size());
  for (Index e = 0; e < edges.edgeCount(); ++e) {
    const auto sides = edges.sidesOf(e);
    const Index from = corners.beginOf(sides[0]), to = corners.endOf(sides[0]);
    if (isBorder[from] != 0 && isBorder[to] != 0) {
      for (const Index side : sides) regions.seams.push_back({from, to, side / 3, hasObstacle(tile.triangles, side)});
      continue;
    }
    if (isObstacle(tile.triangles, sides)) continue;
    for (const Index side : sides.subspan(1)) sets.unite(sides[0] / 3, side / 3);
  }
  poll();
  Index count = 0;
  regions.regionOf = sets.numbers(count);
  for (TileRegions::Seam& seam : regions.seams) seam.region = regions.regionOf[seam.region];
  regions.areas.resize(static_cast<std::size_t>(count));
  const TileAreas areas(tile, grid);
  for (std::size_t t = 0; t < tile.triangles.size(); ++t) {
    if (t % 4096 == 0) poll();
    ErrorDouble& area = regions.areas[static_cast<std::size_t>(regions.regionOf[t])];
    area = area + areas.of(tile.triangles[t]);
  }
  return regions;
}

void RegionSums::add(const Tile& tile, const TileRegions& regions) {
  const auto first = static_cast<Index>(areas_.size());
  areas_.insert(areas_.end(), regions.areas.begin(), regions.areas.end());
  first_.push_back(areas_.size());
  std::vector<Index> nameOf(tile.places.size(), -1);
  for (const TileBorder& border : tile.borders)
    nameOf[static_cast<std::size_t>(border.vertex)] = names_.numberOf(
        tile.places[static_cast<std::size_t>(border.vertex)], border, static_cast<Index>(names_.size()));
  for (const TileRegions::Seam& seam : regions.seams) {
    const Index from = nameOf[seam.from], to = nameOf[seam.to];
    edges_.push_back({std::min(from, to), std::max(from, to), first + seam.region, seam.isObstacle});
  }
}

// For each region the first one that hangs together with it.
std::vector<Index> RegionSums::unite() {
  DisjointSets sets(areas_.size());
  const auto key = [](const Edge& edge) { return std::pair(edge.from, edge.to); };
  std::sort(edges_.begin(), edges_.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });
  for (auto first = edges_.begin(); first != edges_.end();) {
    const auto last = std::find_if(first, edges_.end(), [&](const Edge& edge) { return key(edge) != key(*first); });
    const bool isOpen = std::none_of(first, last, [](const Edge& edge) { return edge.isObstacle; });
    for (auto edge = first; isOpen && edge != last; ++edge) sets.unite(first->region, edge->region);
    first = last;
  }
  edges_ = {};
  names_ = {};
  std::vector<Index> rootOf(areas_.size());
  for (std::size_t r = 0; r < rootOf.size(); ++r) rootOf[r] = sets.find(static_cast<Index>(r));
  return rootOf;
}

std::vector<std::vector<char>> RegionSums::largerThan(double minimum, const FindAgain& findAgain, const Poll& poll) {
  const std::vector<Index> rootOf = unite();
  std::vector<ErrorDouble> sums(areas_.size());
  for (std::size_t r = 0; r < areas_.size(); ++r) sums[rootOf[r]] = sums[rootOf[r]] + areas_[r];
  const int scale = grid_.scaleExponent();
  const SignRule sign = grid_.signRule(scale);
  const double limit = std::ldexp(minimum, 2 * scale + 1);
  std::vector<char> isLarge(areas_.size(), 0), isDoubtful(areas_.size(), 0);
  bool any = false;
  for (std::size_t r = 0; r < areas_.size(); ++r) {
    if (rootOf[r] != static_cast<Index>(r)) continue;
    const int found = sign(sums[r] - ErrorDouble(limit)).value_or(0);
    isLarge[r] = static_cast<char>(found > 0);
    isDoubtful[r] = static_cast<char>(found == 0);
    any = any || found == 0;
  }
  if (any)
    for (const auto& [root, roots] : rootsOf(rootOf, isDoubtful, findAgain, poll))
      isLarge[root] = static_cast<char>(compareRootSum(roots, mpq_class(minimum) * 2) > 0);
  std::vector<std::vector<char>> result;
  for (std::size_t tile = 0; tile + 1 < first_.size(); ++tile) {
    std::vector<char>& own = result.emplace_back();
    for (std::size_t r = first_[tile]; r < first_[tile + 1]; ++r) own.push_back(isLarge[rootOf[r]]);
  }
  return result;
}

// For each doubtful region what the roots are of that are summed: a square for each of its faces.
std::map<Index, std::vector<mpq_class>> RegionSums::rootsOf(const std::vector<Index>& rootOf,
                                                            const std::vector<char>& isDoubtful,
                                                            const FindAgain& findAgain, const Poll& poll) const {
  std::map<Index, std::vector<mpq_class>> roots;
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
    const auto isDoubtfulHere = [&](std::size_t r) { return isDoubtful[rootOf[r]] != 0; };
    bool any = false;
    for (std::size_t r = first_[i]; r < first_[i + 1]; ++r) any = any || isDoubtfulHere(r);
    if (!any) continue;
    findAgain(i, [&](const Tile& tile, const ExactPlaceOf& placeOf) {
      const TileRegions regions = findTileRegions(tile, grid_, poll);
      std::map<std::pair<Index, Index>, mpq_class> plans;  // of each region and face, twice the area in the plan
      for (std::size_t t = 0; t < tile.triangles.size(); ++t) {
        const std::size_t region = first_[i] + static_cast<std::size_t>(regions.regionOf[t]);
        if (!isDoubtfulHere(region)) continue;
        poll();
        const auto& c = tile.triangles[t].corners;
        const auto p = placeOf(c[0]), q = placeOf(c[1]), r = placeOf(c[2]);
        plans[{rootOf[region], tile.triangles[t].face}] +=
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
      }
      for (const auto& [key, plan] : plans) {
        std::array<std::array<mpq_class, 3>, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3& corner = tile.faces[static_cast<std::size_t>(key.second)].corners[k];
          v[k] = {mpq_class(corner.x), mpq_class(corner.y), mpq_class(corner.z)};
        }
        const auto [nx, ny, nz] = cross(v[1] - v[0], v[2] - v[0]);
        roots[key.first].emplace_back(plan * plan * (nx * nx + ny * ny + nz * nz) / (nz * nz));
      }
    });
  }
  return roots;
}

Tile withoutRegions(const Tile& tile, const std::vector<Index>& regionOf, const std::vector<char>& keeps) {
  std::vector<char> chosen(tile.triangles.size());
  for (std::size_t t = 0; t < chosen.size(); ++t) chosen[t] = keeps[static_cast<std::size_t>(regionOf[t])];
  return chosenTriangles(tile, chosen);
}

}  // namespace footfall::detail
