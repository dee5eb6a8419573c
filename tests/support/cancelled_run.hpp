// Cancels a run in the middle of one of its steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::test {

/// The processor time of the step, in milliseconds, in a run on one thread.
double stepCpuMs(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline, std::size_t step);

/// The processor time in milliseconds for which a run on one thread goes on after it was cancelled, `afterMs`
/// milliseconds of processor time into the step. Nothing if the run was over each time before it noticed: the machine
/// decides how soon another thread runs.
std::optional<double> cpuMsAfterCancelling(const std::shared_ptr<const Environment>& environment,
                                           const Pipeline& pipeline, std::size_t step, double afterMs);

}  // namespace footfall::test
