// The whole benchmark: every environment, measured and beside its peers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/path_measurement.hpp"
#include "tests/bench/pipeline_measurement.hpp"

namespace footfall::bench {

struct BenchmarkOptions {
  std::vector<Subject> given;  ///< files from outside
  std::vector<Subject> samples;
  bool growth = false;
  int cancelMoments = 0;               ///< moments for each file, and with `growth` for the largest generated
                                       ///< environments
  bool live = false;                   ///< edits of each environment too, and of a generated terrain
  int crateEdits = 0;                  ///< measure so many moves of a crate at each of some places, and nothing else
  std::vector<std::uint32_t> exports;  ///< triangles of meshes that are written in each format
  bool reach = false;                  ///< measure who can reach whom, and nothing else
  double step = 0.4;                   ///< used with `reach`: metres that agents climb at once
  PathPairs paths;                     ///< with pairs: measure paths for a radius, and nothing else; `step` is above
  bool scenes = false;                 ///< measure scenes and turned levels, and nothing else: `given` are the scenes
  std::uint32_t sceneTriangles = 60'000;  ///< of each generated scene
  std::vector<Subject> turned;            ///< levels that are turned, with `samples`
  std::vector<int> threads{1, 2};         ///< ascending; the last is what the report compares with the peers
  Repetition repetition;
  bool recast = true;                                                 ///< used if the program was built with it
  bool embree = true;                                                 ///< used if the program was built with it
  std::string prototype;                                              ///< the program, or empty
  Limits limits{std::chrono::seconds(300), std::uint64_t{4} << 30U};  ///< limits of one measurement
};

/// Measures everything, with progress on standard error. The result has
/// - `program`: `version`, `recast`, `embree` (built with it and asked for);
/// - `threads`, `runs`;
/// - `environments`: a list; each with `name`, `group` ("given" or "sample"), `clearance`, `metres_per_unit`,
///   `footfall` (a list, one entry a thread count, of measurePipeline()), `floor` (the same of measureFloor()),
///   `recast` (one entry a cell size, of measureRecast(), with `cell`, `cell_height` and `area_percent`: how far its
///   area in the plan is from ours), `prototype` (one entry a thread count, of measurePrototype(), with `ours_ms`: from
///   the same file to the walkable environment), `thesis_s` (an environment of the same size in the thesis);
/// - `growth`: a list of `series`, `size` and what measurePipeline() says with most threads;
/// - `cancelling`: a list of `name` and what measureCancelling() says with most threads;
/// - `live`: a list of `name` and what measureLive() says with most threads;
/// - `exports`: a list of what measureExports() says, one entry for each of BenchmarkOptions::exports;
/// - `reach`: with BenchmarkOptions::reach, when all others are empty: a list of `name`, `group`, what measureReach()
///   says with most threads, and `recast` (of compareReach());
/// - `paths`: with pairs in BenchmarkOptions::paths, when all others are empty: a list of `name`, `group` and what
///   measurePaths() says;
/// - `crates`: with BenchmarkOptions::crateEdits, when all others are empty: a list of `name`, `group` and what
///   measureCrate() says with most threads, without and with a radius of 0.3 m;
/// - `scenes`, `turned`: with BenchmarkOptions::scenes, when all others are empty: what measureScenes() says.
/// Whatever cannot be measured has `fails` with the reason in the place of its figures.
Json runBenchmark(const BenchmarkOptions& options);

}  // namespace footfall::bench
