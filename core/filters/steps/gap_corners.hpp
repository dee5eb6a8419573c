// Finds short links, and links at corners of borders, that are not needed.
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

/// Gaps with a place (GapPiece::corner: at corners, and short ones) whose sides are connected close by: within twice
/// the gap's width (environment units) an agent gets from one side to the other on the mesh, over steps, and over other
/// gaps. Among gaps with a place, longer ones come first. Notches and slits between chains of edges then get no extra
/// link across each vertex, a corner has one link, and floors hardly larger than the gap get as few links as join them.
/// Nothing becomes unreachable: where a gap that others rely on gets no link, the gaps that replace it are found again.
class NeedlessGaps {
 public:
  /// `splits` must outlive this object.
  NeedlessGaps(const BorderSplits& splits, double gap);

  /// Moves the needless gaps out of `gaps` into this object. `poll` may throw to cancel.
  void takeFrom(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps, Poll poll);
  /// Returns gaps whose sides are no longer connected close by, as few as possible, in the order in which they were
  /// added. `lost` has the parts of borders that had ways and have none now. `findWays` returns the present ways over
  /// gaps; it is called only where one of them may be needed.
  [[nodiscard]] std::vector<GapStretch> takeNeeded(const std::vector<PlanSegment>& lost,
                                                   const std::vector<StepStretch>& steps,
                                                   const std::function<std::vector<GapWay>()>& findWays, Poll poll);
  [[nodiscard]] std::size_t count() const { return gaps_.size(); }

 private:
  /// The gaps whose place is near a lost part.
  [[nodiscard]] std::vector<std::size_t> findNear(const std::vector<PlanSegment>& lost, Poll poll) const;

  const BorderSplits& splits_;
  double reach_ = 0;
  std::vector<GapStretch> gaps_;
};

}  // namespace footfall::detail
