// The share of each cell of a parallel block that a run took over from earlier runs with the same cache.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "footfall/run.hpp"

namespace footfall::detail {

struct CellReuse {
  std::uint64_t floors = 0;  ///< floors that the block's clearance filter had to cut
  std::uint64_t reused = 0;  ///< of these, floors whose outcome is that of an earlier run

  [[nodiscard]] bool all() const { return floors > 0 && reused == floors; }
};

/// For each parallel block of the pipeline's enabled steps, in order, its cells as of the run that computed the block;
/// empty for a block that has no clearance filter, or whose state the cache does not have.
std::vector<std::vector<CellReuse>> cellReuse(const std::shared_ptr<const Environment>& environment,
                                              const Pipeline& pipeline, ResultCache& cache);

}  // namespace footfall::detail
