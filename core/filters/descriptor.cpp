// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "footfall/filter.hpp"

namespace footfall {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::max();
constexpr double kLargestInteger = 2147483647;

// --- Parameters that several descriptors share -----------------------------------------------------------------------

constexpr ParameterDescriptor kMinimumTriangles{
    .name = "min",
    .label = "Fewest triangles",
    .help = "A cell with no more triangles than this is not cut again.",
    .type = ParameterType::Integer,
    .unit = Unit::Count,
    .defaultValue = 50,
    .minimum = 1,
    .maximum = kLargestInteger,
};

constexpr ParameterDescriptor kMaximumDepth{
    .name = "depth",
    .label = "Largest depth",
    .help = "How many times the whole environment may be cut, one cut inside the other.",
    .type = ParameterType::Integer,
    .unit = Unit::Count,
    .defaultValue = 3,
    .minimum = 1,
    .maximum = 32,
};

constexpr ParameterDescriptor kRoundCuts{
    .name = "round",
    .label = "Round the cuts",
    .help =
        "Whether points on a cut are rounded to doubles where a cell's triangles are shown or handed on. In the thesis "
        "that keeps numbers small; here they vanish in Collapse, so both values give the same result.",
    .type = ParameterType::Boolean,
    .unit = Unit::None,
    .defaultValue = 1,
    .minimum = 0,
    .maximum = 1,
};

ParameterDescriptor optional(ParameterDescriptor parameter) {
  parameter.optional = true;
  return parameter;
}

// --- Filters ---------------------------------------------------------------------------------------------------------

FilterDescriptor duplication() {
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
  };
}

FilterDescriptor degeneracy() {
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
  };
}

FilterDescriptor slope() {
  return {
      .type = FilterType::Slope,
      .name = "SlopeFilter",
      .aliases = {},
      .label = "Slope",
      .help =
          "Keeps what is not too steep to walk on. The comparison is exact: a ramp of exactly the maximum slope "
          "stays walkable. Triangles that face down are never walkable. What is removed stays an obstacle.",
      .precondition = "",
      .effect = "Every walkable triangle faces up and is inclined by at most the maximum slope.",
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
      }},
      .kind = FilterKind::Filter,
      .scope = Scope::Local,
  };
}

