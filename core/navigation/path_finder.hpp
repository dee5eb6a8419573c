// Shortest paths for a point-sized agent over a navigation mesh: "try it".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/navigation/separation.hpp"
#include "core/navigation/surface_place.hpp"

namespace footfall::detail {

enum class PathStatus {
  Found,
  NothingWalkable,    ///< the mesh has no triangles
  StartNotWalkable,   ///< no walkable place within reach of the start
  TargetNotWalkable,  ///< none within reach of the target
  NotConnected        ///< both are walkable, but no way leads from one to the other
};

struct PathResult {
  PathStatus status = PathStatus::NothingWalkable;
  Vec3 from, to;  ///< what was asked for
  /// Where the path starts. When the start is not walkable, the nearest place that is; then there is no path.
  std::optional<SurfacePlace> start;
  /// Where the path ends: the target; or, when it cannot be reached, the place nearest to it (in space) among those
  /// that can be reached from the start.
  std::optional<SurfacePlace> end;
  /// The walkable place at the target, where there is one: reached or not.
  std::optional<SurfacePlace> target;
  /// What keeps both parts apart, by addSeparation(); empty where they are not apart, and until it was called.
  std::optional<Separation> separation;

  /// The path on the surface, from start to end: each piece lies in one triangle, `triangles[i]` holds the piece from
  /// points[i] to points[i + 1]. One point where start and end are the same place; none without a path.
  std::vector<Vec3> points;
  std::vector<std::uint32_t> triangles;
  std::vector<std::size_t> bends;  ///< points at which it turns around a corner of the border

  double planLength = 0;  ///< the shortest there is, up to rounding
  double length = 0;      ///< of this path in space
  /// Layers in the order in which the path passes them; empty when the mesh has none.
  std::vector<std::uint32_t> layers;
  std::size_t connections = 0;   ///< how often it changes from one layer to another
  double maxSlopeDegrees = 0;    ///< the steepest triangle that it crosses
  double maxInclineDegrees = 0;  ///< the steepest that it goes up or down itself
  std::size_t expanded = 0;      ///< nodes of the search, to judge its cost

  [[nodiscard]] bool reached() const { return status == PathStatus::Found; }
  [[nodiscard]] bool hasPath() const { return !points.empty(); }
};

/// One line that says why there is no path; empty when there is one. Heights and distances in the mesh's units.
std::string describeFailure(const PathResult& result);

/// Prepared once for a mesh (adjacency, index of places; 60,000 triangles take some 30 ms), then asked as often as one
/// likes, from any thread.
class PathFinder {
 public:
  /// Vertices shared by index are passable, obstacle edges have vertices of their own and are not (SurfaceTopology).
  /// `poll` is called now and then and may throw.
  explicit PathFinder(
      std::shared_ptr<const NavigationMesh> mesh, const std::function<void()>& poll = [] {});
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;

  /// The shortest path in the plan from the place at `from` to that at `to`. A point means the walkable place straight
  /// above or below it, the nearest one within `reach`. Where a clearance of h was asked for, no walkable place lies
  /// less than h below an obstacle: with reach < h, a point on an obstacle never means the floor beneath it.
  ///
  /// The path has the same length the other way round, up to rounding. The coordinates must be finite.
  [[nodiscard]] PathResult find(
      const Vec3& from, const Vec3& to, double reach = std::numeric_limits<double>::infinity(),
      const std::function<void()>& poll = [] {}) const;

  [[nodiscard]] std::optional<SurfacePlace> locate(const Vec3& p, double reach) const {
    return places_.locate(p, reach);
  }
  [[nodiscard]] const NavigationMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const SurfaceTopology& topology() const { return topology_; }

 private:
  void addPath(PathResult& result, const std::function<void()>& poll) const;

  std::shared_ptr<const NavigationMesh> mesh_;
  SurfaceTopology topology_;
  PlaceIndex places_;
};

/// Where no way leads from start to target: looks for the least that would have to be overcome. `separations` must be
/// of the finder's mesh and topology.
void addSeparation(
    PathResult& result, const SurfaceTopology& topology, const SeparationFinder& separations,
    const std::function<void()>& poll = [] {});

}  // namespace footfall::detail
