// The numbers and lines that `footfall info` prints about an environment.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::detail {

struct EnvironmentInfo {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  Vec3 lower, upper;             ///< bounds, Z up
  std::uint64_t degenerate = 0;  ///< triangles of zero area, exactly
  std::uint64_t duplicate = 0;   ///< triangles with the same three positions as an earlier one, in any order
  std::uint64_t walkable45 = 0;  ///< triangles that SlopeFilter 45 0 keeps, exactly
  std::vector<std::uint64_t> partTriangles;  ///< for each of Environment::parts
  std::uint64_t openEdges = 0;               ///< edges (by position) with one triangle
  std::uint64_t nonManifoldEdges = 0;        ///< edges (by position) with more than two triangles
  int bits = 0;  ///< from the highest digit of the largest coordinate to the last digit of any
};

/// The grid of the coordinates, in one line: its step, its bits, and what it moved; or "none", the bits of the
/// coordinates, and a hint where a grid would make runs faster. `bits`: EnvironmentInfo::bits.
std::string gridText(const Environment& environment, int bits);

EnvironmentInfo inspectEnvironment(const Environment& environment);

/// The lines that `footfall info` prints.
std::string formatInfo(const Environment& environment, const EnvironmentInfo& info);

}  // namespace footfall::detail
