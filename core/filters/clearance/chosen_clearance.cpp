// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/chosen_clearance.hpp"

#include <atomic>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/filters/clearance/clearance_pass.hpp"

namespace footfall::detail {

FilterOutcome applyClearanceToChosen(const StatePtr& state, double height, const std::vector<char>& chosen,
                                     RunContext& context) {
  ClearancePass pass(state, height, {}, {}, {}, context);
  std::vector<char> cut(state->walkable.size(), 0);
  std::vector<Index> faces;
  for (std::size_t t = 0; t < cut.size(); ++t) {
    cut[t] = static_cast<char>(state->walkable[t] != 0 && chosen[t] != 0);
    if (cut[t] != 0) faces.push_back(static_cast<Index>(t));
  }
  // One at a time: a single one can be most of the work.
  std::atomic<std::size_t> next{0};
  constexpr std::size_t kFacesPerTask = 16;
  parallelFor((faces.size() + kFacesPerTask - 1) / kFacesPerTask, [&](std::size_t) {
    ClearancePass::Worker& own = pass.worker();
    for (std::size_t k = 0; k < kFacesPerTask; ++k) {
      const std::size_t i = next.fetch_add(1, std::memory_order_relaxed);
      if (i >= faces.size()) return;
      context.checkCancelled();
      pass.clip(faces[i], own);
    }
  });
  FilterOutcome outcome = pass.finish(std::move(cut), state->removed, false);
  auto result = std::make_shared<WalkableState>(*outcome.state);
  result->walkable = state->walkable;
  outcome.state = std::move(result);
  return outcome;
}

}  // namespace footfall::detail
