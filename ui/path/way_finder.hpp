// Data prepared for the paths on one result: for a point, or for a body of any radius.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "footfall/body_path.hpp"
#include "footfall/path.hpp"
#include "footfall/run_context.hpp"
#include "ui/run/finished_runs.hpp"

namespace footfall::ui {

/// The data of a finished run that a path needs.
struct WayGround {
  std::shared_ptr<const NavigationMesh> mesh;  ///< mesh to walk on; null: none
  double reach = 0;                            ///< distance below a place at which its ground may lie (placeReach())
  std::shared_ptr<const Environment> environment;  ///< environment between its parts
  double agentHeight = 0, agentStep = 0, agentGap = 0;
  /// The run of the mesh. A body walks on its result without the RadiusFilter; null: on `mesh`.
  std::shared_ptr<const FinishedRun> run = {};
  std::shared_ptr<ResultCache> cache = {};
  bool operator==(const WayGround&) const = default;
};

enum class BodyWay { Shortest, PrefersWide, Widest };

/// Who walks: a body that keeps `radius` off every border, in the plan and in the mesh's units; 0: a point.
struct WalkingBody {
  double radius = 0;
  BodyWay way = BodyWay::Shortest;  ///< of several ways; a point takes the shortest
  bool operator==(const WalkingBody&) const = default;
  [[nodiscard]] bool isPoint() const { return radius <= 0; }
};

/// Passages as wide as this multiple of the body's width are preferred (BodyWay::PrefersWide).
inline constexpr double kPreferredWidth = 2;

/// A path, and for a body what limits it.
struct FoundWay {
  /// Nothing where the body cannot go, and a point could: `body` has the reason.
  std::optional<PathResult> path;
  std::optional<BodyPath> body;
};

/// Used by one thread at a time.
class WayFinder {
 public:
  /// Makes the data for a ground, unless it is the one of the last call. Throws Cancelled.
  void prepare(const WayGround& wanted, bool forBody, RunContext& context);
  [[nodiscard]] FoundWay find(const Vec3& start, const Vec3& target, const WalkingBody& body,
                              const RunContext& context) const;
  /// Adds the barrier between two parts. Most places are on the same parts as those of the last call.
  void separate(PathResult& result, const RunContext& context);

 private:
  struct Answer {
    std::array<std::uint32_t, 2> parts;
    std::optional<Separation> separation;
  };
  [[nodiscard]] const PathFinder& finder() const { return bodies_ ? bodies_->pointFinder() : *points_; }
  [[nodiscard]] std::array<std::uint32_t, 2> partsOf(const PathResult& result) const;

  WayGround ground_;
  std::unique_ptr<PathFinder> points_;   ///< one of the two is there after prepare()
  std::unique_ptr<PathFinder> earlier_;  ///< finder of an earlier ground, of which the next one is made
  std::unique_ptr<BodyPathFinder> bodies_;
  std::unique_ptr<SeparationFinder> separations_;
  std::optional<Answer> last_;
};

}  // namespace footfall::ui
