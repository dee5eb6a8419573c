// What the user says about the parts of an environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/environment/environment.hpp"

namespace footfall {

enum class PartRole {
  Floor,         ///< as usual: walkable where the filters leave it
  ObstacleOnly,  ///< never walkable, but an obstacle
  Ignored,       ///< not there at all
};

/// Of the part with these names; parts without a rule are floors. Names last over reading a file again, numbers need
/// not.
struct PartRule {
  std::string mesh, material;
  PartRole role = PartRole::Floor;
  bool operator==(const PartRule&) const = default;
};

}  // namespace footfall
