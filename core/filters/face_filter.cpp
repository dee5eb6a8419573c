// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/face_filter.hpp"

#include <algorithm>

#include "core/exact/source_predicates.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {

FaceTest makeFaceTest(const FilterDescriptor& filter, const std::vector<double>& values,
                      const std::shared_ptr<const PlanKernel>& kernel) {
  if (filter.type == FilterType::Degeneracy)
    return [kernel](Index face, ExactFallbacks&) { return kernel->mesh().degenerate[face] == 0; };
  if (filter.type != FilterType::Slope) return {};
  const double steepest = slopeLimit(values[0], values[1]);
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

FloorFlags::FloorFlags(const std::vector<char>& walkable, const std::vector<FaceTest>& tests)
    : tests_(tests), flags_(walkable) {
  if (tests.empty()) return;
  std::replace_if(
      flags_.begin(), flags_.end(), [](char flag) { return flag != 0; }, kUnknown);
}

bool FloorFlags::passesAll(Index face) {
  return std::all_of(tests_.begin(), tests_.end(), [&](const FaceTest& test) { return test(face, fallbacks); });
}

}  // namespace footfall::detail
