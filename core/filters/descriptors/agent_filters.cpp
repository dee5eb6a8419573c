// Filters that say where an agent of given measures can be.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptors/descriptors.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

FilterDescriptor describeSlope() {
  static const FilterTraits kTraits{
      .removals = {{
          .verdict = PlaceVerdict::TooSteep,
          .word = "too_steep",
          .headline = FOOTFALL_TEXT("Not walkable: too steep"),
          .reason = FOOTFALL_TEXT("It rises by %1; at most %2 are allowed."),
          .reasonWithoutMeasure = kNoText,
          .measure = PlaceMeasure::Slope,
          .limit = 0,
          .legend = FOOTFALL_TEXT("Too steep"),
          .paint = RemovalPaint{{176, 150, 128}, kOrange, FillPattern::RisingStripes},
      }},
      .parameters = {{AgentSize::MaxSlope, MeasureKind::Angle}, kPlainParameter},
      .makesBorders = always,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = never,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::InCells>,
      .tileProblem = kNoText,
      .problem = noProblem,
  };
  return {
      .type = FilterType::Slope,
      .name = "SlopeFilter",
      .aliases = {},
      .label = "Slope",
      .help =
          "Keeps what is not too steep to walk on. The comparison is exact: a triangle stays walkable when its slope "
          "is "
          "at most the maximum plus the tolerance. Triangles that face down are never walkable. What is removed stays "
          "an obstacle.",
      .precondition = "",
      .effect = "Every walkable triangle faces up and is inclined by at most the maximum slope and its tolerance.",
      .source = "thesis 3.2, filter 3",
      .parameters = {{
                         .name = "max_slope",
                         .label = "Maximum slope",
                         .help = "The steepest ground that an agent can walk on, measured from the horizontal.",
                         .type = ParameterType::Real,
                         .unit = Unit::Degrees,
                         .defaultValue = 45,
                         .minimum = 0,
                         .maximum = 90,
                         .minimumOpen = true,
                         .maximumOpen = true,
                     },
                     {
                         .name = "tolerance",
                         .label = "Tolerance",
                         .help = "How much steeper ground may be: rounding makes some ramps of exactly the maximum "
                                 "slope a little steeper. 0: not at all.",
                         .type = ParameterType::Real,
                         .unit = Unit::Degrees,
                         .defaultValue = 0.01,
                         .minimum = 0,
                         .maximum = 1,
                         .optional = true,
                     }},
      .kind = FilterKind::Filter,
      .scope = Scope::Local,
      .traits = &kTraits,
  };
}

FilterDescriptor describeVerticalClearance() {
  static const FilterTraits kTraits{
      .removals = {{
          .verdict = PlaceVerdict::TooLow,
          .word = "too_low",
          .headline = FOOTFALL_TEXT("Not walkable: too low"),
          .reason = FOOTFALL_TEXT("Triangle %3 is %1 above it; agents need %2."),
          .reasonWithoutMeasure = FOOTFALL_TEXT("Something is above it within the %2 that agents need."),
          .measure = PlaceMeasure::Headroom,
          .limit = 0,
          .legend = FOOTFALL_TEXT("Too little headroom"),
          .paint = RemovalPaint{{150, 138, 176}, kReddishPurple, FillPattern::FallingStripes},
      }},
      .parameters = {{AgentSize::Height, MeasureKind::Height}},
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
      .type = FilterType::VerticalClearance,
      .name = "VerticalClearanceFilter",
      .aliases = {},
      .label = "Vertical clearance",
      .help =
          "Removes the places where an agent would hit its head: those with anything, walkable or not, straight "
          "above and lower than the clearance. A vertical wall covers no area, so it removes none; where it "
          "reaches into the clearance it leaves obstacle edges, which agents cannot cross. Where walkable "
          "triangles overlap in one plane, one of them stays.",
      .precondition = "",
      .effect =
          "No walkable point has a point of another triangle straight above it and nearer than the clearance; "
          "no place is walkable twice.",
      .source = "thesis 3.2, filter 4; obstacle edges of walls: ours",
      .parameters = {{
          .name = "height",
          .label = "Clearance",
          .help = "The free height that an agent needs. An obstacle at exactly this height is no obstacle; where "
                  "coordinates "
                  "lie on a grid, one that is lower by a step of the grid is none either. Less than about 1e-29 of the "
                  "largest coordinate is refused.",
          .type = ParameterType::Real,
          .unit = Unit::Length,
          .defaultValue = 2,
          .minimum = 0,
          .maximum = kNoLimit,
          .minimumOpen = true,
      }},
      .kind = FilterKind::Filter,
      .scope = Scope::Local,
      .traits = &kTraits,
  };
}

