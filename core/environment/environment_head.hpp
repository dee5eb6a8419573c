// The statements of an environment about itself and its file, apart from its geometry.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/environment.hpp"

namespace footfall::detail {

/// Copies everything that does not count vertices or triangles, and no edit.
inline void copyHead(const Environment& from, Environment& to) {
  to.source = from.source;
  to.origin = from.origin;
  to.up = from.up;
  to.upGuessed = from.upGuessed;
  to.metresPerUnit = from.metresPerUnit;
  to.scaleGuessed = from.scaleGuessed;
  to.bothSides = from.bothSides;
  to.skipped = from.skipped;
  to.parts = from.parts;
  to.usualRoles = from.usualRoles;
  to.storeys = from.storeys;
  to.notes = from.notes;
  to.grid = from.grid;
}

}  // namespace footfall::detail
