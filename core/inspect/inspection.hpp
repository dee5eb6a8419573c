// Why is a place walkable, or why not? Answered from the states that a run went through, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A place is a point of a triangle of the environment. It is walkable while the state's mesh covers it in that
// triangle's plane, whichever triangle of the plane carries it; the first step whose state does not cover it any more
// has rejected it. So the answer is what the steps did, not a second opinion on what they should have done. Points on
// edges mean the area beside them, towards the middle of the triangle that was pointed at (generic_place.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/filters/filter.hpp"
#include "core/inspect/components.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Where somebody points.
struct PickedPlace {
  std::uint32_t triangle = 0;  ///< index into Environment::triangles
  Vec3 point;                  ///< on it, as well as doubles can tell; environment units, Z up
};

enum class PlaceVerdict {
  Walkable,
  NoArea,          ///< the triangle is degenerate
  Vertical,        ///< it is a wall
  FacesDown,       ///< no triangle in its plane that faces up is here
  NeverFloor,      ///< it faces up, but is no floor before the first filter
  TooSteep,        ///< SlopeFilter
  TooLow,          ///< VerticalClearanceFilter
  RegionTooSmall,  ///< AreaFilter
  Moved,           ///< a filter that moves vertices left nothing here
};

/// A triangle above a place.
struct TriangleAbove {
  std::uint32_t triangle = 0;  ///< index into Environment::triangles
  double height = 0;           ///< above the place, rounded; > 0
};

struct PlaceExplanation {
  PickedPlace place;  ///< the point lifted to the triangle and rounded; of a vertical one as it was given
  PlaceVerdict verdict = PlaceVerdict::Walkable;
  /// The step that rejected it: index into Pipeline::steps. Empty where it is walkable or never was, before any filter.
  std::optional<std::size_t> step;
  double limit = 0;  ///< of that step: degrees, height or area, as its parameter

  /// Between the triangle's normal and up, degrees in [0, 180], rounded; not of a degenerate one.
  double slope = 0;
  /// The triangle whose plane SlopeFilter rejected, where an earlier filter had moved its corners.
  std::optional<double> movedSlope;
  /// The lowest thing above the place, in the environment as it is; empty: nothing, the height is unlimited. Vertical
  /// triangles are above nothing.
  std::optional<TriangleAbove> above;
  /// TooLow: what is within the clearance, in the environment as the filter had it.
  std::optional<TriangleAbove> obstacle;
  /// Vertical triangles that stand exactly here and reach into the largest clearance of the pipeline: the place is on
  /// an obstacle edge, which agents cannot cross.
  std::vector<std::uint32_t> walls;
  /// Another triangle in the same plane that is the floor here, where the one that was pointed at is not: it faces
  /// down, or lies there a second time.
  std::optional<std::uint32_t> floor;
  double regionArea = 0;  ///< RegionTooSmall: of what was removed, rounded

  // Walkable:
  std::optional<std::uint32_t> layer;  ///< empty when no layer filter ran
  std::uint32_t component = 0;         ///< place in components()
  double componentArea = 0;
};

/// What one run left for questions. Immutable; shared by threads.
class Inspector {
 public:
  /// `states` are stepStates() of the environment and the pipeline, and `product` is the run's mesh. `context` cancels.
  Inspector(std::shared_ptr<const Environment> environment, Pipeline pipeline, std::vector<StatePtr> states,
            std::shared_ptr<const NavigationMesh> product, RunContext& context);

  /// A point beside its triangle counts as the nearest one in it, on the way to its middle. Throws InputError when the
  /// triangle does not exist or the point is not finite, Cancelled, or std::bad_alloc. A few milliseconds.
  [[nodiscard]] PlaceExplanation explain(const PickedPlace& place, RunContext& context) const;

  /// The highest place at or under a point; one that is above it by no more than a millionth of the environment's
  /// diagonal is at it, as typed coordinates are rounded. Where several triangles lie there, one that faces up. Empty
  /// where there is none.
  [[nodiscard]] std::optional<PickedPlace> placeBelow(const Vec3& point) const;

  /// The place of the environment that is nearest to a point, in doubles; of several triangles the first. Empty where
  /// there is none, or the point is not finite. Looks at every triangle.
  [[nodiscard]] std::optional<PickedPlace> placeNear(const Vec3& point) const;

  [[nodiscard]] const Environment& environment() const { return *environment_; }
  [[nodiscard]] const Pipeline& pipeline() const { return pipeline_; }
  [[nodiscard]] const NavigationMesh& product() const { return *product_; }
  [[nodiscard]] const Components& components() const { return components_; }

 private:
  void findProductPlace(PlaceExplanation& explanation) const;

  std::shared_ptr<const Environment> environment_;
  Pipeline pipeline_;
  std::vector<std::size_t> steps_;  ///< the enabled ones
  std::vector<StatePtr> states_;
  std::shared_ptr<const NavigationMesh> product_;
  Components components_;
  std::vector<std::int32_t> faceOf_;  ///< for each triangle of the environment its number in the first state
};

}  // namespace footfall::detail
