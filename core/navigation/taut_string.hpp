// The shortest way through gates: a funnel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/mesh/field_surface.hpp"

namespace footfall::detail {

/// A way goes between both places. `ends` are numbers by which equal places are known, left and right.
struct TautGate {
  FieldVector left, right;
  std::uint32_t leftEnd = 0, rightEnd = 0;
  bool isOpen = false;  ///< a way may pass it anywhere
};

/// A place at which the way bends.
struct TautApex {
  static constexpr std::uint32_t kNoEnd = 0xFFFFFFFF;
  FieldVector place;
  double length = 0;           ///< up to there
  std::size_t nextGate = 0;    ///< number of gates that it has passed
  std::uint32_t end = kNoEnd;  ///< of a gate; none at the start
  [[nodiscard]] double lengthTo(FieldVector p) const { return length + lengthOf(p - place); }
};

/// One side of a funnel: an end of a gate.
struct TautLimit {
  bool isSet = false;
  FieldVector place;
  std::size_t gate = 0;
  std::uint32_t end = TautApex::kNoEnd;
};

/// The way so far: every way through its gates bends at the apex, or begins there, and goes on between both limits.
struct TautFunnel {
  TautApex apex;
  TautLimit left, right;
};

/// Returns whether a bend lies on a gate, between its ends, or behind it.
inline bool isPassed(const TautGate& gate, FieldVector p) {
  const FieldVector left = gate.left - p, right = gate.right - p;
  return cross(right, left) <= 0 && (left.x != 0 || left.y != 0) && (right.x != 0 || right.y != 0) &&
         dot(left, right) <= 0;
}

/// Pulls the way through more gates (Lee and Preparata 1984; Chazelle 1982), up to number `end`, from `next` on. Gates
/// are given by `gateAt` by number; it is called for earlier numbers where the apex moves back. `onMove` gets each new
/// apex, and returns whether to go on. Returns false where it did not.
template <class GateAt, class OnMove>
bool pullThrough(TautFunnel& funnel, std::size_t next, std::size_t end, const GateAt& gateAt, const OnMove& onMove) {
  while (next < end) {
    const TautGate gate = gateAt(next);
    bool isMoved = false;
    for (const bool isLeft : {false, true}) {
      if (gate.isOpen || isPassed(gate, funnel.apex.place)) break;
      const FieldVector place = isLeft ? gate.left : gate.right, way = place - funnel.apex.place;
      TautLimit &own = isLeft ? funnel.left : funnel.right, &other = isLeft ? funnel.right : funnel.left;
      if (way.x == 0 && way.y == 0) continue;
      const double sign = isLeft ? -1 : 1;
      // An end outside of the funnel does not make it narrower.
      if (own.isSet && sign * cross(own.place - funnel.apex.place, way) < 0) continue;
      if (other.isSet && sign * cross(way, other.place - funnel.apex.place) < 0) {
        const TautLimit to = other;
        funnel = {{to.place, funnel.apex.lengthTo(to.place), to.gate + 1, to.end}, {}, {}};
        if (!onMove(funnel.apex)) return false;
        next = funnel.apex.nextGate;
        isMoved = true;
        break;
      }
      own = {true, place, next, isLeft ? gate.leftEnd : gate.rightEnd};
    }
    if (!isMoved) ++next;
  }
  return true;
}

}  // namespace footfall::detail
