// Levels as strategies see them, and what every partition of one must be.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "core/partitioning/strategies.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter_type.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

namespace footfall::test {
using namespace detail;

using Borders = std::array<std::vector<double>, 2>;

// Each strategy, with parameters that make several cells.
inline const std::vector<std::pair<FilterType, std::vector<double>>> kStrategies{
    {FilterType::GridStrategy, {3, 4}},
    {FilterType::RecursiveStrategy, {5, 3, 0}},
    {FilterType::SortedRecursiveStrategy, {5, 4, 1}},
    {FilterType::HeightAwareStrategy, {5, 4, 0}},
    {FilterType::AutoStrategy, {}}};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An environment as strategies see it; what faces up is a floor.
struct Case {
  SourceMesh mesh;
  std::vector<char> walkable, removed;
  double clearance = 2;
  int threads = 4;

  explicit Case(const Environment& environment)
      : mesh(makeSourceMesh(SoupView(environment.vertices, environment.triangles), false)),
        walkable(mesh.triangles.size()),
        removed(mesh.triangles.size(), 0) {
    for (std::size_t t = 0; t < walkable.size(); ++t) walkable[t] = static_cast<char>(mesh.facing[t] > 0);
  }
  explicit Case(const Soup& soup) : Case(*soup.environment()) {}

  [[nodiscard]] StrategyInput input() const { return {mesh, walkable, removed, clearance, threads}; }
  [[nodiscard]] Partition partition(FilterType strategy, const std::vector<double>& values) const {
    return makePartition(strategy, values, input());
  }
};

// Floors of all sizes on several heights, with walls and slabs among them.
inline Soup randomLevel(int triangles) {
  std::mt19937_64 random(7);
  const auto number = [&](int count) { return static_cast<double>(random() % static_cast<unsigned>(count)); };
  Soup soup = Soup().floor(0, 0, 64, 64, 0);
  while (soup.size() < static_cast<std::size_t>(triangles)) {
    const double x = number(600) / 10, y = number(600) / 10, z = number(40) / 4;
    const double width = 0.5 + number(8) * number(8) / 16, depth = 0.5 + number(8) * number(8) / 16;
    const double right = std::min(x + width, 64.0), back = std::min(y + depth, 64.0);
    if (random() % 3 == 0)
      soup.wall(x, y, right, back, z, z + 3);
    else if (random() % 3 == 0)
      soup.ramp(x, y, right, back, z, z + 1);
    else
      soup.floor(x, y, right, back, z);
  }
  return soup;
}

// The floor below everything.
inline bool isGround(const SourceMesh& mesh, Index triangle) {
  const Box box = boxOf(mesh, triangle);
  return box.upper[2] == 0 && box.upper[0] - box.lower[0] == 64;
}

inline bool isSame(const Partition& a, const Partition& b) {
  if (a.borders != b.borders || a.cells.size() != b.cells.size() || a.strategy != b.strategy || a.reason != b.reason)
    return false;
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const auto &n = a.nodes[i], &m = b.nodes[i];
    if (n.axis != m.axis || n.coordinate != m.coordinate || n.below != m.below || n.above != m.above) return false;
  }
  for (std::size_t c = 0; c < a.cells.size(); ++c) {
    const Cell &x = a.cells[c], &y = b.cells[c];
    if (x.bounds.lower != y.bounds.lower || x.bounds.upper != y.bounds.upper || x.cost != y.cost ||
        x.floors != y.floors || x.obstacles != y.obstacles)
      return false;
  }
  return true;
}

inline bool isInside(const CellBounds& bounds, double x, double y, double z) {
  return bounds.lower[0] <= x && x < bounds.upper[0] && bounds.lower[1] <= y && y < bounds.upper[1] &&
         bounds.lower[2] <= z && z < bounds.upper[2];
}

