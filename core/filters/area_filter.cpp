// AreaFilter: removes regions whose surface area is at most a minimum (model, Area, thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of a region is a sum of (area in the plan) * |normal| / normal_z over its faces: rational numbers and square
// roots. Doubles with error bounds decide nearly always; else the rational parts are summed exactly face by face and
// the roots enclosed by intervals of growing precision (compareRootSum()). Areas that agree with the minimum to the
// finest one count as equal, and are removed.

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/assembly/dropped_parts.hpp"
#include "core/assembly/mesh_assembly.hpp"
#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/base/vector.hpp"
#include "core/environment/area_on_grid.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/root_sum.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

ErrorDouble twicePlanArea(const WalkableMesh& mesh, const MeshTriangle& t) {
  std::array<ErrorDouble, 3> x, y;
  for (int k = 0; k < 3; ++k) {
    const MeshVertex& v = mesh.vertices[t.corners[k]];
    x[k] = {v.x, v.error};
    y[k] = {v.y, v.error};
  }
  return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
}

ErrorDouble twiceArea(const PlanKernel& kernel, const WalkableMesh& mesh, const MeshTriangle& t) {
  const auto& n = kernel.mesh().normals[t.face];
  return twicePlanArea(mesh, t) * squareRoot(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / n[2];
}

// Marks regions whose area in the plan alone, which is at most their surface area, proves them larger than the limit
// (twice the minimum, scaled). Nearly all of a level's triangles are in such regions, and a few triangles of each
// suffice.
std::vector<char> findLargeRegions(const PlanKernel& kernel, const WalkableMesh& mesh, const std::vector<Index>& region,
                                   Index regionCount, double limit) {
  std::vector<char> large(regionCount, 0);
  std::vector<ErrorDouble> sum(regionCount);
  for (std::size_t t = 0; t < region.size(); ++t) {
    const Index r = region[t];
    if (large[r] != 0) continue;
    sum[r] = sum[r] + twicePlanArea(mesh, mesh.triangles[t]);
    large[r] = static_cast<char>(kernel.sign()(sum[r] - ErrorDouble(limit)) == 1);
  }
  return large;
}

// Sign of (area of the triangles) - minimum, decided or equal to the finest precision.
int compareExactly(const PlanKernel& kernel, const WalkableMesh& mesh, std::span<const Index> triangles,
                   double minimum) {
  std::map<Index, mpq_class> planOfFace;  // twice the area in the plan
  for (const Index i : triangles) {
    const MeshTriangle& t = mesh.triangles[i];
    std::array<std::array<mpq_class, 3>, 3> p;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex& v = mesh.vertices[t.corners[k]];
      p[k] = kernel.exactPosition(v.point, v.face);
    }
    planOfFace[t.face] += (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
  }
  // each term is sqrt(rational): (plan |n| / nz)^2 is rational
  std::vector<mpq_class> squares;
  for (const auto& [face, plan] : planOfFace) {
    const auto& f = kernel.mesh().triangles[face];
    std::array<std::array<mpq_class, 3>, 3> v;
    for (int k = 0; k < 3; ++k) {
      const Vec3& p = kernel.mesh().vertices[f[k]];
      v[k] = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
    }
    const auto [nx, ny, nz] = cross(v[1] - v[0], v[2] - v[0]);
    squares.emplace_back(plan * plan * (nx * nx + ny * ny + nz * nz) / (nz * nz));
  }
  return compareRootSum(squares, mpq_class(minimum) * 2);
}

}  // namespace

FilterOutcome applyArea(const StatePtr& given, double asked, const Recall& recall, RunContext& context) {
  FilterOutcome outcome;
  const StatePtr state = withMesh(given, context, outcome.fallbacks);
  const double minimum = areaOnGrid(state->environment->grid, asked);
  const PlanKernel& kernel = *state->kernel;
  const WalkableMesh& mesh = *state->mesh;
  const Poll poll(context);
  const auto topology = topologyOf(*state, poll);
  Index regionCount = 0;
  const std::vector<Index> region = findRegions(mesh, *topology, regionCount);
  context.checkCancelled();

  const int scale = kernel.mesh().grid.scaleExponent();
  const double limit = std::ldexp(minimum, 2 * scale + 1);
  std::vector<char> keep = findLargeRegions(kernel, mesh, region, regionCount, limit);
  context.checkCancelled();
  // The other regions are small, or about as large as the minimum.
  std::vector<Index> firstOf(regionCount + 1, 0);
  for (const Index r : region) firstOf[r + 1] += static_cast<Index>(keep[r] == 0);
  for (Index r = 0; r < regionCount; ++r) firstOf[r + 1] += firstOf[r];
  std::vector<Index> members(firstOf.back()), next(firstOf.begin(), firstOf.end() - 1);
  for (std::size_t t = 0; t < region.size(); ++t)
    if (keep[region[t]] == 0) members[next[region[t]]++] = static_cast<Index>(t);
  std::vector<char> decidedExactly(regionCount, 0);
  parallelRanges(regionCount, 256, [&](const auto& range) {
    context.checkCancelled();
    for (Index r = range.begin(); r != range.end(); ++r) {
      if (keep[r] != 0) continue;
      const std::span<const Index> triangles(members.data() + firstOf[r], members.data() + firstOf[r + 1]);
      ErrorDouble area;
      for (const Index t : triangles) area = area + twiceArea(kernel, mesh, mesh.triangles[t]);
      int sign = kernel.sign()(area - ErrorDouble(limit)).value_or(0);
      if (sign == 0) {
        context.checkCancelled();
        decidedExactly[r] = 1;
        sign = compareExactly(kernel, mesh, triangles, minimum);
      }
      keep[r] = static_cast<char>(sign > 0);
    }
  });
  outcome.fallbacks.area += static_cast<std::uint64_t>(std::count(decidedExactly.begin(), decidedExactly.end(), 1));

  const auto removed = std::count(keep.begin(), keep.end(), 0);
  if (removed == 0) {
    auto known = std::make_shared<WalkableState>(*state);
    known->topology = topology;
    known->topologyOwner = state->mesh;
    outcome.state = std::move(known);
    return outcome;
  }
  outcome.state = withRegions(
      *state, {*topology, region, keep, recall.isLast || state != given},
      [&](const StatePtr& other) { return applyArea(other, asked, {}, context).state; }, context, outcome.fallbacks);
  outcome.note = regionsRemoved(removed, regionCount);
  return outcome;
}

}  // namespace footfall::detail
