// Measures each part of an edit under the default pipeline, steps and layers included.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/pipeline_measurement.hpp"

namespace footfall::bench {

/// A crate of 12 triangles, 0.8 m wide and 1 m high, moves to and fro by half a metre at some places of the walkable
/// area, `edits` times at each. `radius` in metres: that of a RadiusFilter behind the StepFilter; 0: none.
/// Gives `triangles`, and means over the places of the least processor milliseconds there: `edit_ms` (the edited
/// environment), `start_ms`, `steps` (a list of `name` and `ms`), `navigation_mesh_ms`, `whole_ms` (all of those),
/// `path_finder_ms` (a PathFinder made of the result). To be run isolated.
Json measureCrate(const Subject& subject, double radius, int threads, int edits);

/// The table of `crates` in the results of runBenchmark().
std::string formatCrates(const Json& results);

}  // namespace footfall::bench