// True when everything holds that must hold for any partition.
inline bool isSound(const Partition& partition) {
  if (partition.cells.empty() || partition.nodes.size() + 1 != partition.cells.size()) return false;
  std::array<std::vector<double>, 3> at;  // every coordinate, and places beside it
  for (int axis = 0; axis < 2; ++axis) {
    const auto& borders = partition.borders[axis];
    if (std::adjacent_find(borders.begin(), borders.end(), std::greater_equal<>()) != borders.end()) return false;
  }
  for (const auto& node : partition.nodes) {
    if (!std::isfinite(node.coordinate)) return false;
    if (node.axis < 2 &&
        !std::binary_search(partition.borders[node.axis].begin(), partition.borders[node.axis].end(), node.coordinate))
      return false;
    at[node.axis].push_back(node.coordinate);
  }
  for (const Cell& cell : partition.cells)
    for (int axis = 0; axis < 3; ++axis) {
      const double lower = cell.bounds.lower[axis], upper = cell.bounds.upper[axis];
      if (!(lower < upper) || !std::isfinite(cell.cost) || cell.cost < 0) return false;
      if (axis == 2) continue;
      const Index below = cell.bounds.lowerBorder[axis], above = cell.bounds.upperBorder[axis];
      if (below < 0 ? lower != -kInfinity : partition.borders[axis][below] != lower) return false;
      if (above < 0 ? upper != kInfinity : partition.borders[axis][above] != upper) return false;
    }
  for (auto& places : at) {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (places.size() > 12) places.resize(12);
    for (const double place : std::vector<double>(places)) places.push_back(std::nextafter(place, -kInfinity));
    places.push_back(0);
  }
  // Every point lies in exactly one cell, and a box without width is shown to that one.
  for (const double x : at[0])
    for (const double y : at[1])
      for (const double z : at[2]) {
        std::vector<Index> holding, visited;
        for (std::size_t c = 0; c < partition.cells.size(); ++c)
          if (isInside(partition.cells[c].bounds, x, y, z)) holding.push_back(static_cast<Index>(c));
        partition.visitCells({x, y}, {x, y}, z, [&](Index cell) { visited.push_back(cell); });
        if (holding.size() != 1 || visited != holding) return false;
      }
  return true;
}

using Point = std::array<mpq_class, 2>;

// The area of a floor in a cell, times two, by cutting its outline at each side of the cell in rationals.
inline mpq_class areaIn(const SourceMesh& mesh, Index floor, const CellBounds& bounds) {
  std::vector<Point> outline;
  for (const Index v : mesh.triangles[floor])
    outline.push_back({mpq_class(mesh.vertices[v].x), mpq_class(mesh.vertices[v].y)});
  const auto cut = [&](int axis, double side, int keep) {
    if (std::isinf(side)) return;
    const mpq_class at(side);
    std::vector<Point> rest;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
      const mpq_class da = (a[axis] - at) * keep, db = (b[axis] - at) * keep;
      if (da >= 0) rest.push_back(a);
      if (sgn(da) * sgn(db) >= 0) continue;
      const mpq_class part = da / (da - db);
      rest.push_back({a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])});
    }
    outline = rest;
  };
  for (int axis = 0; axis < 2; ++axis) {
    cut(axis, bounds.lower[axis], 1);
    cut(axis, bounds.upper[axis], -1);
  }
  mpq_class area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

inline double lowestOf(const SourceMesh& mesh, Index triangle) {
  const auto& f = mesh.triangles[triangle];
  return std::min({mesh.vertices[f[0]].z, mesh.vertices[f[1]].z, mesh.vertices[f[2]].z});
}

// Every cell in which a floor has area lists it; what is listed without area is counted.
inline bool areFloorsListed(const Case& given, Partition partition, std::size_t* spare = nullptr) {
  const CellFloors listed = assignFloors(partition, given.input());
  const std::size_t triangles = given.mesh.triangles.size();
  std::vector<Index> counts(triangles, 0);
  if (listed.first.size() != partition.cells.size() + 1 || listed.cellCount.size() != triangles) return false;
  for (std::size_t c = 0; c < partition.cells.size(); ++c) {
    const std::vector<Index> floors(listed.floors.begin() + static_cast<std::ptrdiff_t>(listed.first[c]),
                                    listed.floors.begin() + static_cast<std::ptrdiff_t>(listed.first[c + 1]));
    if (!std::is_sorted(floors.begin(), floors.end(), std::less_equal<>())) return false;
    if (partition.cells[c].floors != floors.size()) return false;
    for (const Index floor : floors) ++counts[floor];
    const CellBounds& bounds = partition.cells[c].bounds;
    for (std::size_t t = 0; t < triangles; ++t) {
      if (given.walkable[t] == 0) continue;
      const auto floor = static_cast<Index>(t);
      const double z = lowestOf(given.mesh, floor);
      const bool hasArea = bounds.lower[2] <= z && z < bounds.upper[2] && areaIn(given.mesh, floor, bounds) > 0;
      const bool isListed = std::binary_search(floors.begin(), floors.end(), floor);
      if (hasArea && !isListed) return false;
      if (spare != nullptr && isListed && !hasArea) ++*spare;
    }
  }
  for (std::size_t t = 0; t < triangles; ++t)
    if (counts[t] != listed.cellCount[t] || (given.walkable[t] != 0) != (counts[t] > 0)) return false;
  return true;
}

}  // namespace footfall::test
