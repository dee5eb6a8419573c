// Filters that change how the walkable area is made of triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptors/descriptors.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {
namespace {

/// The removal of filters that move vertices: a place may be left without a triangle.
Removal movedAway(std::optional<std::size_t> limit) {
  return {
      .verdict = PlaceVerdict::Moved,
      .word = "moved",
      .headline = FOOTFALL_TEXT("Not walkable: merged away"),
      .reason = FOOTFALL_TEXT("The filter moved vertices, and no triangle is here any more."),
      .reasonWithoutMeasure = kNoText,
      .measure = PlaceMeasure::None,
      .limit = limit,
      .legend = kNoText,
      .paint = {},
  };
}

}  // namespace

FilterDescriptor describeDuplication() {
  static const FilterTraits kTraits{
      .removals = {movedAway(0)},
      .parameters = {kPlainParameter},
      .makesBorders = always,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = always,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach =
          [](StepValues values) {
            return Reach{values[0], 0};
          },
      .tileUse = [](StepValues values) { return values[0] == 0 ? TileUse::InCells : TileUse::Never; },
      .tileProblem =
          FOOTFALL_TEXT("%1: %2 joins vertices across cells when its distance is above 0 and cannot keep to a bound of "
                        "memory; leave it out, or run without the bound, with all of the environment in memory"),
      .problem = noProblem,
  };
  return {
      .type = FilterType::Duplication,
      .name = "DuplicationFilter",
      .aliases = {},
      .label = "Duplication",
      .help =
          "Merges vertices that lie close together, so that triangles that only look connected share their "
          "corners. A distance of 0 joins vertices at equal positions and moves nothing. A larger distance moves "
          "vertices and may make triangles degenerate: let a DegeneracyFilter follow.",
      .precondition = "",
      .effect =
          "No two separate vertices are closer to each other than the distance. The result does not depend on "
          "the order of the vertices in the file.",
      .source = "thesis 3.2, filter 2",
      .parameters = {{
          .name = "distance",
          .label = "Distance",
          .help = "Vertices closer than this become one; 0 joins equal positions only.",
          .type = ParameterType::Real,
          .unit = Unit::Length,
          .defaultValue = 0,
          .minimum = 0,
          .maximum = kNoLimit,
      }},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
      .traits = &kTraits,
  };
}

FilterDescriptor describeDegeneracy() {
  static const FilterTraits kTraits{
      .removals = {{
          .verdict = PlaceVerdict::NoArea,
          .word = "no_area",
          .headline = FOOTFALL_TEXT("Not walkable: without area"),
          .reason = FOOTFALL_TEXT("The corners of this triangle lie on one line."),
          .reasonWithoutMeasure = kNoText,
          .measure = PlaceMeasure::None,
          .limit = {},
          .legend = kNoText,
          .paint = {},
      }},
      .parameters = {},
      .makesBorders = always,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = always,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::InCells>,
      .tileProblem = kNoText,
      .problem = noProblem,
  };
  return {
      .type = FilterType::Degeneracy,
      .name = "DegeneracyFilter",
      .aliases = {},
      .label = "Degeneracy",
      .help =
          "Removes triangles without area: those with a repeated corner and those whose corners lie on one line. "
          "An obstacle edge of a removed triangle moves to the neighbour that shares it.",
      .precondition = "",
      .effect = "No triangle of the environment, walkable or rejected, is degenerate.",
      .source = "thesis 3.2, filter 1; cases 2 to 4 and algorithm 3 of 4.4.2",
      .parameters = {},
      .kind = FilterKind::Filter,
      .scope = Scope::Local,
      .traits = &kTraits,
  };
}

