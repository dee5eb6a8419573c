// Why is a place walkable, or why not? And which parts of a walkable area are connected?
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/place_verdict.hpp"
#include "footfall/run.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

namespace detail {
struct InspectedRun;
}

// --- Connected parts -------------------------------------------------------------------------------------------------

struct Component {
  double area = 0;  ///< surface area, rounded; the square of the environment's unit
  std::size_t triangles = 0;
  Vec3 lower, upper;                  ///< the box around it
  Vec3 centre;                        ///< centre of mass; it may lie beside the component
  std::vector<std::uint32_t> layers;  ///< layers in which it has a part, ascending; empty when there are no layers
  std::uint32_t firstTriangle = 0;
};

/// The connected parts of a walkable area: where can agents get to without leaving it?
struct Components {
  std::vector<Component> list;            ///< largest area first, then by `firstTriangle`
  std::vector<std::uint32_t> ofTriangle;  ///< index in `list` of each triangle of the mesh

  [[nodiscard]] double totalArea() const;
  /// The probability that two random places, each taken by area, are connected: the sum of the squared shares of the
  /// area, 0 to 1; 0 without any area.
  [[nodiscard]] double connectedShare() const;
};

/// Triangles belong to one component when they share an edge by its two vertices: an agent crosses it, also from layer
/// to layer; or when a step (NavigationMesh::links) leads from one to the other. The two sides of an obstacle edge have
/// vertices of their own, so it parts components, and so does a single vertex in common. Linear in the mesh; on all
/// threads. Throws Cancelled when `context` (may be null) is cancelled.
Components findComponents(const NavigationMesh& mesh, const RunContext* context = nullptr);

/// A proven lower bound of the number of layers: the most triangles that were found over one place of the plan, each of
/// which needs a layer of its own. A few thousand places are tried, so a larger bound may exist; the result does not
/// depend on the number of threads. 0 without layers. O(n log n) for n triangles; on all threads.
std::uint32_t leastLayers(const NavigationMesh& mesh);

/// A proven lower bound of the number of connections, however many layers there are: a part that hangs together over
/// edges and has n floors over one place is divided into n layers or more, so n - 1 of its edges at least are
/// connections; the sum over all parts. Places are tried and work is done as for leastLayers(). Often far below the
/// optimum, which is NP-hard to find: a wide ramp is divided along many edges, and one of them counts here.
std::size_t leastConnections(const NavigationMesh& mesh);

// --- Places ----------------------------------------------------------------------------------------------------------

/// A place that was picked.
struct PickedPlace {
  std::uint32_t triangle = 0;  ///< index into Environment::triangles
  Vec3 point;                  ///< point on it, within rounding; environment units, Z up
};

/// A triangle above a place.
struct TriangleAbove {
  std::uint32_t triangle = 0;  ///< index into Environment::triangles
  double height = 0;           ///< height above the place, rounded; > 0
};

struct PlaceExplanation {
  PickedPlace place;  ///< the point lifted to the triangle and rounded; of a vertical one as it was given
  PlaceVerdict verdict = PlaceVerdict::Walkable;
  /// The step that rejected it: index into Pipeline::steps. Empty where it is walkable or never was, before any filter.
  std::optional<std::size_t> step;
  double limit = 0;  ///< limit of that step: degrees, height, area or distance, as its parameter

  /// The angle between the triangle's normal and up, degrees in [0, 180], rounded; not of a degenerate one.
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
  /// The distances from a place that is walkable, or would be without RadiusFilter, to the nearest wall and the nearest
  /// ledge, straight over the walkable area before the first RadiusFilter (before the one that rejected it), in the
  /// plan, rounded. Empty when there is none. Without a clearance filter, everything higher than a step is a wall.
  std::optional<double> wallDistance, ledgeDistance;

  // Walkable:
  std::optional<std::uint32_t> layer;  ///< empty when no layer filter ran
  std::uint32_t component = 0;         ///< place in components()
  double componentArea = 0;
};

/// The states of one run, kept for questions about places. A place is a point of a triangle of the environment. It is
/// walkable while the state's mesh covers it in that triangle's plane, whichever triangle of the plane carries it; the
/// first step whose state does not cover it any more has rejected it. So answers state exactly what the steps did.
/// Points on edges mean the area beside them, towards the middle of the picked triangle.
///
/// Immutable: any thread may use it.
class Inspector {
 public:
  /// `product` is the mesh that runPipeline() gave for this environment and pipeline. The states that the run went
  /// through are taken from `cache` (may be null), and made again where it has none. `context` (may be null) cancels;
  /// `threads` as in runPipeline(). Throws what runPipeline() throws.
  Inspector(std::shared_ptr<const Environment> environment, Pipeline pipeline,
            std::shared_ptr<const NavigationMesh> product, ResultCache* cache = nullptr, RunContext* context = nullptr,
            int threads = 0);
  ~Inspector();
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  /// A point beside its triangle counts as the nearest one in it, on the way to its middle. Throws InputError when the
  /// triangle does not exist or the point is not finite, Cancelled, or std::bad_alloc. A few milliseconds.
  [[nodiscard]] PlaceExplanation explain(const PickedPlace& place, RunContext* context = nullptr) const;

  /// The highest place at or under a point; one that is above it by no more than a millionth of the environment's
  /// diagonal is at it, as typed coordinates are rounded. Where several triangles lie there, one that faces up. Empty
  /// where there is none.
  [[nodiscard]] std::optional<PickedPlace> placeBelow(const Vec3& point) const;

  /// The place of the environment that is nearest to a point, in doubles; of several triangles the first. Empty where
  /// there is none, or the point is not finite. Looks at every triangle.
  [[nodiscard]] std::optional<PickedPlace> placeNear(const Vec3& point) const;

  [[nodiscard]] const Environment& environment() const;
  [[nodiscard]] const Pipeline& pipeline() const;
  [[nodiscard]] const NavigationMesh& product() const;
  [[nodiscard]] const Components& components() const;

 private:
  std::unique_ptr<const detail::InspectedRun> inside_;
};

}  // namespace footfall
