// The peer that voxelises: Recast's solo build on the same triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/environment.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {

/// In metres.
struct RecastCell {
  double size = 0.3;
  double height = 0.2;
};

/// The build of Recast's own demo ("solo mesh") from rcCreateHeightfield up to and with rcBuildPolyMeshDetail, with its
/// default region sizes and tolerances, but for agents 2 m high of radius 0 who climb 0.9 m and 45 degrees. Everything
/// is scaled by `metresPerUnit`. Turning the triangles into Recast's floats is not counted. Gives `wall_ms`, `cpu_ms`,
/// `peak_bytes` (of the first build, above what the process held before), `plan_area` (of the polygons, in the square
/// of the environment's unit) and `runs`; throws std::runtime_error with the reason when Recast cannot do it. To be
/// run isolated, with a limit of memory.
Json measureRecast(const Environment& environment, double metresPerUnit, const RecastCell& cell,
                   const Repetition& repetition);

}  // namespace footfall::bench
