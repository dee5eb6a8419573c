// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "footfall/environment.hpp"
#include "footfall/errors.hpp"

namespace footfall {
namespace {

void checkLength(std::size_t length, std::size_t triangles, const Text& name) {
  if (length != 0 && length != triangles)
    throw InputError(
        FOOTFALL_TEXT(
            "the length of %1 is %2, and the number of triangles is %3; give one entry for each triangle, or none"),
        name, length, triangles);
}

}  // namespace

void checkEnvironment(const Environment& environment) {
  const std::size_t triangles = environment.triangles.size(), vertices = environment.vertices.size();
  if (triangles == 0) throw InputError(FOOTFALL_TEXT("the environment has no triangles"));
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vec3& p = environment.vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError(FOOTFALL_TEXT("vertex %1 has a coordinate that is not finite; vertices count from 0"), v);
  }
  for (std::size_t t = 0; t < triangles; ++t)
    for (const std::uint32_t v : environment.triangles[t])
      if (v >= vertices)
        throw InputError(FOOTFALL_TEXT("triangle %1 names vertex %2 of %3; both count from 0"), t, v, vertices);
  if (!(std::isfinite(environment.metresPerUnit) && environment.metresPerUnit > 0))
    throw InputError(FOOTFALL_TEXT("metresPerUnit must be a positive number of metres"));
  checkLength(environment.partOf.size(), triangles, "partOf");
  checkLength(environment.obstacleOnly.size(), triangles, "obstacleOnly");
  if (!environment.usualRoles.empty() && environment.usualRoles.size() != environment.parts.size())
    throw InputError(
        FOOTFALL_TEXT(
            "the length of usualRoles is %1, and the number of parts is %2; give one entry for each part, or none"),
        environment.usualRoles.size(), environment.parts.size());
  for (const std::uint32_t part : environment.partOf)
    if (part >= environment.parts.size())
      throw InputError(FOOTFALL_TEXT("partOf names part %1 of %2; parts count from 0"), part, environment.parts.size());
}

}  // namespace footfall
