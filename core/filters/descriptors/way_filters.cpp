// Filters that say where an agent of given measures can go.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptors/descriptors.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

FilterDescriptor describeStep() {
  static const FilterTraits kTraits{
      .removals = {},
      .parameters = {{AgentSize::Step, MeasureKind::Height}, {AgentSize::Gap, MeasureKind::Length}},
      .makesBorders = never,
      .clearanceNeed = needsClearance,
      .readsObstacles = always,
      .leavesOutObstacles = false,
      .keepsDrops = false,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::Links>,
      .tileProblem = kNoText,
      .problem = noProblem,
  };
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
      .traits = &kTraits,
  };
}

FilterDescriptor describeDrop() {
  static const FilterTraits kTraits{
      .removals = {},
      .parameters = {{AgentSize::Drop, {}}, kPlainParameter},
      .makesBorders = never,
      .clearanceNeed = needsClearance,
      .readsObstacles = always,
      .leavesOutObstacles = false,
      .keepsDrops = true,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::Never>,
      .tileProblem = kSeesAcrossCells,
      .problem = noProblem,
  };
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
      .traits = &kTraits,
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
  static const FilterTraits kTraits{
      .removals = {{
          .verdict = PlaceVerdict::Unreachable,
          .word = "unreachable",
          .headline = FOOTFALL_TEXT("Not walkable: unreachable"),
          .reason = FOOTFALL_TEXT("It cannot be reached from the seeds."),
          .reasonWithoutMeasure = kNoText,
          .measure = PlaceMeasure::None,
          .limit = {},
          .legend = FOOTFALL_TEXT("Cannot be reached"),
          .paint = RemovalPaint{{188, 180, 132}, kYellow, FillPattern::Grid},
      }},
      .parameters = {kPlainParameter, kPlainParameter, kPlainParameter},
      .makesBorders = never,
      .clearanceNeed = needsNoClearance,
      .readsObstacles = never,
      .leavesOutObstacles = false,
      .keepsDrops = true,
      .reach = movesNothing,
      .tileUse = tilesAlways<TileUse::Never>,
      .tileProblem = kSeesAcrossCells,
      .problem =
          [](std::string_view filter, StepValues values) {
            return values.empty() ? Text(FOOTFALL_TEXT("%1 has no seed; give the coordinates of a walkable place, or "
                                                       "click one in the editor"),
                                         filter)
                                  : Text();
          },
  };
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
      .traits = &kTraits,
  };
}

}  // namespace footfall::detail
