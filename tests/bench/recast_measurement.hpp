// The peer that voxelises: Recast's solo build on the same triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "footfall/environment.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {

/// A cell size in metres.
struct RecastCell {
  double size = 0.3;
  double height = 0.2;
};

/// The build of Recast's own demo ("solo mesh") from rcCreateHeightfield up to and with rcBuildPolyMeshDetail, with its
/// default region sizes and tolerances, but for agents 2 m high of the given radius (metres) who climb 0.9 m and 45
/// degrees. Everything is scaled by `metresPerUnit`. Turning the triangles into Recast's floats is not counted. Gives
/// `wall_ms`, `cpu_ms`, `least_cpu_ms`, `peak_bytes` (of the first build, above what the process held before),
/// `plan_area` (of the polygons, in the square of the environment's unit) and `runs`; throws std::runtime_error with
/// the reason when Recast cannot do it. To be run isolated, with a limit of memory.
Json measureRecast(const Environment& environment, double metresPerUnit, const RecastCell& cell,
                   const Repetition& repetition, double radius = 0);

/// The places that Recast found walkable, as a sample of its area: the middle of the top of each open span that one can
/// stand on, in the environment's units with Z up, and the part to which its connections assign it.
struct RecastPlaces {
  std::vector<Vec3> places;
  std::vector<std::uint32_t> parts;  ///< part of each place, numbered from 0
  std::uint32_t partCount = 0;
};

/// The same agents, filters and scale, but for a climb of `climb` metres: up to the compact heightfield, whose
/// connections between neighbouring cells regions and polygons only simplify. Throws as measureRecast().
RecastPlaces findRecastPlaces(const Environment& environment, double metresPerUnit, const RecastCell& cell,
                              double climb);

}  // namespace footfall::bench
