// The pipelines of the thesis's experiments (5.4), for our environments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "tests/bench/subject.hpp"

namespace footfall::bench {

/// An environment of the experiments.
struct ThesisSubject {
  Subject subject;
  std::string pipelineFile;  ///< the sample's; empty: the default pipeline with the subject's clearance
  [[nodiscard]] bool isSample() const { return !pipelineFile.empty(); }
};

/// The samples of the repository.
std::vector<ThesisSubject> samplesWithPipelines();

/// The filters that run, their order and their parameters.
enum class FilterList {
  Own,                ///< the sample's pipeline file, or the default pipeline
  ThesisSequential,   ///< the sequential listing of 5.4 with slope, clearance and area of Own, distances in metres
  ThesisParallel,     ///< the parallel listing of 5.4, the same way: it rounds, and simplifies approximately
  PrintedSequential,  ///< the sequential listing with the numbers that are printed there, in the file's units
  PrintedParallel     ///< the parallel listing as it is printed, with its own strategy
};

/// A step such as "GridStrategy 3 3". Throws InputError where it is none or no strategy.
PipelineStep parseStrategy(const std::string& text);

/// "Grid 3 x 3", "Sorted recursive, depth 4", "Auto": for tables.
std::string describeStrategy(const std::string& text);

/// The filters; with a strategy, VerticalClearanceFilter stands in a parallel block (in ThesisParallel, which must have
/// one, what the thesis has there). An empty `strategy` is none.
Pipeline makeThesisPipeline(const ThesisSubject& subject, const Environment& environment, FilterList filters,
                            const std::string& strategy);

}  // namespace footfall::bench
