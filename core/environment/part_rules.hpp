// The user's rules for the parts of an environment: left out, or obstacles that are never walkable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// The role of one part, named exactly as the file names it; an empty name stands for a part without that name.
struct PartRule {
  std::string mesh, material;
  PartRole role = PartRole::Floor;
  bool operator==(const PartRule&) const = default;
};

/// The role of each of Environment::parts: that of the last rule that names it, else its usual one. Rules for parts
/// that are not there have no effect, so that they can outlive a version of the file. An environment without parts has
/// one all the same, without names: the list then has one entry.
std::vector<PartRole> rolesOf(const Environment& environment, const std::vector<PartRule>& rules);

/// `base` without the triangles of ignored parts and with Environment::obstacleOnly set for the others, as an edit of
/// `base`: a run with the results of `base` at hand computes only what the rules can affect. `base` itself when the
/// rules change nothing. Nothing may be left: the result then has no triangles.
std::shared_ptr<const Environment> applyPartRules(const std::shared_ptr<const Environment>& base,
                                                  const std::vector<PartRule>& rules);

/// The role of a part when no rule names it.
PartRole usualRole(const Environment& environment, std::uint32_t part);

/// Rules that give `role` to the parts that `name` means: a mesh, a material, or MESH/MATERIAL. Throws InputError, with
/// the names that there are, when it means none; `option` begins the message.
std::vector<PartRule> rulesForName(const Environment& environment, const std::string& name, PartRole role,
                                   const std::string& option);

}  // namespace footfall::detail
