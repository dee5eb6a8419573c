// An agent's sizes, which set the values of filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace footfall::ui {

/// An agent with a name, in the units of the level that it is edited for (footfall/agent.hpp has those of the library,
/// in metres).
struct NamedAgent {
  int id = 0;  ///< unique in its document, above 0
  std::string name;
  double height = 0;    ///< free height that it needs, in the environment's units
  double maxSlope = 0;  ///< steepest slope that it walks on, in degrees
  double step = 0;      ///< highest step that it climbs, in the environment's units; 0: it climbs no steps
  double gap = 0;       ///< widest gap that it steps over, in the environment's units
  double radius = 0;    ///< distance that it keeps from walls and ledges, in the environment's units; 0: it is a point
  double drop = 0;      ///< deepest drop from a ledge, in the environment's units; 0: it does not drop
  bool operator==(const NamedAgent&) const = default;
};

}  // namespace footfall::ui
