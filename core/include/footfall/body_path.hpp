// Paths for an agent with a body, for any radius, without a run of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "footfall/geometry.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/path.hpp"
#include "footfall/run_context.hpp"
#include "footfall/up_axis.hpp"

namespace footfall {

namespace detail {
struct BodyPathGround;
}  // namespace detail

/// The body of an agent, and what it prefers. Lengths are in the units of the mesh, in the plan.
struct BodyPathOptions {
  /// The least distance to every border; above 0.
  double radius = 0;
  /// Passages narrower than this are taken only where the way needs them: the way keeps to passages as wide as possible
  /// up to this width. Infinity takes the widest way. A width of less than twice the radius changes nothing.
  double preferredWidth = 0;
};

/// A narrow place of the walkable area.
struct Passage {
  Vec3 place;
  Vec3 left, right;  ///< the nearest places of the border
  double width = 0;  ///< twice the distance to both
};

enum class BodyPathStatus {
  Found,
  NoPath,         ///< not even a point gets there without drops; BodyPath::path says why
  StartTooNear,   ///< the start is nearer to a border than the radius
  TargetTooNear,  ///< the target is
  TooNarrow       ///< each way leads through a passage that is too narrow
};

struct BodyPath {
  BodyPathStatus status = BodyPathStatus::NoPath;
  /// The path, as PathFinder returns one. Its bends are corners of polygons around arcs, at most 0.13 % of the radius
  /// outside of them. BodyPathStatus::NoPath: what PathFinder::findEnds() returns; where drops alone lead to the
  /// target, the path over them.
  PathResult path;
  double startDistance = 0, targetDistance = 0;  ///< from both places to the border
  /// BodyPathStatus::StartTooNear, TargetTooNear: a place that is far enough from the border. It is the nearest one
  /// where the distance grows up to the radius straight away from the border; else a vertex of the corridor map, the
  /// first one along the map. None where the part has no such place.
  std::optional<Vec3> admissible;
  /// The narrowest passage of the way; BodyPathStatus::TooNarrow: the one that stops the agent, on the way whose
  /// narrowest passage is widest.
  std::optional<Passage> narrowest;
  /// The length that is missing: of the width of the passage, or of the distance of the start or the target.
  double lacking = 0;

  [[nodiscard]] bool reached() const { return status == BodyPathStatus::Found; }
};

/// Finds paths for any radius on one mesh, which should be without the margins of a RadiusFilter. It is prepared once
/// (the corridor map; about as long as a vertical clearance takes) and then used any number of times, from any thread.
///
/// A way leads where a place is at least the radius away from the border, as RadiusFilter defines it, up to 2^-36 of
/// the mesh's extent: a way behind a RadiusFilter with the same radius is one here, and a way here for a radius that is
/// larger by twice the filter's tolerance is one behind the filter. Drops are not taken. The path is the shortest one
/// up to rounding and to the polygons around arcs; core/navigation/body_search.hpp says when it may be longer.
class BodyPathFinder {
 public:
  /// Throws Cancelled when `context` (may be null) is cancelled.
  explicit BodyPathFinder(std::shared_ptr<const NavigationMesh> mesh, const RunContext* context = nullptr);
  ~BodyPathFinder();
  BodyPathFinder(const BodyPathFinder&) = delete;
  BodyPathFinder& operator=(const BodyPathFinder&) = delete;

  /// The path from the place at `from` to that at `to`; `reach` as in PathFinder::find(). Throws InputError for a
  /// coordinate that is not finite, and for a radius or a width that is none, and Cancelled.
  [[nodiscard]] BodyPath find(const Vec3& from, const Vec3& to, const BodyPathOptions& options,
                              double reach = std::numeric_limits<double>::infinity(),
                              const RunContext* context = nullptr) const;

  [[nodiscard]] const PathFinder& pointFinder() const;

 private:
  std::unique_ptr<const detail::BodyPathGround> inside_;
};

/// The word for a status in JSON: "found", "start_too_near", "target_too_near", "too_narrow"; of a path that not even a
/// point has, the word for that one's status.
std::string_view statusWord(const BodyPath& path);

/// One line that says why there is no path, with places in the frame of the environment's file; empty when there is
/// one.
std::string formatFailure(const BodyPath& path, UpAxis up);

/// The path in words, as formatPath() has it, with the narrowest passage.
std::string formatPath(const BodyPath& path, UpAxis up);

/// The path as JSON: what formatPathJson() writes, and `start_distance`, `target_distance`, `admissible`
/// (or null), `narrowest` (`place`, `left`, `right`, `width`; or null) and `lacking`.
std::string formatPathJson(const NavigationMesh& mesh, const BodyPath& path);

}  // namespace footfall
