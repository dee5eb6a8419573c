// Measures what Footfall itself needs for an environment, from the file to the export.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "footfall/navigation_mesh.hpp"
#include "footfall/pipeline.hpp"
#include "tests/bench/sampling.hpp"
#include "tests/bench/subject.hpp"

namespace footfall::bench {

/// The default pipeline with exactly the subject's clearance.
Pipeline pipelineFor(const Subject& subject, const Environment& environment);

/// The subject's pipeline without its StepFilter: it is measured beside peers, none of which has such links, and beside
/// earlier tables.
Pipeline pipelineWithoutSteps(const Subject& subject, const Environment& environment);

/// The area of the navigation mesh, seen from above, in the square of the environment's unit.
double planArea(const NavigationMesh& mesh);

/// Measures load, tree, each step of the pipeline, navigation mesh and export. To be run isolated, as the peak of the
/// memory is the process's own: that of the warm-up, which is the first run of the process. Milliseconds are medians.
Json measurePipeline(const Subject& subject, int threads, const Repetition& repetition);

}  // namespace footfall::bench
