// One run of the thesis's parallel pipeline with cut obstacles and rounded cuts, timed by its phases.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/pipeline.hpp"
#include "tests/bench/rounding_experiment/cut_repair.hpp"

namespace footfall::bench {

/// The phases of thesis 5.4, in milliseconds.
struct ExperimentTimes {
  double preprocessing = 0, partitioning = 0, parallel = 0, merging = 0, postprocessing = 0;
  double total = 0;
  double cpu = 0;  ///< processor time of all threads, over the same span as `total`
};

struct ExperimentResult {
  std::shared_ptr<const NavigationMesh> mesh;
  ExperimentTimes times;
  std::uint64_t cells = 0;
  std::uint64_t triangles = 0;     ///< before the cuts
  std::uint64_t cutTriangles = 0;  ///< after the cuts and repairs
  std::uint64_t cutVertices = 0;   ///< points that the cuts made
};

/// Runs a pipeline with one parallel block: the filters before it, the cuts through all triangles (walkable and
/// rejected), rounding and, with `repair`, the repairs; the block's filters on every cell as an environment of its own;
/// the filters behind it on what the cells left. Throws InputError where the pipeline has no block.
ExperimentResult runExperiment(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                               bool repair, int threads);

/// The cases that rounding the cuts of that run meets. Not timed.
CutCases countExperimentCases(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                              int threads);

}  // namespace footfall::bench
