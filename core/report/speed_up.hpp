// Speed-up S and efficiency E against one thread (thesis 5.4 and 5.6).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/pipeline/runner.hpp"

namespace footfall::detail {

/// Medians of several runs, in milliseconds.
struct SpeedUp {
  double oneThreadMs = 0;  ///< the same filters without parallel blocks, on one thread
  double parallelMs = 0;   ///< as given

  [[nodiscard]] double speedUp() const { return parallelMs > 0 ? oneThreadMs / parallelMs : 1; }
  [[nodiscard]] double efficiency(int threads) const { return speedUp() / threads; }
};

/// Runs the pipeline and the same filters without blocks `runs` times each, in turn. Throws as runPipeline() does.
SpeedUp measureSpeedUp(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                       RunContext& context, int threads, int runs = 3);

}  // namespace footfall::detail
