// Filters that say where an agent of given measures can be, and where it can go.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptors/descriptors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

FilterDescriptor describeSlope() {
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
  };
}

FilterDescriptor describeVerticalClearance() {
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
  };
}

FilterDescriptor describeStep() {
  return {
      .type = FilterType::Step,
      .name = "StepFilter",
      .aliases = {},
      .label = "Steps",
      .help =
          "Links borders of the walkable area that lie over each other in the plan, or beside each other with a gap "
          "between them, where an agent can lift its feet from one to the other: stairs, kerbs, thresholds, low walls "
          "without thickness, slits. The area stays as it is; for the filters that follow, what is linked is one "
          "region.",
      .precondition = "A VerticalClearanceFilter comes before it.",
      .effect =
          "Every stretch on which two borders coincide in the plan is linked exactly where their heights differ by at "
          "most the step and nothing lies higher than the step above the lower one and within the clearance above the "
          "higher one. Borders that face each other across a gap are linked where that is proven of all ways over it, "
          "straight along the plan; a stretch of at most twice the gap only where both floors do not hang together "
          "right "
          "there anyway. Filters that follow keep links where they leave both borders; another StepFilter adds to "
          "them.",
      .source = "ours",
      .parameters = {{
                         .name = "step",
                         .label = "Step",
                         .help = "The highest step that an agent climbs, this height included. Where coordinates lie "
                                 "on a grid, a step that is higher by one step of the grid is climbed as well.",
                         .type = ParameterType::Real,
                         .unit = Unit::Length,
                         .defaultValue = 0.4,
                         .minimum = 0,
                         .maximum = kNoLimit,
                         .minimumOpen = true,
                     },
                     {
                         .name = "gap",
                         .label = "Gap",
                         .help = "The widest gap that an agent steps over, seen from above. 0: borders must coincide.",
                         .type = ParameterType::Real,
                         .unit = Unit::Length,
                         .defaultValue = 0.05,
                         .minimum = 0,
                         .maximum = kNoLimit,
                         .optional = true,
                     }},
      .kind = FilterKind::Filter,
      .scope = Scope::Local,
  };
}

FilterDescriptor describeRadius() {
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
  };
}

FilterDescriptor describeDrop() {
  return {
      .type = FilterType::Drop,
      .name = "DropFilter",
      .aliases = {},
      .label = "Drops",
      .help =
          "Finds where an agent can drop from a ledge of the walkable area to a lower place, one way: straight below "
          "the ledge, or where the first floor begins within the reach outwards. Nothing may stand in the way, higher "
          "than the step of the StepFilter before it and within the clearance, or above the landing along the fall. "
          "The area stays as it is.",
      .precondition =
          "A VerticalClearanceFilter comes before it; only AreaFilter, ReachableFilter and DropFilter follow.",
      .effect =
          "Every drop that is found is free. Those that land straight below are all found, but for rounding of their "
          "ends; of those across a gap, all that have a little to spare.",
      .source = "ours",
      .parameters = {{
                         .name = "depth",
                         .label = "Depth",
                         .help = "The deepest drop that an agent takes, this depth included.",
                         .type = ParameterType::Real,
                         .unit = Unit::Length,
                         .defaultValue = 1.5,
                         .minimum = 0,
                         .maximum = kNoLimit,
                         .minimumOpen = true,
                     },
                     {
                         .name = "reach",
                         .label = "Reach",
                         .help = "The largest distance outwards, seen from above, at which an agent lands. After a "
                                 "RadiusFilter, give at least twice its radius.",
                         .type = ParameterType::Real,
                         .unit = Unit::Length,
                         .defaultValue = 0.3,
                         .minimum = 0,
                         .maximum = kNoLimit,
                         .optional = true,
                     }},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
  };
}

namespace {

ParameterDescriptor coordinate(std::string_view name, std::string_view label, std::string_view help) {
  return {
      .name = name,
      .label = label,
      .help = help,
      .type = ParameterType::Real,
      .unit = Unit::Length,
      .defaultValue = 0,
      .minimum = -kNoLimit,
      .maximum = kNoLimit,
  };
}

}  // namespace

FilterDescriptor describeReachable() {
  return {
      .type = FilterType::Reachable,
      .name = "ReachableFilter",
      .aliases = {},
      .label = "Reachable",
      .help =
          "Keeps what can be reached from given places, the seeds. Ways lead over shared edges and steps, and down "
          "over "
          "drops; roofs, islands and the insides of solids go. Put it behind a StepFilter and a DropFilter, where "
          "there is one. A seed means the highest walkable place at or under it, at most the clearance lower; before "
          "any VerticalClearanceFilter, however much lower. "
          "On an edge or a corner it means all that meets there. What is removed stays an obstacle.",
      .precondition = "Each seed has a walkable place under it.",
      .effect = "Every walkable region holds a seed, or is reached over drops from one that does.",
      .source = "ours",
      .parameters = {coordinate("x", "X", "The first coordinate of a seed, as in the environment's file."),
                     coordinate("y", "Y", "The second coordinate of a seed, as in the environment's file."),
                     coordinate("z", "Z", "The third coordinate of a seed, as in the environment's file.")},
      .kind = FilterKind::Filter,
      .scope = Scope::Global,
      .repeats = 3,
      .groups = "seeds",
  };
}

FilterDescriptor describeArea() {
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
  };
}

}  // namespace footfall::detail
