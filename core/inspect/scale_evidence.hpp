// Estimates the unit of a level from its shapes: steps, doorways and storeys have the size of people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/inspect/parameter_check.hpp"

namespace footfall::detail {

struct ScaleEvidence {
  enum class Of { Risers, Doorways, Storeys };
  double metresPerUnit = 1;
  Of of = Of::Storeys;
  double length = 0;  ///< the most frequent one, in the level's units
};

/// The usual unit by which the most frequent heights of walls, and the doorways, are those of buildings: metres,
/// centimetres, millimetres, inches, feet, Quake's units (32 and 39.37 a metre), and 20, 16 and 10 units a metre. The
/// level's own scale is taken where it explains about as much. Nothing where no scale explains at least a quarter of
/// the walls, or where the level would be lower than a person.
std::optional<ScaleEvidence> findScale(const LevelMeasures& level);

}  // namespace footfall::detail
