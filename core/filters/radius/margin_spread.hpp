// Finds the triangles that straight walks from an edge, or from a place, reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "core/base/numbered_table.hpp"
#include "core/base/sorted_list.hpp"
#include "core/filters/radius/margin_surface.hpp"

namespace footfall::detail {

/// A part of what beams pass through.
struct Range {
  double low = 0, high = 0;
};

/// Beams from an edge, at a right angle to it.
struct Beams {
  PlanVector origin, along;
  double reach = 0;
  double touch = MarginSurface::kSlack;
  [[nodiscard]] double at(const PlanVector& p) const { return dot(p - origin, along); }
  [[nodiscard]] bool exits(const PlanVector& a, const PlanVector& b) const { return at(b) < at(a) + touch; }
  // Empty where the part of a side between two beams is not near.
  [[nodiscard]] std::optional<Range> rangeIfNear(const PlanVector& a, const PlanVector& b, const Range& beams) const {
    const PlanVector out = leftOf(along);
    const double atA = at(a), atB = at(b), outA = dot(a - origin, out), outB = dot(b - origin, out);
    double first = outA, last = outB;
    if (std::fabs(atB - atA) > touch) {
      const auto outAt = [&](double where) {
        return outA + std::clamp((where - atA) / (atB - atA), 0.0, 1.0) * (outB - outA);
      };
      first = outAt(beams.low - touch);
      last = outAt(beams.high + touch);
    }
    if (!(std::min(first, last) < reach && std::max(first, last) > -touch)) return std::nullopt;
    return Range{std::min(atA, atB), std::max(atA, atB)};
  }
};

inline PlanVector nearestOnSegment(const PlanVector& p, const PlanVector& a, const PlanVector& b) {
  const PlanVector d = b - a;
  const double square = dot(d, d), at = dot(p - a, d);
  // The same as a quotient that is clamped.
  const double t = !(at > 0) ? 0 : at >= square ? 1 : at / square;
  return a + t * d;
}

/// Beams from a place.
struct Rays {
  PlanVector apex, middle;
  double reach = 0;
  double touch = MarginSurface::kTouch;
  [[nodiscard]] double at(const PlanVector& p) const { return turnFrom(middle, p - apex); }
  // A side through the apex itself is left to whoever starts. One so near that doubles cannot decide on which side the
  // apex is, and whose range may be any, is not.
  [[nodiscard]] bool exits(const PlanVector& a, const PlanVector& b) const {
    const PlanVector p = a - apex, q = b - apex;
    if ((p.x == 0 && p.y == 0) || (q.x == 0 && q.y == 0)) return false;
    const double area = cross(p, q);
    return area > 0 || area > -MarginSurface::kShort * length(q - p);
  }
  // Empty where a side is not near. The one of the two ranges that ends behind the lowest beam, when a side goes behind
  // the apex.
  [[nodiscard]] std::optional<Range> rangeIfNear(const PlanVector& a, const PlanVector& b, const Range& beams) const {
    const double distance = length(apex - nearestOnSegment(apex, a, b));
    if (!(distance < reach)) return std::nullopt;
    if (distance < MarginSurface::kShort) return Range{-2, 2};
    const double first = at(a), last = at(b);
    if (first <= last) return Range{first, last};
    return last >= beams.low - touch ? Range{first - 4, last} : Range{first, last + 4};
  }
};

/// Lists the triangles that beams reach. What may be reached is taken as reached.
class Spread {
 public:
  /// Polls as it runs.
  Spread(const MarginSurface& surface, const Poll& poll) : surface_(surface), poll_(poll) {}

  void start() { found_.clear(); }
  void start(const std::vector<Index>& known) { found_ = known; }
  void enter(Index side, double low, double high) { stack_.push_back({side, {low, high}}); }
  template <class View>
  void run(const View& view) {
    seen_.clear();
    ranges_.clear();
    while (!stack_.empty()) {
      if ((++visited_ & 255) == 0) poll_();
      const Entry entry = stack_.back();
      stack_.pop_back();
      visit(entry, view);
    }
  }
  std::vector<Index> takeTriangles() {
    sortOnce(found_);
    return found_;
  }

 private:
  struct Entry {
    Index side = -1;
    Range beams;
  };

  template <class View>
  void visit(const Entry& entry, const View& view) {
    found_.push_back(entry.side / 3);
    const Index next = MarginSurface::nextSide(entry.side), previous = MarginSurface::previousSide(entry.side);
    const PlanVector entryBegin = surface_.begin(entry.side), entryEnd = surface_.begin(next),
                     tip = surface_.begin(previous);
    for (const auto& [side, a, b] : {std::tie(next, entryEnd, tip), std::tie(previous, tip, entryBegin),
                                     std::tie(entry.side, entryBegin, entryEnd)}) {
      if (surface_.isBorder(side)) continue;
      const bool exits = side != entry.side && view.exits(a, b);
      if (!exits && !surface_.hasLink(side)) continue;
      const std::optional<Range> range = view.rangeIfNear(a, b, entry.beams);
      if (!range) continue;
      const double low = std::max(range->low, entry.beams.low), high = std::min(range->high, entry.beams.high);
      if (low > high + view.touch) continue;
      if (!exits) {
        // Both borders of a link are divided at the same places.
        for (const Index other : surface_.beyond(side))
          if (surface_.beginVertex(other) != surface_.endVertex(side)) found_.push_back(other / 3);
        continue;
      }
      for (const Index other : surface_.beyond(side)) {
        const auto [number, isNew] = seen_.insert(other);
        if (isNew) ranges_.push_back({low, high});
        Range& seen = ranges_[number];
        if (!isNew && seen.low <= low && high <= seen.high) continue;
        seen = {std::min(seen.low, low), std::max(seen.high, high)};
        stack_.push_back({other, {low, high}});
      }
    }
  }

  const MarginSurface& surface_;
  Poll poll_;
  std::uint32_t visited_ = 0;
  std::vector<Entry> stack_;
  NumberedTable<Index> seen_;  ///< sides that were entered
  std::vector<Range> ranges_;  ///< ranges of each of them
  std::vector<Index> found_;   ///< triangles
};

}  // namespace footfall::detail