FilterDescriptor verticalClearance() {
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
      .source = "thesis 3.2, filter 4; obstacle edges: 4.4.2, algorithm 3",
      .parameters = {{
          .name = "height",
          .label = "Clearance",
          .help = "The free height that an agent needs. An obstacle at exactly this height is no obstacle. Less than "
                  "about 1e-29 of the largest coordinate is refused.",
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

FilterDescriptor step() {
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
          "straight along the plan. Filters that follow keep links where they leave both borders; another StepFilter "
          "adds to them.",
      .source = "ours",
      .parameters = {{
                         .name = "step",
                         .label = "Step",
                         .help = "How high an agent climbs at once. A step of exactly this height is climbed.",
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
                         .help = "How wide a gap an agent steps over, seen from above. 0: borders must coincide.",
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

FilterDescriptor radius() {
  return {
      .type = FilterType::Radius,
      .name = "RadiusFilter",
      .aliases = {},
      .label = "Radius",
      .help =
          "Removes what is too near the border of the walkable area for an agent with a body: walls, edges that it "
          "could fall from, and the ends of the world. Distances are those of a straight walk, seen from above; steps "
          "are no border.",
      .precondition = "",
      .effect =
          "No walkable place is nearer to a wall than the radius, or to a ledge than its own distance, and none that "
          "is "
          "farther than that by more than the tolerance is removed. Straight borders move by the distance, rounded "
          "outwards; round corners are polygons.",
      .source = "ours",
      .parameters = {{
                         .name = "radius",
                         .label = "Radius",
                         .help = "How far an agent's middle stays away from walls: borders where something reaches "
                                 "higher than a step and not above its head. 0: walls keep nothing away.",
                         .type = ParameterType::Real,
                         .unit = Unit::Length,
                         .defaultValue = 0.3,
                         .minimum = 0,
                         .maximum = kNoLimit,
                     },
                     {
                         .name = "ledges",
                         .label = "From ledges",
                         .help = "How far it stays away from all other borders: drops and ends of the world. Another "
                                 "distance than the radius needs a VerticalClearanceFilter before it. 0: ledges keep "
                                 "nothing away.",
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
                         .help =
                             "By what part of the distances more than that may be removed at round corners. Smaller "
                             "ones give rounder corners, and more triangles.",
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

FilterDescriptor drop() {
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
                         .help = "How deep an agent drops. A drop of exactly this depth is taken.",
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
                         .help =
                             "How far outwards, seen from above, an agent lands at most. Behind a RadiusFilter give "
                             "at least twice its radius.",
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

FilterDescriptor reachable() {
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

FilterDescriptor area() {
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

FilterDescriptor simplification() {
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
      .source = "thesis 3.2, filter 6; approximate form: 5.1.2",
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
  };
}

FilterDescriptor layerSubdivision() {
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
  };
}

FilterDescriptor rounding() {
  return {
      .type = FilterType::Rounding,
      .name = "RoundingFilter",
      .aliases = {},
      .label = "Rounding",
      .help =
          "Gives every vertex double coordinates and repairs what rounding can break: corners that fall together, "
          "triangles that lose their area or turn over. Tells how many of each case it met.",
      .precondition = "",
      .effect = "Every vertex has double coordinates and no walkable triangle is degenerate or turned over.",
      .source = "thesis 4.4.2, cases 1 to 5",
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
  };
}

// --- Parallel blocks -------------------------------------------------------------------------------------------------

FilterDescriptor gridStrategy() {
  const auto count = [](std::string_view name, std::string_view label, std::string_view help) {
    return ParameterDescriptor{.name = name,
                               .label = label,
                               .help = help,
                               .type = ParameterType::Integer,
                               .unit = Unit::Count,
                               .defaultValue = 2,
                               .minimum = 1,
                               .maximum = kLargestInteger};
  };
  return {
      .type = FilterType::GridStrategy,
      .name = "GridStrategy",
      .aliases = {},
      .label = "Grid strategy",
      .help =
          "Cuts the environment into a grid of equal rectangles in the plan and begins a parallel block. Good where "
          "obstacles are spread evenly.",
      .precondition = "A Collapse follows, with only local filters in between.",
      .effect = "The filters up to Collapse run on each cell on its own.",
      .source = "thesis 4.3.1",
      .parameters = {count("n", "Columns", "Number of cells along x."), count("m", "Rows", "Number of cells along y.")},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
  };
}

FilterDescriptor recursiveStrategy() {
  return {
      .type = FilterType::RecursiveStrategy,
      .name = "RecursiveStrategy",
      .aliases = {},
      .label = "Recursive strategy",
      .help =
          "Cuts the environment into four equal rectangles, and each of them again as long as it holds many triangles, "
          "and begins a parallel block.",
      .precondition = "A Collapse follows, with only local filters in between.",
      .effect = "The filters up to Collapse run on each cell on its own.",
      .source = "thesis 4.3.2",
      .parameters = {kMinimumTriangles, kMaximumDepth, optional(kRoundCuts)},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
  };
}

FilterDescriptor sortedRecursiveStrategy() {
  return {
      .type = FilterType::SortedRecursiveStrategy,
      .name = "SortedRecursiveStrategy",
      .aliases = {"SmartRecursiveStrategy"},
      .label = "Sorted recursive strategy",
      .help =
          "Cuts the environment into halves of about equally many triangles, across x and y in turn and again as long "
          "as a part holds many, and begins a parallel block.",
      .precondition = "A Collapse follows, with only local filters in between.",
      .effect = "The filters up to Collapse run on each cell on its own.",
      .source = "thesis 4.3.3",
      .parameters = {kMinimumTriangles, kMaximumDepth, kRoundCuts},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
  };
}

FilterDescriptor heightAwareStrategy() {
  ParameterDescriptor least = kMinimumTriangles;
  least.label = "Least work";
  least.help =
      "A cell with no more estimated work than this is not cut again. The unit is one triangle that nothing stands on.";
  return {
      .type = FilterType::HeightAwareStrategy,
      .name = "HeightAwareStrategy",
      .aliases = {},
      .label = "Height-aware strategy",
      .help =
          "Divides the floors, across the plan and between storeys, into cells of about equal work, each with only the "
          "obstacles that can stand in the clearance above its floors, and begins a parallel block. Good for towers "
          "and buildings with storeys.",
      .precondition = "A Collapse follows, with only local filters in between.",
      .effect = "The filters up to Collapse run on each cell on its own.",
      .source = "ours; thesis 6.1, first item of future work",
      .parameters = {least, kMaximumDepth, optional(kRoundCuts)},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
  };
}

FilterDescriptor autoStrategy() {
  return {
      .type = FilterType::AutoStrategy,
      .name = "AutoStrategy",
      .aliases = {"Auto"},
      .label = "Automatic strategy",
      .help =
          "Picks a strategy and its depth from the environment and the number of threads, says what it picked and why, "
          "and begins a parallel block. Small environments stay in one cell.",
      .precondition = "A Collapse follows, with only local filters in between.",
      .effect = "The filters up to Collapse run on each cell on its own.",
      .source = "ours",
      .parameters = {},
      .kind = FilterKind::Strategy,
      .scope = Scope::Global,
  };
}

FilterDescriptor collapse() {
  return {
      .type = FilterType::Collapse,
      .name = "Collapse",
      .aliases = {},
      .label = "Collapse",
      .help =
          "Ends a parallel block: puts the cells together again. The seams vanish, so that the result is the one "
          "of the same filters without a block.",
      .precondition = "A strategy stands before it.",
      .effect = "One environment again, without a trace of the cells.",
      .source = "thesis 4.1, 5.1.1",
      .parameters = {},
      .kind = FilterKind::Collapse,
      .scope = Scope::Global,
  };
}

}  // namespace

std::span<const FilterDescriptor> filterDescriptors() {
  static const std::vector<FilterDescriptor> descriptors = {
      duplication(),
      degeneracy(),
      slope(),
      verticalClearance(),
      step(),
      radius(),
      drop(),
      reachable(),
      area(),
      simplification(),
      layerSubdivision(),
      rounding(),
      gridStrategy(),
      recursiveStrategy(),
      sortedRecursiveStrategy(),
      heightAwareStrategy(),
      autoStrategy(),
      collapse(),
  };
  return descriptors;
}

const FilterDescriptor& filterDescriptor(FilterType type) {
  return filterDescriptors()[static_cast<std::size_t>(type)];
}

const FilterDescriptor* findFilter(std::string_view nameOrAlias) {
  for (const FilterDescriptor& filter : filterDescriptors()) {
    if (filter.name == nameOrAlias || std::ranges::count(filter.aliases, nameOrAlias) > 0) return &filter;
  }
  return nullptr;
}

}  // namespace footfall
