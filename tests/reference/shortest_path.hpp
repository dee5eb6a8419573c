// Shortest paths the slow and obvious way, to compare with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "footfall/path.hpp"

namespace footfall::reference {
using namespace detail;

/// The length in the plan of the shortest path from a place to another, found by looking at every sequence of
/// triangles that leads there without repetition; infinite when there is none. Nothing when there are more sequences
/// than `most`.
std::optional<double> shortestOfAllSequences(const NavigationMesh& mesh, const SurfacePlace& from,
                                             const SurfacePlace& to, std::size_t most = 20000);

/// The length of a path over `points` extra points on every side: no shorter than the shortest. Infinite when there is
/// none.
double lengthOverSidePoints(const NavigationMesh& mesh, const SurfacePlace& from, const SurfacePlace& to, int points);

/// The first error of a path: pieces that leave their triangle by more than `tolerance`, neighbours that do not hang
/// together where the path crosses, steps where no link is, figures that do not fit. Empty when it has none.
std::string findPathError(const NavigationMesh& mesh, const PathResult& path, double tolerance);

}  // namespace footfall::reference
