// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lifted_vertex.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::detail {
namespace {

// Values with a larger relative error are computed exactly, as in PlanKernel.
constexpr double kCoarse = 0x1p-26;

}  // namespace

MeshVertex liftedVertex(const PlanKernel& kernel, Index face, const PlanPoint& point,
                        const ApproximatePoint& approximate) {
  const SourceMesh& mesh = kernel.mesh();
  const Vec3& origin = mesh.scaled[mesh.triangles[face][0]];
  const auto& n = mesh.normals[face];
  const ErrorDouble x(approximate.x, approximate.error), y(approximate.y, approximate.error);
  const ErrorDouble gx = x + ErrorDouble(origin.x), gy = y + ErrorDouble(origin.y);
  const bool isLevel =
      kernel.sign().zeroValid && n[0].value == 0 && n[0].error == 0 && n[1].value == 0 && n[1].error == 0;
  const ErrorDouble gz = isLevel ? ErrorDouble(origin.z) : ErrorDouble(origin.z) - (n[0] * x + n[1] * y) / n[2];
  MeshVertex vertex{point, face, -1, gx.value, gy.value, gz.value, 0};
  vertex.error = std::max({gx.error, gy.error, gz.error});
  const auto size = [&] { return std::max({std::fabs(vertex.x), std::fabs(vertex.y), std::fabs(vertex.z)}); };
  if (!(vertex.error < kCoarse * (size() + 1))) {
    // Doubles may hold next to nothing of a sliver's normal. The bound is half a unit in the last place, doubled, and
    // what subnormal numbers lose.
    const int scale = mesh.grid.scaleExponent();
    const Vec3 place = kernel.roundedPosition(point, face);
    vertex.x = std::ldexp(place.x, scale), vertex.y = std::ldexp(place.y, scale), vertex.z = std::ldexp(place.z, scale);
    vertex.error = size() * 0x1p-52 + std::ldexp(1.0, scale - 1074);
  }
  vertex.error += kernel.sign().slack;
  return vertex;
}

MeshVertex liftedVertex(const PlanKernel& kernel, Index face, const PlanPoint& point) {
  const Index origin = kernel.mesh().triangles[face][0];
  const auto quick = kernel.approximateQuickly(point, origin);
  return liftedVertex(kernel, face, point,
                      quick ? *quick : kernel.approximate(kernel.homogeneous(point, origin), point, origin));
}

}  // namespace footfall::detail
