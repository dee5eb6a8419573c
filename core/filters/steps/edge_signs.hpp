// Signs of what is linear along an edge of the border, and the pieces of the edge between their changes.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All decisions are exact signs at the two ends of an edge, which are exact points. Where a sign changes in between,
// the place is computed exactly, rounded, and left out with a margin; pieces therefore end a little inside of their
// exact extent. Locating a change takes far longer than the signs, and most signs are not needed further, so locate()
// is a separate call.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// An edge of the border; the walkable area is on its left.
struct BorderEdge {
  MeshVertex begin, end;
  Index face = -1;  ///< face of the walkable area
};

/// An open piece of an edge, from 0 at its begin to 1 at its end.
struct EdgePiece {
  double begin = 0, end = 1;
  [[nodiscard]] double middle() const { return begin + (end - begin) / 2; }
  [[nodiscard]] bool isEmpty() const { return !(begin < end); }
};

/// The sign of a linear function at both ends of an edge. Where the signs differ, it changes strictly between `low` and
/// `high`, once EdgeSigns::locate() has found where.
struct SignAlong {
  int begin = 0, end = 0;
  double low = -1, high = -1;
  std::array<Index, 4> line{};  ///< identifies the function: equal ones change at the same place

  [[nodiscard]] bool changes() const { return begin * end < 0; }
  [[nodiscard]] bool isLocated() const { return high >= 0; }
  [[nodiscard]] bool isZero() const { return begin == 0 && end == 0; }
  /// The sign on a piece in which it does not change; it must be located.
  [[nodiscard]] int on(const EdgePiece& piece) const {
    assert(!changes() || isLocated());
    if (changes()) return piece.middle() < low ? begin : end;
    return begin != 0 ? begin : end;
  }
};

/// Computes signs along one edge after the other. It returns signs that are not located; locate() does that. Threads
/// cannot share it, because it counts fall-backs.
class EdgeSigns {
 public:
  explicit EdgeSigns(const PlanKernel& kernel) : kernel_(kernel) {}

  /// The side of a line, taken on `face`, on which the edge lies.
  SignAlong ofLine(const BorderEdge& edge, const PlanLine& line, Index face);
  /// Positive on the triangle's side of its edge from corner k to k + 1; the triangle is not vertical.
  SignAlong inside(const BorderEdge& edge, Index triangle, int k);
  /// Positive where the triangle, which is not vertical, is higher than `face` raised by a level.
  SignAlong height(const BorderEdge& edge, Index triangle, Index face, Index level);
  /// Finds the place where a sign changes, if it does and the place is not known. The sign must not come from leftOf().
  void locate(const BorderEdge& edge, SignAlong& sign) const;
  /// Finds the place for a sign of leftOf() of the same vertices.
  void locate(const BorderEdge& edge, const MeshVertex& from, const MeshVertex& to, SignAlong& sign) const;
  /// Positive on the left of the line from one vertex to another; lines with the same `name` are one line.
  SignAlong leftOf(const BorderEdge& edge, const MeshVertex& from, const MeshVertex& to,
                   const std::array<Index, 2>& name);
  /// Orientation of the edge and a source vertex in the plan.
  int orientation(const BorderEdge& edge, Index vertex);
  int orientation(const BorderEdge& edge, const MeshVertex& vertex);

  ExactFallbacks fallbacks;

 private:
  /// Sign of the height of a triangle's plane over a vertex raised by a level, where doubles show it; else 0.
  [[nodiscard]] int quickHeight(Index triangle, Index level, const MeshVertex& p) const;
  [[nodiscard]] int sideAt(const PlanLine& line, Index face, const MeshVertex& p);

  const PlanKernel& kernel_;
};

/// The pieces of an edge in which none of several signs changes.
class EdgePieces {
 public:
  void clear() { zones_.clear(); }
  /// Adds a sign; one that changes must be located.
  void add(const SignAlong& sign) {
    assert(!sign.changes() || sign.isLocated());
    if (sign.changes()) zones_.push_back({sign.low, sign.high, sign.line});
  }
  /// The pieces for which `holds(piece)`, in order. Neighbours that only one line separates become one piece, because
  /// single points do not count.
  template <class Holds>
  std::vector<EdgePiece> where(const Holds& holds) {
    std::vector<EdgePiece> pieces;
    sort();
    double begin = 0;
    bool isOpen = false;
    for (std::size_t i = 0; i <= zones_.size();) {
      const double end = i < zones_.size() ? zones_[i].low : 1;
      if (begin < end) {
        const EdgePiece piece{begin, end};
        const bool isHeld = holds(piece);
        if (isHeld && isOpen)
          pieces.back().end = end;
        else if (isHeld)
          pieces.push_back(piece);
        isOpen = isHeld;
      } else if (i == zones_.size()) {
        break;
      }
      if (i == zones_.size()) break;
      std::size_t last = i;
      for (begin = zones_[i].high; last + 1 < zones_.size() && zones_[last + 1].low <= begin; ++last) {
        isOpen = isOpen && zones_[last + 1].line == zones_[i].line;
        begin = std::max(begin, zones_[last + 1].high);
      }
      i = last + 1;
    }
    return pieces;
  }

 private:
  struct Zone {
    double low, high;
    std::array<Index, 4> line;
  };
  void sort();

  std::vector<Zone> zones_;
};

/// The intersection of two lists, in order; each list is in order and without overlaps.
std::vector<EdgePiece> common(const std::vector<EdgePiece>& a, const std::vector<EdgePiece>& b);
/// Removes closed pieces, in any order, from open ones.
std::vector<EdgePiece> without(std::vector<EdgePiece> pieces, std::vector<EdgePiece> blocked);

}  // namespace footfall::detail
