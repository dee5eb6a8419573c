// What Footfall itself needs for an environment, from the file to the export.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/environment/environment.hpp"
#include "core/environment/navigation_mesh.hpp"
#include "core/pipeline/pipeline.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {

/// A file to measure, and the free height that its agents need, in its units. That height stands for 2 m.
struct Subject {
  std::string name;
  std::string path;
  double clearance = 2;
  [[nodiscard]] double metresPerUnit() const { return 2 / clearance; }
};

/// Reads the subject's file with the scale that its clearance implies.
std::shared_ptr<const Environment> loadSubject(const Subject& subject);

/// The default pipeline with exactly the subject's clearance.
Pipeline pipelineFor(const Subject& subject, const Environment& environment);

/// Of the navigation mesh, seen from above, in the square of the environment's unit.
double planArea(const NavigationMesh& mesh);

/// Measures load, tree, each step of the pipeline, navigation mesh and export. To be run isolated, as the peak of the
/// memory is the process's own: that of the warm-up, which is the first run of the process. Milliseconds are medians.
Json measurePipeline(const Subject& subject, int threads, const Repetition& repetition);

}  // namespace footfall::bench
