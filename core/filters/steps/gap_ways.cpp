// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_ways.hpp"

namespace footfall::detail {

GapWay gapWay(const BorderSplits& splits, Index first, Index second, const GapFrame& frame,
              const std::array<double, 2>& ends) {
  const auto partOf = [&](Index number) {
    const MeshBorder& border = splits.border(number);
    const PlanSegment whole = planSegment(splits.vertex(border.from), splits.vertex(border.to));
    const double from = frame.along(whole.fromX, whole.fromY), to = frame.along(whole.toX, whole.toY);
    const auto at = [&](double along) { return std::clamp((along - from) / (to - from), 0.0, 1.0); };
    const double x = whole.toX - whole.fromX, y = whole.toY - whole.fromY;
    const double low = at(ends[0]), high = at(ends[1]);
    return PlanSegment{whole.fromX + low * x, whole.fromY + low * y, whole.fromX + high * x, whole.fromY + high * y};
  };
  return {first, second, {partOf(first), partOf(second)}};
}

}  // namespace footfall::detail
