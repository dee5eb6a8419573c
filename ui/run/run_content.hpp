// Makes the content of the view for a finished run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/run/run_job.hpp"

namespace footfall::ui {

/// The walkable area before a part of it was removed for one reason.
struct RemovedShare {
  const RemovalStyle* style = nullptr;
  StepMeshes::Mesh before;  ///< null: the environment's own floors
  std::size_t step = 0;     ///< enabled step that removed it
};

/// The removals of each step, in the order of the steps; those of a RadiusFilter are one share. Steps whose meshes are
/// no longer known are left out.
std::vector<RemovedShare> removedShares(const RunJob& job, const RunResult& result);

/// Returns whether the walls and ledges of a share can be separated by a run: it must be that of a RadiusFilter behind
/// a clearance, with distances to both.
bool isDivisible(const RunJob& job, const RemovedShare& share);

/// Divides shares into places too near a wall and places too near a ledge; a place too near both counts as too near a
/// wall, as in explanations of "why". Each RadiusFilter runs again with walls only, so this may take as long as the run
/// itself. Throws Cancelled.
std::vector<RemovedShare> dividedShares(const RunJob& job, const RunResult& result,
                                        const std::vector<RemovedShare>& shares, RunContext& context);

/// Makes the content of the view. Geometry in `known` of the same meshes is reused.
ViewContent makeContent(const RunJob& job, const RunResult& result, const std::vector<RemovedShare>& shares,
                        const ViewContent& known = {});

}  // namespace footfall::ui
