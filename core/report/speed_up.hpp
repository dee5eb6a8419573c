// Speed-up S and efficiency E against one thread (thesis 5.4 and 5.6).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "footfall/report.hpp"

namespace footfall::detail {

/// Runs the pipeline and the same filters without blocks `runs` times each, in turn. Throws as runPipeline() does.
SpeedUp measureSpeedUp(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                       RunContext& context, int threads, int runs = 3);

}  // namespace footfall::detail
