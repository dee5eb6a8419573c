// Shortest paths for a point-sized agent over a navigation mesh, and what keeps two of its parts apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

namespace detail {
struct PathGround;
struct SeparationGround;
}  // namespace detail

// --- What keeps two parts apart
// ---------------------------------------------------------------------------------------

enum class LinkKind {
  Open,        ///< nothing stands between: a step, a gap, or both
  Obstacle,    ///< something lower than the agent stands between
  LowCeiling,  ///< something hangs over the way, too low
  Wall,        ///< something as high as the agent stands between
  Touch        ///< both meet in one point, which is too narrow for an agent
};

/// A place where one border is near another one, and what an agent would have to overcome there. Lengths are distances
/// in doubles (square roots), off by a few units in the last place of the coordinates.
struct BorderLink {
  Vec3 from, to;
  std::uint32_t fromComponent = 0, toComponent = 0;
  double gap = 0;   ///< distance of the two places in the plan
  double rise = 0;  ///< height from the first to the second, upwards
  LinkKind kind = LinkKind::Open;
  double obstacle = 0;     ///< LinkKind::Obstacle: its height over the lower place
  double headroom = 0;     ///< LinkKind::LowCeiling: the free height over the higher place
  bool isInterval = true;  ///< the borders face each other, and do not only meet in a point
  /// The amount by which the agent fails here: the largest of the gap beyond what it steps over, of the height that is
  /// climbed beyond its step, and of the height that a ceiling lacks. Walls, and borders that only touch in a point,
  /// have a `kind` and add nothing to it. Set by SeparationFinder.
  double excess = 0;
  /// The triangles in the way: the riser of a step, the obstacle, the ceiling, the wall. Indices into
  /// Environment::triangles, rising; found in doubles. Set by SeparationFinder.
  std::vector<std::uint32_t> triangles = {};

  /// The larger of the gap and the height that is climbed, walls left out.
  [[nodiscard]] double size() const;
  /// An agent of any step and gap does not get over it.
  [[nodiscard]] bool isBlocked() const { return kind != LinkKind::Open && kind != LinkKind::Obstacle; }
  /// Returns true where no agent gets over it, however low it is: a wall, or borders that only touch.
  [[nodiscard]] bool isClosed() const { return kind == LinkKind::Wall || kind == LinkKind::Touch; }
};

/// The least that would have to be overcome between two parts.
struct Separation {
  std::vector<BorderLink> links;  ///< links from the first part to the other one, over parts between
  std::size_t largest = 0;        ///< index in `links` of the one to mend first; the first one if several are as large
  /// Other places where mending one thing would join both parts as well, least excess first: those that lack at most
  /// twice as much as barrier(), or a sixteenth of the agent's height. Places next to each other along the same borders
  /// are one. None where walls are between.
  std::vector<BorderLink> others = {};
  double height = 0, step = 0, gap = 0;  ///< height, step and gap of the agent (SeparationFinder)

  [[nodiscard]] const BorderLink& barrier() const { return links[largest]; }
};

// --- Paths
// ------------------------------------------------------------------------------------------------------------

/// A point in the plan inside or on the border of a triangle (exactly), with its height on it (rounded).
struct SurfacePlace {
  Vec3 position;
  std::uint32_t triangle = 0;
  double distance = 0;  ///< distance from the given point
};

enum class PathStatus {
  Found,
  NothingWalkable,    ///< the mesh has no triangles
  StartNotWalkable,   ///< no walkable place within reach of the start
  TargetNotWalkable,  ///< none within reach of the target
  NotConnected        ///< both are walkable, but no way leads from one to the other
};

struct PathResult {
  PathStatus status = PathStatus::NothingWalkable;
  Vec3 from, to;  ///< given points
  /// The start of the path. When the start is not walkable, the nearest place that is; then there is no path.
  std::optional<SurfacePlace> start;
  /// The end of the path: the target; or, when it cannot be reached, the place nearest to it (in space) among those
  /// that can be reached from the start, over drops as well.
  std::optional<SurfacePlace> end;
  /// The walkable place at the target, where there is one: reached or not.
  std::optional<SurfacePlace> target;
  /// The reason why both parts are apart, set by addSeparation(); empty when they are not apart, and before the call.
  std::optional<Separation> separation;

  /// The path on the surface, from start to end: each piece lies in one triangle or leads over a gap; `triangles[i]`
  /// holds the piece from points[i] to points[i + 1]. One point where start and end are the same place; none without a
  /// path.
  std::vector<Vec3> points;
  std::vector<std::uint32_t> triangles;
  std::vector<std::size_t> bends;  ///< points at which it turns around a corner of the border
  std::vector<std::size_t> steps;  ///< pieces that are steps, straight up or down; `triangles` has their ends
  std::vector<std::size_t> gaps;   ///< pieces that lead over a gap; `triangles` has their ends
  std::vector<std::size_t> drops;  ///< pieces that are drops, one way down; `triangles` has their ends
  double deepestDrop = 0;          ///< depth of the deepest of those
  /// PathStatus::NotConnected: drops lead from the target to the start, and nothing leads back.
  bool leadsBack = false;

  /// shortest length, up to rounding; over drops, the length is as near to the shortest as `leastPlanLength` shows
  double planLength = 0;
  /// A lower bound of the length in the plan of any way to `end`, up to rounding: `planLength` itself, or the proven
  /// bound when drops are taken.
  double leastPlanLength = 0;
  double length = 0;   ///< length of this path in space, heights of steps included
  double climb = 0;    ///< all that it goes up, on slopes and steps
  double descent = 0;  ///< all that it goes down
  /// Layers in the order in which the path passes them; empty when the mesh has none.
  std::vector<std::uint32_t> layers;
  std::size_t connections = 0;   ///< number of changes from one layer to another
  double maxSlopeDegrees = 0;    ///< the steepest triangle that it crosses
  double maxInclineDegrees = 0;  ///< the steepest that it goes up or down itself
  std::size_t expanded = 0;      ///< nodes of the search, to judge its cost

