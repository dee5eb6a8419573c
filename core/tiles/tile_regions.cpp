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

// Other tiles may have a vertex that went: then it is outside. Who has both edges of a link alone has lost them.
void keepLinks(const Tile& tile, const std::vector<Index>& numbers, Tile& kept) {
  std::vector<const TileBorder*> nameOf(tile.places.size(), nullptr);
  for (const TileBorder& border : tile.borders) nameOf[static_cast<std::size_t>(border.vertex)] = &border;
  const auto own = static_cast<Index>(tile.places.size()), keptCount = static_cast<Index>(kept.places.size());
  std::vector<Index> outside(tile.places.size() + tile.outside.size(), -1);
  const auto numberOf = [&](Index v) {
    if (v < own && numbers[v] >= 0) return numbers[v];
    Index& number = outside[static_cast<std::size_t>(v)];
    if (number >= 0) return number;
    number = keptCount + static_cast<Index>(kept.outside.size());
    if (v >= own)
      kept.outside.push_back(tile.outside[static_cast<std::size_t>(v - own)]);
    else
      kept.outside.push_back({tile.places[static_cast<std::size_t>(v)], nameOf[static_cast<std::size_t>(v)]->face,
                              nameOf[static_cast<std::size_t>(v)]->exact});
    return number;
  };
  const auto isHere = [&](Index v) { return v < own && numbers[v] >= 0; };
  const auto isKnown = [&](Index v) { return v >= own || numbers[v] >= 0 || nameOf[static_cast<std::size_t>(v)]; };
  for (const TileLink& link : tile.links) {
    const std::array ends{link.from[0], link.from[1], link.to[0], link.to[1]};
    const bool hasFrom = isHere(ends[0]) && isHere(ends[1]), hasTo = isHere(ends[2]) && isHere(ends[3]);
    if ((!hasFrom && !hasTo) || !std::all_of(ends.begin(), ends.end(), isKnown)) continue;
    TileLink& made = kept.links.emplace_back();
    for (const std::size_t i : {0, 1}) {
      made.from[i] = numberOf(link.from[i]);
      made.to[i] = numberOf(link.to[i]);
    }
    made.hasFrom = link.hasFrom && hasFrom;
    made.hasTo = link.hasTo && hasTo;
    made.isGap = link.isGap;
  }
}

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
  for (std::size_t i = 0; i < tile.links.size(); ++i) {
    const TileLink& link = tile.links[i];
    const auto triangleAt = [&](const std::array<Index, 2>& edge, bool isHere) {
      const Index side = isHere ? findSide(tile.triangles, edges, edge[0], edge[1]) : -1;
      return side < 0 ? -1 : side / 3;
    };
    const Index from = triangleAt(link.from, link.hasFrom), to = triangleAt(link.to, link.hasTo);
    if (from >= 0 && to >= 0)
      sets.unite(from, to);
    else if (from >= 0 || to >= 0)
      regions.passages.push_back({i, std::max(from, to)});
  }
  Index count = 0;
  regions.regionOf = sets.numbers(count);
  for (TileRegions::Seam& seam : regions.seams) seam.region = regions.regionOf[seam.region];
  for (TileRegions::Passage& passage : regions.passages) passage.region = regions.regionOf[passage.region];
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
  if (regions.passages.empty()) return;
  for (const TileOutside& vertex : tile.outside)
    nameOf.push_back(names_.numberOf(vertex, static_cast<Index>(names_.size())));
  for (const TileRegions::Passage& passage : regions.passages) {
    const TileLink& link = tile.links[passage.link];
    passages_.push_back(
        {{nameOf[link.from[0]], nameOf[link.from[1]], nameOf[link.to[0]], nameOf[link.to[1]]}, first + passage.region});
  }
}

// The first region that hangs together with it, of each region.
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
  std::sort(passages_.begin(), passages_.end(), [](const Passage& a, const Passage& b) { return a.ends < b.ends; });
  for (std::size_t i = 1; i < passages_.size(); ++i)
    if (passages_[i].ends == passages_[i - 1].ends) sets.unite(passages_[i - 1].region, passages_[i].region);
  edges_ = {};
  passages_ = {};
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

// The squares of the roots that are summed for each doubtful region: one per face.
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
      std::map<std::pair<Index, Index>, mpq_class> plans;  // twice the area in the plan, by region and face
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
  std::vector<Index> numbers;
  Tile kept = chosenTriangles(tile, chosen, &numbers);
  keepLinks(tile, numbers, kept);
  return kept;
}

}  // namespace footfall::detail