FilterDescriptor describeRadius() {
  static const FilterTraits kTraits{
      .removals = {{
                       .verdict = PlaceVerdict::Removed,
                       .word = "too_near_border",
                       .headline = FOOTFALL_TEXT("Not walkable: too near a border"),
                       .reason = FOOTFALL_TEXT("Agents stay %2 away from borders."),
                       .reasonWithoutMeasure = kNoText,
                       .measure = PlaceMeasure::None,
                       .limit = 0,
                       .legend = FOOTFALL_TEXT("Too near a border"),
                       .paint = RemovalPaint{{140, 172, 150}, kBluishGreen, FillPattern::LevelStripes},
                   },
                   {
                       .verdict = PlaceVerdict::TooNearWall,
                       .word = "too_near_wall",
                       .headline = FOOTFALL_TEXT("Not walkable: too near a wall"),
                       .reason =
                           FOOTFALL_TEXT("Agents stay %2 away from walls; this place is %1 from the nearest one."),
                       .reasonWithoutMeasure = FOOTFALL_TEXT("Agents stay %2 away from walls."),
                       .measure = PlaceMeasure::WallDistance,
                       .limit = 0,
                       .legend = FOOTFALL_TEXT("Too near a wall"),
                       .paint = RemovalPaint{{140, 172, 150}, kBluishGreen, FillPattern::LevelStripes},
                   },
                   {
                       .verdict = PlaceVerdict::TooNearLedge,
                       .word = "too_near_ledge",
                       .headline = FOOTFALL_TEXT("Not walkable: too near a ledge"),
                       .reason = FOOTFALL_TEXT("Agents stay %2 away from ledges: drops and the ends of the level; this "
                                               "place is %1 from the nearest one."),
                       .reasonWithoutMeasure =
                           FOOTFALL_TEXT("Agents stay %2 away from ledges: drops and the ends of the level."),
                       .measure = PlaceMeasure::LedgeDistance,
                       .limit = 1,
                       .legend = FOOTFALL_TEXT("Too near a ledge"),
                       .paint = RemovalPaint{{156, 188, 222}, kSkyBlue, FillPattern::UprightStripes},
                   }},
      .parameters = {{AgentSize::Radius, MeasureKind::Distance}, {{}, MeasureKind::Distance}, kPlainParameter},
      .makesBorders = never,
      .clearanceNeed =
          [](StepValues values) {
            return values[0] == values[1] ? kNoText
                                          : FOOTFALL_TEXT("%1 with a distance of its own to ledges needs %2 before it");
          },
      .readsObstacles = [](StepValues values) { return values[0] != values[1]; },
      .leavesOutObstacles = true,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::Never>,
      .tileProblem = kSeesAcrossCells,
      .problem = noProblem,
  };
  return {
      .type = FilterType::Radius,
      .name = "RadiusFilter",
      .aliases = {},
      .label = "Radius",
      .help =
          "Removes the places that are too near the border of the walkable area for an agent with a body: walls, edges "
          "that it could fall from, and the ends of the level. Distances are those of the shortest walk, seen from "
          "above; steps are no border.",
      .precondition = "",
      .effect =
          "No walkable place is nearer to a wall than the radius, or to a ledge than its own distance, and none that "
          "is "
          "farther than that by more than the tolerance is removed. Straight borders move by the distance, rounded "
          "outwards; round corners are polygons.",
      .source = "ours",
      .parameters =
          {{
               .name = "radius",
               .label = "Radius",
               .help = "The distance that an agent's middle keeps from walls: borders with an obstacle that is higher "
                       "than a step and not above its head. 0: no distance from walls.",
               .type = ParameterType::Real,
               .unit = Unit::Length,
               .defaultValue = 0.3,
               .minimum = 0,
               .maximum = kNoLimit,
           },
           {
               .name = "ledges",
               .label = "From ledges",
               .help = "The distance that it keeps from all other borders: drops and the ends of the level. A distance "
                       "other than the radius needs a VerticalClearanceFilter before it. 0: no distance from ledges.",
               .type = ParameterType::Real,
               .unit = Unit::Length,
               .defaultValue = 0.3,
               .minimum = 0,
               .maximum = kNoLimit,
               .optional = true,
               .follows = 0,
           },
           {
               .name = "tolerance",
               .label = "Tolerance",
               .help = "The share of the distances by which more may be removed at round corners. Smaller values give "
                       "rounder corners and more triangles.",
               .type = ParameterType::Real,
               .unit = Unit::None,
               .defaultValue = 0.01,
               .minimum = 0.0001,
               .maximum = 0.1,
               .optional = true,
           }},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
      .traits = &kTraits,
  };
}

FilterDescriptor describeArea() {
  static const FilterTraits kTraits{
      .removals = {{
          .verdict = PlaceVerdict::RegionTooSmall,
          .word = "region_too_small",
          .headline = FOOTFALL_TEXT("Not walkable: too small an area"),
          .reason = FOOTFALL_TEXT("The connected region around it has an area of %1; it must have more than %2."),
          .reasonWithoutMeasure = kNoText,
          .measure = PlaceMeasure::RegionArea,
          .limit = 0,
          .legend = FOOTFALL_TEXT("Too small an area"),
          .paint = RemovalPaint{{146, 160, 168}, kBlue, FillPattern::Dots},
      }},
      .parameters = {kPlainParameter},
      .makesBorders = never,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = never,
      .leavesOutObstacles = false,
      .keepsDrops = true,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::Regions>,
      .tileProblem = kNoText,
      .problem = noProblem,
  };
  return {
      .type = FilterType::Area,
      .name = "AreaFilter",
      .aliases = {},
      .label = "Area",
      .help =
          "Removes regions that are too small to matter, such as table tops and ledges. A region is what can be "
          "reached over shared edges without crossing an obstacle edge. What is removed stays an obstacle.",
      .precondition = "",
      .effect = "Every walkable region has a surface area above the minimum.",
      .source = "thesis 3.2, filter 5",
      .parameters = {{
          .name = "min_area",
          .label = "Minimum area",
          .help = "Regions of at most this surface area are removed; 0 removes nothing.",
          .type = ParameterType::Real,
          .unit = Unit::Area,
          .defaultValue = 1,
          .minimum = 0,
          .maximum = kNoLimit,
      }},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
      .traits = &kTraits,
  };
}

}  // namespace footfall::detail
