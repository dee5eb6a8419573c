// Warnings before a run about numbers of the pipeline that do not fit the level.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/inspect/doorways.hpp"
#include "core/inspect/near_places.hpp"
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
  /// A triangle that faces up and is not level.
  struct Ramp {
    double slope = 0;  ///< degrees
    double area = 0;
  };
  std::vector<Ramp> ramps;  ///< ascending by slope
  double upwardArea = 0;    ///< of all triangles that face up
  int bits = 0;             ///< of the largest coordinate, in units of the last digit of all coordinates
  NearPlaces nearPlaces;
};

/// Measures an environment, rounded, in time proportional to its triangles.
LevelMeasures measureLevel(const Environment& environment, const Poll& poll = {});

/// The one change that does what a note advises.
struct ParameterMend {
  std::optional<std::size_t> value;  ///< place among the step's values; empty: the metres of the level's unit
  double to = 0;
};

struct ParameterNote {
  std::optional<std::size_t> step;    ///< step of the pipeline, from 0; empty: the note is about what import does
  Text text;                          ///< the problem and the advice
  std::optional<ParameterMend> mend;  ///< empty where the advice is no single number
  bool isOnGrid = false;              ///< without a step: the note is about the grid of coordinates, not the scale
};

/// The notes on a pipeline's enabled steps:
/// - a step that is a rounding, or at most a twentieth, below the most frequent riser: the most frequent height of
///   walls among those of at most half of the clearance. Risers of exactly the step are climbed, and nothing is said;
/// - agents that are taller than the level is in any direction, or than each of its doorways;
/// - much ground that is steeper than the maximum slope and its tolerance by less than a twentieth of a degree: a
///   hundredth of all that faces up;
/// - a level whose longest side is less than ten times the agents' height, unless findScale() finds that its steps,
///   doorways or storeys are of the size of people, or more than 20 km, with a scale by which it would not be;
/// - a radius that no doorway under which the agents fit is wide enough for, or not even the level;
/// - coordinates with so many bits that exact arithmetic is many times slower;
/// - and a guessed scale that makes the level larger than levels are, or smaller.
std::vector<ParameterNote> checkParameters(const LevelMeasures& level, const Pipeline& pipeline);

}  // namespace footfall::detail
