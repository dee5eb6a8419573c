// Cancels a run in the middle of one of its steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::test {

/// What the step takes, in milliseconds of processor time, in a run on one thread.
double stepCpuMs(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline, std::size_t step);

/// How long a run on one thread that is told so after `afterMs` milliseconds of processor time in the step goes on, in
/// milliseconds of processor time. Nothing if the run was over each time before it heard of it: how soon another thread
/// speaks is the machine's choice.
std::optional<double> cpuMsAfterCancelling(const std::shared_ptr<const Environment>& environment,
                                           const Pipeline& pipeline, std::size_t step, double afterMs);

}  // namespace footfall::test
