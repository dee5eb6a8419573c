// The functions that the editor and reports need of a run besides its result (footfall/run.hpp).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/distributed/cell_exchange.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/partitioning/partition.hpp"
#include "footfall/run.hpp"

namespace footfall::detail {

/// The states that a run of the same pipeline goes through: before its first enabled step, and then after each. What
/// the cache has is taken from there, the rest is run and kept, as by runPipeline(). Inside a parallel block the states
/// are those of its filters one after the other, which give the same; a strategy changes nothing.
std::vector<StatePtr> stepStates(std::shared_ptr<const Environment> environment, const Pipeline& pipeline,
                                 RunContext& context, ResultCache& cache, int threads = 0);

/// The cells that the parallel block of `step` (a strategy; index into Pipeline::steps) would have, without running any
/// filter: all triangles that face up count as floors. Throws Cancelled or InputError.
Partition previewPartition(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                           std::size_t step, RunContext& context, int threads = 0);

/// The same as runPipeline(), by several processes that divide the cells of parallel blocks. The mesh is null in
/// processes that stop at the last block; the others get the bytes of runPipeline(). This process starts from the last
/// state in `cache`; others do not have it, and run all blocks if any is left. Throws what `exchange` throws, too.
RunResult runTogether(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, RunContext& context,
                      CellExchange& exchange, int threads = 0, ResultCache* cache = nullptr);

}  // namespace footfall::detail
