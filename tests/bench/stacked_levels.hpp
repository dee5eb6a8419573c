// Environments with many floors above each other: the same bytes on every machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::bench {

struct StackedLevel {
  std::string name;
  std::shared_ptr<const Environment> environment;
};

/// Decks with obstacles, tower blocks with stairs, uneven sheets, roads that cross, fans, and spirals; 10,000 to 70,000
/// triangles each, one metre a unit.
std::vector<StackedLevel> makeStackedLevels();

}  // namespace footfall::bench
