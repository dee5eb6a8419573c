// Warnings before a run about numbers of the pipeline that do not fit the level.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/inspect/doorways.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::detail {

/// The measures with which parameters are compared; taken once for an environment, in its units.
struct LevelMeasures {
  Vec3 size;                        ///< size of the box around its vertices, the height last
  std::vector<double> wallHeights;  ///< heights of upright triangles with a level side, ascending; two make a wall
  std::vector<Doorway> doorways;    ///< findDoorways()
  double metresPerUnit = 1;
  bool scaleGuessed = false;
};

/// Measures an environment, rounded, in time proportional to its triangles.
LevelMeasures measureLevel(const Environment& environment, const Poll& poll = {});

struct ParameterNote {
  std::optional<std::size_t> step;  ///< step of the pipeline, from 0; empty: the note is about the scale
  Text text;                        ///< the problem and the advice
};

/// The notes on a pipeline's enabled steps:
/// - a step that is a rounding, or at most a twentieth, below the most frequent riser: the most frequent height of
/// walls
///   among those of at most half of the clearance. Risers of exactly the step are climbed, and nothing is said;
/// - agents that are taller than the level is in any direction, or than each of its doorways;
/// - a radius that no doorway under which the agents fit is wide enough for, or not even the level;
/// - and a guessed scale that makes the level larger than levels are, or smaller.
std::vector<ParameterNote> checkParameters(const LevelMeasures& level, const Pipeline& pipeline);

}  // namespace footfall::detail
