// SlopeFilter: rejects triangles that are steeper than the limit, exactly (model, Slope).
// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "core/exact/source_predicates.hpp"
#include "core/filters/face_filter.hpp"
#include "core/filters/filter_registry.hpp"

namespace footfall::detail {
namespace {

constexpr double kNear =
    0.05;  // degrees that roundings can make of a slope; core/inspect/parameter_check.cpp has it, too

double areaOf(const SourceMesh& mesh, std::size_t face) {
  const auto& f = mesh.triangles[face];
  const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  return std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

/// The floors that the filter has removed and that lie just beyond its limit, in degrees; empty where there are none.
Text nearlyWithin(const WalkableState& before, const WalkableState& after, double limit) {
  const FaceTest isNear = makeSlopeTest(limit, kNear, before.kernel);
  ExactFallbacks ignored;
  double area = 0;
  for (std::size_t t = 0; t < after.walkable.size(); ++t)
    if (before.walkable[t] != 0 && after.walkable[t] == 0 && isNear(static_cast<Index>(t), ignored))
      area += areaOf(before.kernel->mesh(), t);
  if (area == 0) return {};
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), area, std::chars_format::general, 4);
  return {FOOTFALL_TEXT("an area of %1 is steeper than the limit by less than 0.05 degrees"),
          std::string(digits.data(), end.ptr)};
}

}  // namespace

FaceTest makeSlopeTest(double degrees, double tolerance, const std::shared_ptr<const PlanKernel>& kernel) {
  const double steepest = slopeLimit(degrees, tolerance);
  return [kernel, limit = SlopeLimit(steepest), degrees = steepest](Index face, ExactFallbacks& count) {
    const SourceMesh& mesh = kernel->mesh();
    if (const MaybeSign sign = limit.compare(mesh.normals[face], kernel->sign())) return *sign > 0;
    const auto& f = mesh.triangles[face];
    bool beyondDoubles = false;
    const bool within =
        isWithinSlope(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]], degrees, &beyondDoubles);
    if (beyondDoubles) ++count.slope;
    return within;
  };
}

FilterOutcome applySlope(const StatePtr& state, double degrees, double tolerance, RunContext& context) {
  const FaceTest isWithin = makeSlopeTest(degrees, tolerance, state->kernel);
  FilterOutcome outcome = keepFaces(state, isWithin, context);
  outcome.note = nearlyWithin(*state, *outcome.state, slopeLimit(degrees, tolerance));
  return outcome;
}

}  // namespace footfall::detail