  [[nodiscard]] bool reached() const { return status == PathStatus::Found; }
  [[nodiscard]] bool hasPath() const { return !points.empty(); }
};

/// The words for a status and for a kind in JSON, e.g. "not_connected" and "low_ceiling".
std::string_view statusWord(PathStatus status);
std::string_view linkWord(LinkKind kind);

/// One line with the reason why there is no path; empty when there is one. Heights and distances are in the mesh's
/// units.
std::string describeFailure(const PathResult& result);

/// Finds paths on one mesh. It is prepared once (adjacency, index of places; 60,000 triangles take some 30 ms) and then
/// used any number of times, from any thread. Lengths and coordinates are in the units of the mesh, Z up.
class PathFinder {
 public:
  /// Vertices shared by index are passable, obstacle edges have vertices of their own and are not. Throws Cancelled
  /// when `context` (may be null) is cancelled.
  explicit PathFinder(std::shared_ptr<const NavigationMesh> mesh, const RunContext* context = nullptr);
  /// The same finder in a fraction of the time, where `mesh` is the result after an edit and `before` the finder of the
  /// result before it: what the edit left as it was is taken over. `before` may be any finder, and may go away.
  PathFinder(std::shared_ptr<const NavigationMesh> mesh, const PathFinder& before, const RunContext* context = nullptr);
  ~PathFinder();
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;

  /// The shortest path in the plan from the place at `from` to that at `to` (Polyanya; Cui, Harabor and Grastien 2017).
  /// A point means the walkable place straight above or below it, the nearest one within `reach`. Behind a clearance of
  /// h, no walkable place lies less than h below an obstacle: with reach < h, a point on an obstacle never means the
  /// floor beneath it; placeReach() gives that reach.
  ///
  /// Drops are taken only where nothing else leads to the target. Then each piece between two drops is the shortest one
  /// there is. The drops, and the places along them, are found by halving their stretches until the path is proven to
  /// be at most 1 % longer than the shortest, or until the search has taken too many steps; PathResult::leastPlanLength
  /// is the proven bound.
  ///
  /// The length of a path without drops is the same the other way round, up to rounding. Throws InputError for
  /// coordinates that are not finite, and Cancelled.
  [[nodiscard]] PathResult find(const Vec3& from, const Vec3& to,
                                double reach = std::numeric_limits<double>::infinity(),
                                const RunContext* context = nullptr) const;

  /// Returns what find() returns, without the path itself: the status, the start, the end and the target, and whether
  /// drops lead back. It takes no search.
  [[nodiscard]] PathResult findEnds(const Vec3& from, const Vec3& to,
                                    double reach = std::numeric_limits<double>::infinity()) const;

  /// The walkable place straight above or below `p` that is nearest to it, when it is no farther than `reach`.
  [[nodiscard]] std::optional<SurfacePlace> locate(const Vec3& p,
                                                   double reach = std::numeric_limits<double>::infinity()) const;

  [[nodiscard]] const NavigationMesh& mesh() const;

  /// Internal to the library.
  [[nodiscard]] const std::shared_ptr<const detail::PathGround>& inside() const { return inside_; }

 private:
  std::shared_ptr<const detail::PathGround> inside_;
};

/// Finds what keeps two parts apart; a part hangs together over edges and steps (findComponents()). It is made once for
/// a result (60,000 triangles take some 30 ms) and then used from any thread.
class SeparationFinder {
 public:
  /// `environment` is what the finder's mesh was computed from, `height` (above 0), `step` and `gap` (at least
  /// 0) are the agent's, in the environment's units (agentHeight(), agentStep(), agentGap()). Throws Cancelled.
  SeparationFinder(const PathFinder& finder, std::shared_ptr<const Environment> environment, double height,
                   double step = 0, const RunContext* context = nullptr, double gap = 0);
  ~SeparationFinder();
  SeparationFinder(const SeparationFinder&) = delete;
  SeparationFinder& operator=(const SeparationFinder&) = delete;

  /// The reason why the parts of two triangles of the mesh are apart. Empty when they are on one part, or one of the
  /// parts has no border. Throws Cancelled.
  [[nodiscard]] std::optional<Separation> find(std::uint32_t fromTriangle, std::uint32_t toTriangle,
                                               const RunContext* context = nullptr) const;

 private:
  std::unique_ptr<const detail::SeparationGround> inside_;
};

/// Adds the reason to a result without a way from start to target (PathStatus::NotConnected). `separations` must belong
/// to the finder that returned `result`.
void addSeparation(PathResult& result, const SeparationFinder& separations, const RunContext* context = nullptr);

/// A height just below the largest clearance of the enabled VerticalClearanceFilters: there is no obstacle within it
/// above a walkable place, and a point on an obstacle never means a floor beneath it (PathFinder::find). Infinite when
/// there is no such filter.
double placeReach(const Pipeline& pipeline);

/// The height of the agent that a pipeline is for: the largest clearance of the enabled VerticalClearanceFilters, or 2
/// metres, in the environment's units.
double agentHeight(const Pipeline& pipeline, double metresPerUnit);

/// The largest step that an enabled StepFilter allows, in the environment's units; 0 when there is no such filter.
double agentStep(const Pipeline& pipeline);

/// The widest gap that an enabled StepFilter allows, in the environment's units; 0 when there is no such filter.
double agentGap(const Pipeline& pipeline);

}  // namespace footfall
