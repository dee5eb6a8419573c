// The grid on which an environment's coordinates lie (docs/explanation/coordinates.md): its step, rounding to it, and
// welding.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/base/poll.hpp"
#include "footfall/edit.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// The nearest multiple of a step that is a power of two, halves to the even one. The result is exact.
[[nodiscard]] inline double onGrid(double x, double step) { return std::nearbyint(x / step) * step + 0.0; }
[[nodiscard]] inline Vec3 onGrid(const Vec3& p, double step) {
  return {onGrid(p.x, step), onGrid(p.y, step), onGrid(p.z, step)};
}

/// An obstacle whose vertices are rounded to the environment's grid; as it is where there is no grid.
[[nodiscard]] TriangleSoup onGridOf(const Environment& environment, TriangleSoup soup);

/// The height that VerticalClearanceFilter compares with. It is one step of the grid less than the clearance, which is
/// rounded to the grid, so that rounding removes no place that is exactly high enough; but never less than a step, or
/// than the clearance where that is less. Without a grid it is the clearance itself.
[[nodiscard]] double clearanceOnGrid(const CoordinateGrid& grid, double clearance);
/// The height that StepFilter compares with: one step of the grid more than the height of a step.
[[nodiscard]] double climbOnGrid(const CoordinateGrid& grid, double step);

/// Steps a little lower and higher than a limit of climbOnGrid(), between which rounding decides. Without a grid both
/// are 0.
struct StepsAtLimit {
  double lower = 0, higher = 0;
};
[[nodiscard]] StepsAtLimit stepsAtLimit(const CoordinateGrid& grid, double limit);

/// The values that the choice of a step depends on.
struct GridExtent {
  Box triangles;       ///< the box of all corners of triangles
  double largest = 0;  ///< the largest coordinate of any vertex, in size

  void include(const Vec3& corner) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = k == 0 ? corner.x : k == 1 ? corner.y : corner.z;
      triangles.lower[k] = isEmpty ? x : std::min(triangles.lower[k], x);
      triangles.upper[k] = isEmpty ? x : std::max(triangles.upper[k], x);
    }
    isEmpty = false;
  }
  void includeVertex(const Vec3& p) { largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

  bool isEmpty = true;
};

/// The usual step: the power of two nearest above 2^-24 of the largest side of the box, at most 0.25 mm, and never
/// finer than doubles of the largest coordinate. 0 where no double is such a step.
[[nodiscard]] double usualGridStep(const GridExtent& extent, double metresPerUnit);
/// The step that the options choose, 0 for none. `areFloats`: the numbers of the file are floats, or were placed by
/// matrices.
[[nodiscard]] double chosenGridStep(const ImportOptions& options, bool areFloats, const GridExtent& extent,
                                    double metresPerUnit);

/// Returns whether a usual step may change with another scale: the bound of 0.25 mm holds, or would.
[[nodiscard]] bool gridDependsOnScale(const Environment& environment, double metresPerUnit);

/// A place on the grid, counted in steps.
using GridPlace = std::array<std::int64_t, 3>;
[[nodiscard]] inline GridPlace gridPlace(const Vec3& p, double step) {
  return {static_cast<std::int64_t>(std::nearbyint(p.x / step)), static_cast<std::int64_t>(std::nearbyint(p.y / step)),
          static_cast<std::int64_t>(std::nearbyint(p.z / step))};
}

struct GridPlaceHash {
  std::size_t operator()(const GridPlace& place) const {
    std::uint64_t h = 0x243F6A8885A308D3ULL;
    for (const std::int64_t x : place) {
      h = (h ^ static_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    return h;
  }
};
using WeldedPlaces = std::unordered_map<GridPlace, GridPlace, GridPlaceHash>;

/// Welding by DuplicationFilter's rule with a distance of two steps: places that are joined by a chain, each nearer
/// than two steps to the next, become the first of them by x, then y, then z. In whole steps that means neighbours
/// whose coordinates differ by one at most. The result depends on the set of places alone.
class GridWelder {
 public:
  /// Finds the neighbours of all places with x below `end`. `places` are sorted and distinct, and hold all places of
  /// the environment from the smallest x among them to `end`, which is included.
  void addSlab(std::span<const GridPlace> places, std::int64_t end, const Poll& poll);
  /// All places that move, and where to.
  [[nodiscard]] WeldedPlaces finish() const;

 private:
  std::vector<std::pair<GridPlace, GridPlace>> pairs_;
};

/// The new places of vertices, and the changes that they cause.
class GridRounding {
 public:
  GridRounding(double step, WeldedPlaces welded);

  [[nodiscard]] Vec3 placed(const Vec3& p) const;
  void countVertex(const Vec3& from, const Vec3& to);
  void countTriangle(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to);
  /// The grid with the counts.
  [[nodiscard]] CoordinateGrid grid() const;

 private:
  double step_;
  WeldedPlaces welded_;
  double largest_ = 0, movement_ = 0;
  std::uint64_t degenerate_ = 0;
};

/// Rounds all vertices to a grid, welds, splits triangles at vertices beside their edges (core/environment/
/// edge_splitting.hpp), and fills Environment::grid. Triangles keep their numbers, those that become degenerate too;
/// pieces of triangles that were split stand behind all others. With a step of 0 it does nothing.
void putOnGrid(Environment& environment, double step, const Poll& poll);

}  // namespace footfall::detail
