// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/part_rules.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "core/environment/part_names.hpp"
#include "footfall/edit.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

std::vector<EnvironmentPart> partsOf(const Environment& environment) {
  return environment.parts.empty() ? std::vector<EnvironmentPart>(1) : environment.parts;
}

/// Meshes and materials, each once, quoted.
Text listNames(const Environment& environment) {
  constexpr std::size_t kMost = 40;  // a message must stay readable
  std::vector<std::string_view> names;
  std::set<std::string_view> known;
  const std::vector<EnvironmentPart> parts = partsOf(environment);
  for (const EnvironmentPart& part : parts)
    for (const std::string_view name : {std::string_view(part.mesh), std::string_view(part.material)})
      if (!name.empty() && known.insert(name).second) names.push_back(name);
  if (names.empty()) return FOOTFALL_TEXT("the file names no meshes or materials");
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text.append(i == 0 ? "\"" : ", \"").append(names[i]).append("\"");
  if (names.size() <= kMost) return {FOOTFALL_TEXT("it has %1"), text};
  return {FOOTFALL_TEXT("it has %1 and %2 more; `footfall info` lists all"), text, names.size() - kMost};
}

}  // namespace

std::vector<PartRole> rolesOf(const Environment& environment, const std::vector<PartRule>& rules) {
  const std::vector<EnvironmentPart> parts = partsOf(environment);
  std::vector<PartRole> roles = environment.usualRoles;
  roles.resize(parts.size(), PartRole::Floor);
  if (rules.empty()) return roles;
  std::map<std::pair<std::string_view, std::string_view>, PartRole> named;
  for (const PartRule& rule : rules) named[{rule.mesh, rule.material}] = rule.role;
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (const auto rule = named.find({parts[p].mesh, parts[p].material}); rule != named.end()) roles[p] = rule->second;
  return roles;
}

PartRole usualRole(const Environment& environment, std::uint32_t part) {
  return part < environment.usualRoles.size() ? environment.usualRoles[part] : PartRole::Floor;
}

std::shared_ptr<const Environment> applyPartRules(const std::shared_ptr<const Environment>& base,
                                                  const std::vector<PartRule>& rules) {
  const std::vector<PartRole> roles = rolesOf(*base, rules);
  if (std::all_of(roles.begin(), roles.end(), [](PartRole role) { return role == PartRole::Floor; })) return base;
  const auto roleOf = [&](std::size_t t) { return roles[base->partOf.empty() ? 0 : base->partOf[t]]; };
  std::vector<std::uint32_t> ignored;
  bool anyObstacle = false;
  for (std::size_t t = 0; t < base->triangles.size(); ++t) {
    const PartRole role = roleOf(t);
    if (role == PartRole::Ignored) ignored.push_back(static_cast<std::uint32_t>(t));
    anyObstacle = anyObstacle || role == PartRole::ObstacleOnly;
  }
  if (ignored.empty() && !anyObstacle) return base;
  const auto result = editedCopy(base, ignored);
  if (!anyObstacle) return result;
  const std::vector<std::uint32_t>& kept = result->edit->keptTriangles;
  result->obstacleOnly.resize(kept.size(), 0);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (roleOf(kept[i]) == PartRole::ObstacleOnly) result->obstacleOnly[i] = 1;
  return result;
}

std::vector<PartRule> rulesForName(const Environment& environment, const std::string& name, PartRole role,
                                   const std::string& option) {
  std::vector<PartRule> rules;
  for (const EnvironmentPart& part : partsOf(environment))
    if (!name.empty() && (name == part.mesh || name == part.material || name == part.mesh + '/' + part.material))
      rules.push_back({part.mesh, part.material, role});
  if (rules.empty())
    throw InputError(FOOTFALL_TEXT("%1 \"%2\": %3 has no mesh or material of that name; %4"), option, name,
                     environment.source, listNames(environment));
  return rules;
}

}  // namespace footfall::detail
