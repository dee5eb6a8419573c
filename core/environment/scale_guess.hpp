// Judges whether a guessed scale can be right.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// `size` is a level's in its units, its height last. Nothing where levels of games and buildings are of the size that
/// it has by `metresPerUnit`; else the nearest usual scale (a metre, a centimetre, a millimetre) by which it would be,
/// or nothing where none is. No scale
/// is proposed by which the level would be lower than a person.
std::optional<double> betterScale(const Vec3& size, double metresPerUnit);

/// True when a level of this size is too high, rather than too long or too short, by that scale.
bool isTooHigh(const Vec3& size, double metresPerUnit);

}  // namespace footfall::detail
