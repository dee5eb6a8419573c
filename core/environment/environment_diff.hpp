// The difference between two versions of an environment: a file that was saved again is an edit of the version before,
// and only the changed parts are computed again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// `now` as an edit of `before`: the same vertices and triangles with the same parts and roles, those that `before` has
/// too first and in its order, the others in the order of `now`. Triangles are the same when their corners lie at equal
/// positions in the same winding; copies are counted. As nothing in a run depends on the order of an environment, the
/// result of a run is that of `now`, to the byte.
///
/// `now` itself where an edit would not pay: more than a quarter of the triangles differ, or the two disagree on which
/// sides count as up. Almost linear time. Throws Cancelled when `context` (may be null) was cancelled.
std::shared_ptr<const Environment> diffEnvironments(const std::shared_ptr<const Environment>& before,
                                                    const std::shared_ptr<const Environment>& now,
                                                    RunContext* context = nullptr);

}  // namespace footfall::detail
