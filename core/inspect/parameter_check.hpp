// What a pipeline's numbers will do to a level that nobody wants, told before the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::detail {

/// What parameters are compared with; measured once for an environment, in its units.
struct LevelMeasures {
  Vec3 size;                        ///< of the box around its vertices, the height last
  std::vector<double> wallHeights;  ///< of upright triangles with a level side, ascending; two make a wall
  std::vector<double> openings;     ///< heights under lintels, ascending; two make a door (measureOpenings())
  double metresPerUnit = 1;
  bool scaleGuessed = false;
};

/// Rounded; takes time in proportion to the triangles.
LevelMeasures measureLevel(const Environment& environment, const Poll& poll = {});

struct ParameterNote {
  std::optional<std::size_t> step;  ///< of the pipeline, from 0; empty: it is about the scale
  Text text;                        ///< what will go wrong and what to do
};

/// Of the steps that are on:
/// - a step that is a rounding, or at most a twentieth, below the most frequent riser: the most frequent height of
/// walls
///   among those of at most half of the clearance. Risers of exactly the step are climbed, and nothing is said;
/// - agents that are a little taller than all that looks like a door;
/// - agents that are taller than the level is in any direction;
/// - and a guessed scale that makes the level larger than levels are, or smaller.
std::vector<ParameterNote> checkParameters(const LevelMeasures& level, const Pipeline& pipeline);

}  // namespace footfall::detail
