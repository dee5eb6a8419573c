// Who is to walk: the sizes that drive the filters.
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
  double maxSlope = 0;  ///< degrees
  double step = 0;      ///< how high it climbs at once, in the environment's units; 0: it does not lift its feet
  double radius = 0;    ///< how far it stays away from walls and ledges, in the environment's units; 0: it is a point
  bool operator==(const NamedAgent&) const = default;
};

}  // namespace footfall::ui
