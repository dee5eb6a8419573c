// Finds the triangles that straight walks from an edge, or from a place, reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/numbered_table.hpp"
#include "core/base/sorted_list.hpp"
#include "core/filters/radius/margin_surface.hpp"

namespace footfall::detail {

/// Beams from an edge, at a right angle to it.
struct Beams {
  PlanVector origin, along;
  double reach = 0;
  double touch = MarginSurface::kSlack;
  [[nodiscard]] double at(const PlanVector& p) const { return dot(p - origin, along); }
  [[nodiscard]] bool exits(const PlanVector& a, const PlanVector& b) const { return at(b) < at(a) + touch; }
  [[nodiscard]] std::array<double, 2> range(const PlanVector& a, const PlanVector& b, double /*lowest*/) const {
    return {std::min(at(a), at(b)), std::max(at(a), at(b))};
  }
  // True for the part of a side between two beams.
  [[nodiscard]] bool isNear(const PlanVector& a, const PlanVector& b, double low, double high) const {
    const PlanVector out = leftOf(along);
    const double atA = at(a), atB = at(b), outA = dot(a - origin, out), outB = dot(b - origin, out);
    double first = outA, last = outB;
    if (std::fabs(atB - atA) > touch) {
      const auto outAt = [&](double where) {
        return outA + std::clamp((where - atA) / (atB - atA), 0.0, 1.0) * (outB - outA);
      };
      first = outAt(low - touch);
      last = outAt(high + touch);
    }
    return std::min(first, last) < reach && std::max(first, last) > -touch;
  }
};

inline double distanceToSegment(const PlanVector& p, const PlanVector& a, const PlanVector& b) {
  const PlanVector d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return length(p - (a + t * d));
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
    return cross(p, q) > -MarginSurface::kShort * length(q - p);
  }
  // The one of the two ranges that ends behind `lowest`, when a side goes behind the apex.
  [[nodiscard]] std::array<double, 2> range(const PlanVector& a, const PlanVector& b, double lowest) const {
    if (distanceToSegment(apex, a, b) < MarginSurface::kShort) return {-2, 2};
    const double first = at(a), last = at(b);
    if (first <= last) return {first, last};
    return last >= lowest ? std::array{first - 4, last} : std::array{first, last + 4};
  }
  [[nodiscard]] bool isNear(const PlanVector& a, const PlanVector& b, double /*low*/, double /*high*/) const {
    return distanceToSegment(apex, a, b) < reach;
  }
};

/// Lists the triangles that beams reach. What may be reached is taken as reached.
class Spread {
 public:
  /// Polls as it runs.
  Spread(const MarginSurface& surface, const Poll& poll) : surface_(surface), poll_(poll) {}

  void start() { found_.clear(); }
  void start(const std::vector<Index>& known) { found_ = known; }
  void enter(Index side, double low, double high) { stack_.push_back({side, low, high}); }
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
    double low = 0, high = 0;
  };

  template <class View>
  void visit(const Entry& entry, const View& view) {
    found_.push_back(entry.side / 3);
    for (const Index side :
         {MarginSurface::nextSide(entry.side), MarginSurface::previousSide(entry.side), entry.side}) {
      if (surface_.isBorder(side)) continue;
      const PlanVector a = surface_.begin(side), b = surface_.end(side);
      const bool exits = side != entry.side && view.exits(a, b);
      if (!exits && !surface_.hasLink(side)) continue;
      if (!view.isNear(a, b, entry.low, entry.high)) continue;
      const auto [first, last] = view.range(a, b, entry.low - view.touch);
      const double low = std::max(first, entry.low), high = std::min(last, entry.high);
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
        auto& [seenLow, seenHigh] = ranges_[number];
        if (!isNew && seenLow <= low && high <= seenHigh) continue;
        seenLow = std::min(seenLow, low);
        seenHigh = std::max(seenHigh, high);
        stack_.push_back({other, low, high});
      }
    }
  }

  const MarginSurface& surface_;
  Poll poll_;
  std::uint32_t visited_ = 0;
  std::vector<Entry> stack_;
  NumberedTable<Index> seen_;                  ///< sides that were entered
  std::vector<std::array<double, 2>> ranges_;  ///< ranges of each of them
  std::vector<Index> found_;                   ///< triangles
};

}  // namespace footfall::detail
