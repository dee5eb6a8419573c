// The shortest way through gates: a funnel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/exact/error_double.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/mesh/field_surface.hpp"

namespace footfall::detail {

/// A way goes between both places. `leftEnd` and `rightEnd` are numbers by which equal places are known.
struct TautGate {
  FieldVector left, right;
  std::uint32_t leftEnd = 0, rightEnd = 0;
  bool isOpen = false;       ///< a way may pass it anywhere
  bool isLeftFirst = false;  ///< behind the gate before, the left end comes first; the right one does otherwise
};

/// The sign of the turn from a over b to c, exactly: 1 to the left, -1 to the right, 0 on a line.
inline int turnOf(FieldVector a, FieldVector b, FieldVector c) {
  constexpr double kUnderflow = 0x1p-1000;  // products below lose more than their share
  if (const MaybeSign sign = filteredArea(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y, kUnderflow)) return *sign;
  // Two places are one, or all three are on a line along an axis.
  if ((b.x == a.x || c.y == a.y) && (b.y == a.y || c.x == a.x)) return 0;
  return facing({a.x, a.y, 0}, {b.x, b.y, 0}, {c.x, c.y, 0});
}

/// An end of a gate.
struct TautPoint {
  static constexpr std::uint32_t kNoEnd = 0xFFFFFFFF;
  FieldVector place;
  std::uint32_t end = kNoEnd;
};

/// A place at which the way bends, or begins.
struct TautApex {
  TautPoint point;
  double length = 0;  ///< up to there
  [[nodiscard]] double lengthTo(FieldVector p) const { return length + lengthOf(p - point.place); }
};

/// The places at which ways from the apex to one end of the last gate bend, and that end.
class TautChain {
 public:
  void assign(const TautPoint* begin, std::size_t count) {
    points_.assign(begin, begin + count);
    first_ = 0;
  }
  [[nodiscard]] std::size_t size() const { return points_.size() - first_; }
  [[nodiscard]] const TautPoint& at(std::size_t i) const { return points_[first_ + i]; }
  [[nodiscard]] const TautPoint& back() const { return points_.back(); }
  void push(const TautPoint& point) { points_.push_back(point); }
  void popBack() { points_.pop_back(); }
  void popFront() { ++first_; }

 private:
  std::vector<TautPoint> points_;
  std::size_t first_ = 0;
};

/// Returns whether a bend lies on a gate, between its ends, or behind it.
inline bool isPassed(const TautGate& gate, FieldVector p) {
  const FieldVector left = gate.left - p, right = gate.right - p;
  return turnOf(p, gate.right, gate.left) <= 0 && (left.x != 0 || left.y != 0) && (right.x != 0 || right.y != 0) &&
         dot(left, right) <= 0;
}

/// The way so far: every way through its gates bends at the apex, or begins there, and goes on between both chains
/// (Lee and Preparata 1984; Chazelle 1982). Between two gates lie two triangles, of the ends of the one gate and the
/// first end of the other, and so on. Where all of them turn to the left, the way is the shortest one for the given
/// doubles, because all turns are exact; keepAhead() (core/navigation/body_gates.hpp) sees to that.
struct TautFunnel {
  TautApex apex;
  TautChain left, right;

  /// Pulls the way through one more gate. `onMove` gets each new apex, and returns whether to go on. Returns false
  /// where it did not.
  template <class OnMove>
  bool pullThrough(const TautGate& gate, const OnMove& onMove) {
    if (gate.isOpen || isPassed(gate, apex.point.place)) return true;
    const TautPoint atLeft{gate.left, gate.leftEnd}, atRight{gate.right, gate.rightEnd};
    if (gate.isLeftFirst) return addEnd(left, right, atLeft, 1, onMove) && addEnd(right, left, atRight, -1, onMove);
    return addEnd(right, left, atRight, -1, onMove) && addEnd(left, right, atLeft, 1, onMove);
  }

 private:
  static bool isSame(FieldVector a, FieldVector b) { return a.x == b.x && a.y == b.y; }

  /// `sign` is 1 for the left chain, which bends to the left.
  template <class OnMove>
  bool addEnd(TautChain& own, TautChain& other, const TautPoint& end, int sign, const OnMove& onMove) {
    if (own.size() > 0 && isSame(own.back().place, end.place)) return true;
    while (own.size() > 0) {
      const FieldVector last = own.back().place;
      const FieldVector before = own.size() > 1 ? own.at(own.size() - 2).place : apex.point.place;
      if (sign * turnOf(before, last, end.place) > 0) break;
      own.popBack();
    }
    while (own.size() == 0 && other.size() > 0) {
      const TautPoint first = other.at(0);
      if (sign * turnOf(apex.point.place, first.place, end.place) >= 0) break;
      apex = {first, apex.lengthTo(first.place)};
      other.popFront();
      if (!onMove(apex)) return false;
    }
    if (own.size() > 0 || !isSame(apex.point.place, end.place)) own.push(end);
    return true;
  }
};

}  // namespace footfall::detail
