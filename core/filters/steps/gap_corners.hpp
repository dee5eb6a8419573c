// Links at corners of borders, and short ones, that are not needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_linker.hpp"
#include "core/filters/steps/gap_ways.hpp"
#include "core/filters/steps/step_memory.hpp"

namespace footfall::detail {

/// Gaps with a place (GapPiece::corner: at corners, and short ones) whose sides hang together right there: within twice
/// the gap's width (environment units) one gets from one to the other on the mesh, over steps, and over other gaps; of
/// those with a place, the longer ones come first. So notches and slits between chains of edges get no link across each
/// vertex as well, a corner has one, floors that are hardly larger than the gap get as few as join them, and nothing
/// comes apart: where a gap on which others rest gets no link, those that are needed instead are found again.
class NeedlessGaps {
 public:
  /// `splits` must outlive this.
  NeedlessGaps(const BorderSplits& splits, double gap);

  /// Moves the needless ones of `gaps` here. `poll` may throw to cancel.
  void takeFrom(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps, Poll poll);
  /// Moves those out whose sides no longer hang together right there, the fewest, in the order in which they came.
  /// `lost`: parts of borders that had ways and have none. `findWays` returns the ways over gaps that there are; it is
  /// called only where one of them may be needed.
  [[nodiscard]] std::vector<GapStretch> takeNeeded(const std::vector<PlanSegment>& lost,
                                                   const std::vector<StepStretch>& steps,
                                                   const std::function<std::vector<GapWay>()>& findWays, Poll poll);
  [[nodiscard]] std::size_t count() const { return gaps_.size(); }

 private:
  /// Those with a place near to a lost part.
  [[nodiscard]] std::vector<std::size_t> findNear(const std::vector<PlanSegment>& lost, Poll poll) const;

  const BorderSplits& splits_;
  double reach_ = 0;
  std::vector<GapStretch> gaps_;
};

}  // namespace footfall::detail
