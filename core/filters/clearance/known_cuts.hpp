// The results of an earlier run of the clearance filter for each face.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/assembly/assembly_memory.hpp"
#include "core/assembly/earlier_result.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"

namespace footfall::detail {

class KnownCuts {
 public:
  KnownCuts(const std::optional<EarlierResult>& earlier, const WalkableState& state, double height)
      : earlier_(earlier), state_(state), height_(height) {
    if (!earlier_) return;
    const WalkableState& before = earlier_->state();
    // Doubles may resolve less, or more, of the same points on a grid with another slack, and round them otherwise.
    sameClearance_ = before.memory->clearance == height && before.kernel->heights() == state.kernel->heights() &&
                     before.kernel->sign().slack == state.kernel->sign().slack;
    for (std::size_t t = 0; t < state.walkable.size() && !floorsDiffer_; ++t) {
      const Index then = earlier_->faceBefore(static_cast<Index>(t));
      floorsDiffer_ = then >= 0 && before.walkable[then] != state.walkable[t];
    }
  }

  /// The face's number then, when it was a floor and what is remembered of it can be used; else -1.
  [[nodiscard]] Index before(Index face) const {
    if (!earlier_) return -1;
    const Index then = earlier_->faceBefore(face);
    if (then < 0 || earlier_->state().walkable[then] == 0) return -1;
    return floorsDiffer_ && (*earlier_->state().cuts)[then].dependsOnFloors ? -1 : then;
  }
  /// True when standing() is complete and short. It leaves out triangles in the face's plane that were no floors, and
  /// obstacles that were not looked for because others covered the face. When many obstacles came, the index of the
  /// environment is faster.
  [[nodiscard]] bool knowsAll(Index faceBefore) const {
    constexpr std::size_t kMostAdded = 256;
    return earlier_ && earlier_->added().size() <= kMostAdded && faceBefore >= 0 &&
           !earlier_->state().cuts->isRemoved(faceBefore) && !(*earlier_->state().cuts)[faceBefore].dependsOnFloors;
  }
  /// True when something came or went in the clearance above the face.
  [[nodiscard]] bool isTouched(Index face) const {
    return earlier_->isTouched(clearanceBox(state_.kernel->mesh(), face, std::max(height_, clearance())));
  }
  /// The boxes around the obstacles that came and went there.
  [[nodiscard]] std::array<Box, 2> changedAt(Index face) const {
    return earlier_->changedIn(clearanceBox(state_.kernel->mesh(), face, height_));
  }
  /// All that may stand above a face within clearance().
  [[nodiscard]] std::vector<Index> standing(Index face, Index faceBefore, const CopyMemory& copies) const {
    const SourceMesh& mesh = state_.kernel->mesh();
    const Box above = clearanceBox(mesh, face, std::max(height_, clearance()));
    std::vector<Index> result;
    for (const Index t : earlier_->added())
      if (overlap(boxOf(mesh, t), above)) result.push_back(t);
    if (const auto known = earlier_->candidates(faceBefore, copies))
      result.insert(result.end(), known->begin(), known->end());
    return result;
  }
  [[nodiscard]] bool sameClearance() const { return sameClearance_; }
  [[nodiscard]] double clearance() const { return earlier_->state().memory->clearance; }

 private:
  const std::optional<EarlierResult>& earlier_;
  const WalkableState& state_;
  double height_;
  bool sameClearance_ = false;
  bool floorsDiffer_ = false;
};

}  // namespace footfall::detail
