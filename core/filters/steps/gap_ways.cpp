// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_ways.hpp"

namespace footfall::detail {

PlanSegment partOf(const PlanSegment& border, const GapFrame& frame, const std::array<double, 2>& ends) {
  const double from = frame.along(border.fromX, border.fromY), to = frame.along(border.toX, border.toY);
  const auto at = [&](double along) { return std::clamp((along - from) / (to - from), 0.0, 1.0); };
  const double x = border.toX - border.fromX, y = border.toY - border.fromY;
  const double low = at(ends[0]), high = at(ends[1]);
  return {border.fromX + low * x, border.fromY + low * y, border.fromX + high * x, border.fromY + high * y};
}

GapWay gapWay(const BorderSplits& splits, Index first, Index second, const GapPiece& piece,
              const std::array<double, 2>& ends) {
  const auto partAlong = [&](Index number, std::size_t border) {
    const MeshBorder& side = splits.border(number);
    return partOf(planSegment(splits.vertex(side.from), splits.vertex(side.to)), piece.frameOf(border), ends);
  };
  return {first, second, {partAlong(first, 0), partAlong(second, 1)}};
}

}  // namespace footfall::detail