FilterDescriptor describeSimplification() {
  static const FilterTraits kTraits{
      .removals = {movedAway({})},
      .parameters = {kPlainParameter, kPlainParameter},
      .makesBorders = [](StepValues values) { return values[0] != 0; },
      .clearanceNeed = needsNoClearance,
      .readsObstacles = never,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach =
          [](StepValues values) {
            return Reach{0, values[0] == 0 ? 0 : values[1]};
          },
      .tileUse = [](StepValues values) { return values[0] == 0 ? TileUse::OverTilesOnce : TileUse::Never; },
      .tileProblem =
          FOOTFALL_TEXT("%1: %2 keeps to a bound of memory exactly only, not approximately; leave that out, or run "
                        "without the bound, with all of the environment in memory"),
      .problem = noProblem,
  };
  return {
      .type = FilterType::Simplification,
      .name = "SimplificationFilter",
      .aliases = {},
      .label = "Simplification",
      .help =
          "Covers each flat region with as few triangles as its outline needs. Outlines, holes and obstacle edges "
          "stay as they are. The approximate form also joins regions that are nearly coplanar.",
      .precondition = "No walkable triangle is degenerate.",
      .effect =
          "Other triangles, the same walkable area. In the approximate form vertices may move, by a stated bound "
          "at most.",
      .source = "thesis 3.2, filter 6; approximate form: 5.1.2, tolerance: listing of 5.4",
      .parameters = {{
                         .name = "approximate",
                         .label = "Approximate",
                         .help = "Treat nearly coplanar neighbours as coplanar.",
                         .type = ParameterType::Boolean,
                         .unit = Unit::None,
                         .defaultValue = 0,
                         .minimum = 0,
                         .maximum = 1,
                         .optional = true,
                     },
                     {
                         .name = "tolerance",
                         .label = "Tolerance",
                         .help = "In the approximate form, triangles count as coplanar when the dot product of their "
                                 "unit normals is above 1 minus this.",
                         .type = ParameterType::Real,
                         .unit = Unit::None,
                         .defaultValue = 0.000001,
                         .minimum = 0,
                         .maximum = 1,
                         .maximumOpen = true,
                         .optional = true,
                     }},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
      .traits = &kTraits,
  };
}

FilterDescriptor describeLayerSubdivision() {
  static const FilterTraits kTraits{
      .removals = {},
      .parameters = {},
      .makesBorders = never,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = never,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::OverTiles>,
      .tileProblem = kNoText,
      .problem = noProblem,
  };
  return {
      .type = FilterType::LayerSubdivision,
      .name = "LayerSubdivisionFilter",
      .aliases = {"PEELFilter"},
      .label = "Layer subdivision",
      .help =
          "Splits the walkable area into layers, such as the floors of a building, so that each can be drawn as a "
          "flat map. Edges on which two layers meet become connections; the fewer, the better.",
      .precondition = "Every walkable triangle has an area and is not vertical.",
      .effect =
          "No two triangles of one layer overlap in the plan; layers and connections form a multi-layered "
          "environment.",
      .source = "thesis 3.2, filter 7; Hillebrand et al. 2016",
      .parameters = {},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
      .traits = &kTraits,
  };
}

FilterDescriptor describeRounding() {
  static const FilterTraits kTraits{
      .removals = {movedAway({})},
      .parameters = {kPlainParameter},
      .makesBorders = always,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = never,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::Never>,
      .tileProblem = FOOTFALL_TEXT(
          "%1: %2 moves vertices that cells share and cannot keep to a bound of memory; leave it out, or run "
          "without the bound, with all of the environment in memory"),
      .problem = noProblem,
  };
  return {
      .type = FilterType::Rounding,
      .name = "RoundingFilter",
      .aliases = {},
      .label = "Rounding",
      .help =
          "Gives every vertex double coordinates and repairs what rounding can break: corners that fall together, "
          "triangles that lose their area or turn over. Reports the number of each case.",
      .precondition = "",
      .effect = "Every vertex has double coordinates and no walkable triangle is degenerate or turned over.",
      .source = "thesis 5.1.1; 4.4.2, cases 1 to 5",
      .parameters = {{
          .name = "repair",
          .label = "Repair",
          .help = "The thesis's files give this value. Rounding is always repaired here, so both values give the same "
                  "result.",
          .type = ParameterType::Boolean,
          .unit = Unit::None,
          .defaultValue = 1,
          .minimum = 0,
          .maximum = 1,
          .optional = true,
      }},
      .kind = FilterKind::Filter,
      .scope = Scope::Local,
      .traits = &kTraits,
  };
}

}  // namespace footfall::detail
