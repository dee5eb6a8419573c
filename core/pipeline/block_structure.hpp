// Checks which steps may follow each other: a parallel block runs from a strategy to Collapse
// (docs/explanation/model.md, Parallel blocks).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "footfall/pipeline.hpp"

namespace footfall::detail {

struct StructureError {
  std::size_t step = 0;  ///< index into Pipeline::steps
  Text message;          ///< the problem and the advice, without the place
};

/// Returns whether the step uses the height of agents from a Vertical clearance filter that must run before it.
bool needsClearance(const PipelineStep& step);

/// Returns whether a step behind the first `count` depends on triangles that are no floors.
bool needsObstacles(const std::vector<const PipelineStep*>& steps, std::size_t count);

/// The first enabled step that breaks the rules of parallel blocks: a Collapse without a strategy, a strategy without a
/// Collapse, a strategy inside a block, or a global filter inside a block. Then the first one whose values contradict
/// one another, which needs a clearance filter before it that is not there, or which would lose drops. Disabled steps
/// do not count.
std::optional<StructureError> findStructureError(const Pipeline& pipeline);

/// "line 3" when the step comes from a file, else "step 3 (Slope)", as a list of steps shows it (1-based); for
/// messages.
Text placeOfStep(const Pipeline& pipeline, std::size_t step);

}  // namespace footfall::detail
