// Filters that change how the walkable area is made of triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptors/descriptors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

FilterDescriptor describeDuplication() {
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

FilterDescriptor describeDegeneracy() {
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

FilterDescriptor describeSimplification() {
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
  };
}

FilterDescriptor describeLayerSubdivision() {
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

FilterDescriptor describeRounding() {
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
  };
}

}  // namespace footfall::detail
