// The facts about a filter that other code decides by. The descriptor of each filter has one FilterTraits, so that a
// new filter is described in one place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/fill_pattern.hpp"
#include "core/base/palette.hpp"
#include "footfall/place_verdict.hpp"
#include "footfall/text.hpp"

namespace footfall {
struct FilterDescriptor;
}

namespace footfall::detail {

/// The values of a step; FilterDescriptor::takes() holds for them, and each is in the range of its parameter.
using StepValues = std::span<const double>;

/// The number of a place that a filter compares with its limit.
enum class PlaceMeasure : std::uint8_t {
  None,
  Slope,          ///< degrees
  Headroom,       ///< the height of the lowest thing above
  RegionArea,     ///< the area of the region around the place
  WallDistance,   ///< the distance to the nearest wall
  LedgeDistance,  ///< the distance to the nearest ledge
};

/// How the places of a removal are drawn: pale in the result, vivid where only reasons are shown.
struct RemovalPaint {
  Rgb pale;
  Rgb vivid;
  FillPattern pattern;
};

/// A reason for which a filter removes places.
struct Removal {
  PlaceVerdict verdict;
  std::string_view word;  ///< the verdict in JSON, e.g. "too_steep"
  Pattern headline;       ///< "Not walkable: too steep"
  /// A sentence without parentheses: %1 is the measure and %2 the limit, both with their units, %3 the obstacle.
  Pattern reason;
  Pattern reasonWithoutMeasure;  ///< the same, for places whose measure is not known; has no %1 and no %3
  PlaceMeasure measure;
  std::optional<std::size_t> limit;   ///< the parameter that is the limit
  Pattern legend;                     ///< "Too steep"; in the legend, where there is a paint
  std::optional<RemovalPaint> paint;  ///< empty: places look like undecided ones
};

/// How a pipeline that keeps to a bound of memory runs a filter.
enum class TileUse : std::uint8_t {
  InCells,        ///< a cell runs it alone: the filter looks at what a cell sees
  Regions,        ///< AreaFilter: regions are added up over all cells
  Links,          ///< StepFilter: once, behind the filters in cells
  OverTiles,      ///< behind all of these, with the neighbourhood of each tile
  OverTilesOnce,  ///< the same, and behind a StepFilter at most once
  Never,          ///< FilterTraits::tileProblem says why
  LeftOut,        ///< strategies and Collapse, which change no result
};

/// A size of an agent, which drives a parameter.
enum class AgentSize : std::uint8_t { Height, MaxSlope, Step, Gap, Radius, Drop };

/// How a value is drawn and dragged at a place of the level. A slope is an angle, a clearance and a step are heights, a
/// gap is a length over a floor, a radius is a distance to all sides.
enum class MeasureKind : std::uint8_t { Angle, Height, Length, Distance };

struct ParameterUse {
  std::optional<AgentSize> agentSize;  ///< empty: agents do not drive it
  std::optional<MeasureKind> drawnAs;  ///< empty: it is not drawn
};

/// A distance: a length, and a part of the environment's diagonal.
struct Reach {
  double length;
  double ofDiagonal;
};

/// No member has a default: a description that leaves one out does not compile (-Wmissing-field-initializers).
struct FilterTraits {
  /// The reasons for which the filter removes places, the most general one first. A place that disappears without one
  /// has the verdict Removed.
  std::vector<Removal> removals;
  std::vector<ParameterUse> parameters;  ///< those of the first parameters; the others are plain
  /// True when the step makes borders, or moves some, that a StepFilter before it has not seen.
  bool (*makesBorders)(StepValues values);
  /// kNoText, or, for a step that a VerticalClearanceFilter must run before, the message where none does: "%1 needs %2
  /// before it", with both filters.
  Pattern (*clearanceNeed)(StepValues values);
  /// True when the step's result depends on triangles that are no floors.
  bool (*readsObstacles)(StepValues values);
  bool leavesOutObstacles;  ///< the result has no obstacles where no later step reads them
  bool keepsDrops;          ///< the filter keeps a drop's edge and its landing, or removes both
  /// How far the step may move what it does not remove.
  Reach (*reach)(StepValues values);
  TileUse (*tileUse)(StepValues values);
  /// The message about steps whose use in tiles is Never: "%1: %2 ...; what to do"; %1 is the place of the step, %2 its
  /// filter.
  Pattern tileProblem;
  /// Checks the values of a step against each other: what is wrong and what to do, where %1 is the name of the filter;
  /// an empty text when nothing is.
  Text (*problem)(std::string_view filter, StepValues values);
};

// --- Usual members ---------------------------------------------------------------------------------------------------

inline constexpr Pattern kNoText{""};
inline bool always(StepValues /*values*/) { return true; }
inline bool never(StepValues /*values*/) { return false; }
inline Pattern needsNoClearance(StepValues /*values*/) { return kNoText; }
inline Pattern needsClearance(StepValues /*values*/) { return FOOTFALL_TEXT("%1 needs %2 before it"); }
inline Reach movesNothing(StepValues /*values*/) { return {0, 0}; }
inline Text noProblem(std::string_view /*filter*/, StepValues /*values*/) { return {}; }
template <TileUse kUse>
TileUse tilesAlways(StepValues /*values*/) {
  return kUse;
}
inline constexpr ParameterUse kPlainParameter{{}, {}};
inline constexpr Pattern kSeesAcrossCells = FOOTFALL_TEXT(
    "%1: %2 sees across cells and cannot keep to a bound of memory; leave it out, or run without the bound, with all "
    "of "
    "the environment in memory");

/// The removal of a filter with a verdict; null where it has none.
const Removal* findRemoval(const FilterTraits& traits, PlaceVerdict verdict);

/// The use of a parameter; that of a plain one for parameters behind those that FilterTraits::parameters has.
ParameterUse parameterUse(const FilterDescriptor& filter, std::size_t parameter);

/// The parameter that a size of agents drives.
struct DrivenParameter {
  const FilterDescriptor* filter;
  std::size_t parameter;
};
DrivenParameter drivenBy(AgentSize size);

}  // namespace footfall::detail
