// Gates of a disc, and what is known of ways through them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/navigation/taut_string.hpp"

namespace footfall::detail {

/// The apex of a funnel, and the first places of its chains.
struct TautCone {
  TautApex apex;
  std::optional<FieldVector> left, right;
};

/// A gate of a way, and its place on the axis.
struct AxisGate {
  TautGate ends;
  FieldVector place;
};

/// Returns whether a place lies between the two spokes of a gate and the straight line between its ends. Then it is in
/// the empty disc about the gate's place, and a way from there may cross a spoke without crossing the line.
inline bool isBetween(const AxisGate& gate, FieldVector p) {
  const FieldVector corners[] = {gate.ends.left, gate.place, gate.ends.right};
  const double turn = cross(corners[1] - corners[0], corners[2] - corners[0]), sign = turn < 0 ? -1 : 1;
  for (int i = 0; i < 3; ++i)
    if (sign * cross(corners[(i + 1) % 3] - corners[i], p - corners[i]) < 0) return false;
  return turn != 0;
}

/// Puts the ends of a gate in order behind the gate before, exactly: each end lies ahead of the line between the last
/// end on its own side and the last one on the other side. An end that does not is the one of the gate before. Without
/// roundings no end lies behind (core/navigation/body_search.hpp), so that this changes a way by no more than they do.
inline void keepAhead(TautGate& gate, const TautGate& before) {
  const auto isAhead = [](FieldVector right, FieldVector left, FieldVector end) {
    return turnOf(right, left, end) <= 0;
  };
  const bool isRightAhead = gate.rightEnd == before.rightEnd || isAhead(before.right, before.left, gate.right);
  const bool isLeftAhead = gate.leftEnd == before.leftEnd || isAhead(gate.right, before.left, gate.left);
  if (isRightAhead && isLeftAhead) return;
  gate.isLeftFirst = isAhead(before.right, before.left, gate.left) && isAhead(before.right, gate.left, gate.right);
  if (gate.isLeftFirst) return;
  if (!isRightAhead) {
    gate.right = before.right;
    gate.rightEnd = before.rightEnd;
  }
  if (!isAhead(gate.right, before.left, gate.left)) {
    gate.left = before.left;
    gate.leftEnd = before.leftEnd;
  }
}

inline bool isInDisc(const AxisGate& gate, FieldVector p) {
  return lengthOf(p - gate.place) <=
         std::max(lengthOf(gate.ends.left - gate.place), lengthOf(gate.ends.right - gate.place));
}

inline bool isCrossedAt(const AxisGate& gate, FieldVector apex) {
  return gate.ends.isOpen || isPassed(gate.ends, apex);
}

/// The place at which a way reaches a gate first, and a length that no way to the gate is shorter than.
struct Arrival {
  FieldVector place;
  double length = 0, least = 0;
};

inline Arrival arrivalAt(const TautCone& funnel, const AxisGate& gate) {
  const FieldVector apex = funnel.apex.point.place, left = gate.ends.left, way = gate.ends.right - left;
  if (isCrossedAt(gate, apex)) return {apex, funnel.apex.length, 0};
  const auto shareAt = [&](const std::optional<FieldVector>& limit, double end) {
    if (!limit) return end;
    const FieldVector ray = *limit - apex;
    const double share = -cross(ray, left - apex) / cross(ray, way);
    return share >= 0 && share <= 1 ? share : end;
  };
  const double square = dot(way, way), nearest = square > 0 ? dot(apex - left, way) / square : 0;
  const double low = shareAt(funnel.left, 0), high = std::max(low, shareAt(funnel.right, 1));
  const FieldVector place = left + way * std::clamp(nearest, low, high);
  const double length = funnel.apex.lengthTo(place);
  return {place, length, length};
}

/// A length that no way through a gate to a place is shorter than.
inline double leastThrough(const TautCone& funnel, const AxisGate& gate, FieldVector to) {
  const FieldVector apex = funnel.apex.point.place, way = gate.ends.left - gate.ends.right;
  if (isCrossedAt(gate, apex)) return funnel.apex.lengthTo(to);
  const double square = dot(way, way), before = cross(way, to - gate.ends.right);
  if (square > 0 && before > 0) to = to - leftOf(way) * (2 * before / square);
  double least = std::numeric_limits<double>::infinity();
  for (const bool isLeft : {true, false}) {
    const std::optional<FieldVector>& limit = isLeft ? funnel.left : funnel.right;
    if (!limit || (isLeft ? 1 : -1) * cross(*limit - apex, to - apex) <= 0) continue;
    least = std::min(least, funnel.apex.lengthTo(*limit) + lengthOf(to - *limit));
  }
  return std::isfinite(least) ? least : funnel.apex.lengthTo(to);
}

}  // namespace footfall::detail
