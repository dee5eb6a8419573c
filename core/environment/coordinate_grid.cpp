// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/coordinate_grid.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/environment/edge_splitting.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

constexpr double kCoarsest = 0.00025;  // metres
constexpr int kBitsOfExtent = 24;      // of a float
constexpr int kBitsOfDouble = 52;      // whole steps stay below 2^53, so that each is a double

double powerOfTwoAbove(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // from 0.5 on
  return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

double powerOfTwoBelow(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

bool isStep(double step) { return std::isnormal(step) && std::isnormal(1 / step); }

}  // namespace

TriangleSoup onGridOf(const Environment& environment, TriangleSoup soup) {
  if (environment.grid.step > 0)
    for (Vec3& p : soup.vertices) p = onGrid(p, environment.grid.step);
  return soup;
}

double clearanceOnGrid(const CoordinateGrid& grid, double clearance) {
  if (clearance <= grid.step || grid.step == 0) return clearance;
  return std::max(onGrid(clearance, grid.step) - grid.step, grid.step);
}

double climbOnGrid(const CoordinateGrid& grid, double step) {
  return grid.step == 0 ? step : onGrid(step, grid.step) + grid.step;
}

// Heights of two floors at a place are off by three steps together where slopes are up to 45 degrees, and the limit
// itself has one. A rise that grows by less than the higher step is one that was meant to be level.
StepsAtLimit stepsAtLimit(const CoordinateGrid& grid, double limit) {
  constexpr double kBelow = 4, kAbove = 16;  // steps of the grid
  if (grid.step == 0 || limit <= 2 * kBelow * grid.step) return {};
  return {limit - kBelow * grid.step, limit + kAbove * grid.step};
}

double usualGridStep(const GridExtent& extent, double metresPerUnit) {
  double side = 0;
  for (std::size_t k = 0; k < 3; ++k) side = std::max(side, extent.triangles.upper[k] - extent.triangles.lower[k]);
  const double least = std::ldexp(powerOfTwoAbove(extent.largest), -kBitsOfDouble);
  if (!(side > 0) || !std::isfinite(side) || !isStep(least)) return 0;
  const double fine =
      std::min(std::ldexp(powerOfTwoAbove(side), -kBitsOfExtent), powerOfTwoBelow(kCoarsest / metresPerUnit));
  const double step = std::max(fine, least);
  return isStep(step) ? step : 0;
}

double chosenGridStep(const ImportOptions& options, bool areFloats, const GridExtent& extent, double metresPerUnit) {
  if (options.grid == GridChoice::Off || (options.grid == GridChoice::Auto && !areFloats)) return 0;
  const double usual = usualGridStep(extent, metresPerUnit);
  if (usual == 0) return 0;
  if (options.grid == GridChoice::Step) {
    const double least = std::ldexp(powerOfTwoAbove(extent.largest), -kBitsOfDouble);
    return std::max(powerOfTwoBelow(options.gridStep), least);
  }
  const double kept = options.keptGridStep;
  return kept > 0 && kept <= 4 * usual && usual <= 4 * kept ? kept : usual;
}

bool gridDependsOnScale(const Environment& environment, double metresPerUnit) {
  const double step = environment.grid.step;
  return step > 0 && (step >= powerOfTwoBelow(kCoarsest / environment.metresPerUnit) ||
                      step > powerOfTwoBelow(kCoarsest / metresPerUnit));
}

void GridWelder::addSlab(std::span<const GridPlace> places, std::int64_t end, const Poll& poll) {
  constexpr std::size_t kPollEach = 1 << 14;
  // The four rows ahead of a place that can hold neighbours; the fifth is the next place itself. While places go up,
  // so do the neighbours that are looked for, so each row is walked through once.
  constexpr std::array<std::array<std::int64_t, 2>, 4> kRows{{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
  std::array<std::size_t, 4> at{};
  for (std::size_t i = 0; i < places.size() && places[i][0] < end; ++i) {
    if (i % kPollEach == 0) poll();
    const auto& [x, y, z] = places[i];
    if (i + 1 < places.size() && places[i + 1] == GridPlace{x, y, z + 1}) pairs_.emplace_back(places[i], places[i + 1]);
    for (std::size_t r = 0; r < kRows.size(); ++r) {
      const GridPlace first{x + kRows[r][0], y + kRows[r][1], z - 1}, last{first[0], first[1], z + 1};
      while (at[r] < places.size() && places[at[r]] < first) ++at[r];
      for (std::size_t k = at[r]; k < places.size() && places[k] <= last; ++k)
        pairs_.emplace_back(places[i], places[k]);
    }
  }
}

WeldedPlaces GridWelder::finish() const {
  std::vector<GridPlace> places;
  for (const auto& [a, b] : pairs_) {
    places.push_back(a);
    places.push_back(b);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto numberOf = [&](const GridPlace& place) {
    return static_cast<Index>(std::lower_bound(places.begin(), places.end(), place) - places.begin());
  };
  DisjointSets sets(places.size());
  for (const auto& [a, b] : pairs_) sets.unite(numberOf(a), numberOf(b));
  WeldedPlaces welded;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const Index first = sets.find(static_cast<Index>(i)); first != static_cast<Index>(i))
      welded.emplace(places[i], places[static_cast<std::size_t>(first)]);
  return welded;
}

GridRounding::GridRounding(double step, WeldedPlaces welded) : step_(step), welded_(std::move(welded)) {}

Vec3 GridRounding::placed(const Vec3& p) const {
  if (!welded_.empty()) {
    if (const auto found = welded_.find(gridPlace(p, step_)); found != welded_.end()) {
      const auto at = [&](std::size_t k) { return static_cast<double>(found->second[k]) * step_; };
      return {at(0), at(1), at(2)};
    }
  }
  return onGrid(p, step_);
}

void GridRounding::countVertex(const Vec3& from, const Vec3& to) {
  largest_ = std::max({largest_, std::abs(to.x), std::abs(to.y), std::abs(to.z)});
  const double dx = to.x - from.x, dy = to.y - from.y, dz = to.z - from.z;
  movement_ = std::max(movement_, dx * dx + dy * dy + dz * dz);
}

void GridRounding::countTriangle(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
  if (isDegenerate(to[0], to[1], to[2]) && !isDegenerate(from[0], from[1], from[2])) ++degenerate_;
}

CoordinateGrid GridRounding::grid() const {
  CoordinateGrid grid;
  grid.step = step_;
  grid.bits = static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(largest_ / step_)));
  grid.largestMovement = std::sqrt(movement_);
  grid.weldedVertices = welded_.size();
  grid.degenerateTriangles = degenerate_;
  return grid;
}

void putOnGrid(Environment& environment, double step, const Poll& poll) {
  if (step == 0) return;
  constexpr std::size_t kPollEach = 1 << 14;
  std::vector<GridPlace> places;
  places.reserve(environment.vertices.size());
  for (const Vec3& p : environment.vertices) places.push_back(gridPlace(p, step));
  poll();
  parallelSort(places.begin(), places.end());
  poll();
  places.erase(std::unique(places.begin(), places.end()), places.end());
  GridWelder welder;
  welder.addSlab(places, std::numeric_limits<std::int64_t>::max(), poll);
  places = {};
  GridRounding rounding(step, welder.finish());
  std::vector<Vec3> rounded;
  rounded.reserve(environment.vertices.size());
  for (const Vec3& p : environment.vertices) {
    if (rounded.size() % kPollEach == 0) poll();
    rounded.push_back(rounding.placed(p));
    rounding.countVertex(p, rounded.back());
  }
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    if (t % kPollEach == 0) poll();
    const auto& [a, b, c] = environment.triangles[t];
    const std::vector<Vec3>& from = environment.vertices;
    rounding.countTriangle({from[a], from[b], from[c]}, {rounded[a], rounded[b], rounded[c]});
  }
  environment.vertices = std::move(rounded);
  environment.grid = rounding.grid();
  environment.grid.splitTriangles = splitAtNearVertices(environment, step, poll);
}

}  // namespace footfall::detail
