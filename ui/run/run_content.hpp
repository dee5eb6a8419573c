// What the view shows of a finished run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/run/run_job.hpp"

namespace footfall::ui {

/// What was walkable before some of it was removed for one reason.
struct RemovedShare {
  const RemovalStyle* style = nullptr;
  StepMeshes::Mesh before;  ///< null: the environment's own floors
  std::size_t step = 0;     ///< the enabled step that removed it
};

/// What each step has removed, in the order of the steps; what a RadiusFilter has removed is one share. Steps whose
/// meshes are not known any more are left out.
std::vector<RemovedShare> removedShares(const RunJob& job, const RunResult& result);

/// Whether a share has walls and ledges that a run can tell apart: of a RadiusFilter behind a clearance, which keeps
/// away from both.
bool isDivisible(const RunJob& job, const RemovedShare& share);

/// The shares with what is too near a wall and what is too near a ledge apart; a place that is too near both is too
/// near a wall, as in answers to why. Runs each RadiusFilter again, away from walls only, so it may take as long as the
/// run itself. Throws Cancelled.
std::vector<RemovedShare> dividedShares(const RunJob& job, const RunResult& result,
                                        const std::vector<RemovedShare>& shares, RunContext& context);

/// Makes what the view shows. What `known` has of the same meshes is reused.
ViewContent makeContent(const RunJob& job, const RunResult& result, const std::vector<RemovedShare>& shares,
                        const ViewContent& known = {});

}  // namespace footfall::ui
