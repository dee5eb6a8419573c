// Ways from one border to another over a part of each, and the parts without a way.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_conditions.hpp"

namespace footfall::detail {

/// A segment in the plan; scaled.
struct PlanSegment {
  double fromX = 0, fromY = 0, toX = 0, toY = 0;
  [[nodiscard]] bool isNear(const Vec3& place, double reach) const {
    const double x = toX - fromX, y = toY - fromY, square = x * x + y * y;
    const double px = place.x - fromX, py = place.y - fromY;
    const double t = square > 0 ? std::clamp((px * x + py * y) / square, 0.0, 1.0) : 0;
    const double dx = px - t * x, dy = py - t * y;
    return dx * dx + dy * dy <= reach * reach;
  }
};
inline PlanSegment planSegment(const MeshVertex& a, const MeshVertex& b) { return {a.x, a.y, b.x, b.y}; }

/// The part of a border along an interval of a frame.
PlanSegment partOf(const PlanSegment& border, const GapFrame& frame, const std::array<double, 2>& ends);

/// Two borders, and the part of each from which one gets to the other.
struct GapWay {
  Index first = -1, second = -1;
  std::array<PlanSegment, 2> parts;
};

/// The ways over a piece of a gap between two borders, along an interval.
GapWay gapWay(const BorderSplits& splits, Index first, Index second, const GapPiece& piece,
              const std::array<double, 2>& ends);

}  // namespace footfall::detail
