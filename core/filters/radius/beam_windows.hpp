// Finds the parts of triangles that straight walks from an edge, or from a place, reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "core/base/numbered_table.hpp"
#include "core/filters/radius/margin_spread.hpp"

namespace footfall::detail {

/// The beams from `low` to `high` reach a triangle: all that lies on them there, as nothing stands inside of it.
struct BeamWindow {
  Index triangle = -1;
  double low = 0, high = 0;
};

/// Follows beams (`Beams` or `Rays`) from triangle to triangle, as Spread does, and keeps the gaps between them. What
/// may be reached is taken as reached.
class BeamTracer {
 public:
  /// Polls as it runs.
  BeamTracer(const MarginSurface& surface, const Poll& poll) : surface_(surface), poll_(poll) {}

  void start() {
    windows_.clear();
    seen_.clear();
    lastRange_.clear();
    ranges_.clear();
  }
  void enter(Index side, double low, double high) { stack_.push_back({side, low, high}); }
  template <class View>
  void run(const View& view) {
    while (!stack_.empty()) {
      if ((++visited_ & 255) == 0) poll_();
      const Entry entry = stack_.back();
      stack_.pop_back();
      visit(entry, view);
    }
  }
  /// Sorts by triangle, and then along; windows of one triangle that are at most `apart` apart become one.
  const std::vector<BeamWindow>& join(double apart) {
    const auto orderOf = [](const BeamWindow& w) { return std::tuple(w.triangle, w.low, w.high); };
    std::sort(windows_.begin(), windows_.end(),
              [&](const BeamWindow& a, const BeamWindow& b) { return orderOf(a) < orderOf(b); });
    std::size_t count = 0;
    for (const BeamWindow& window : windows_) {
      if (count > 0 && windows_[count - 1].triangle == window.triangle &&
          window.low <= windows_[count - 1].high + apart)
        windows_[count - 1].high = std::max(windows_[count - 1].high, window.high);
      else
        windows_[count++] = window;
    }
    windows_.resize(count);
    return windows_;
  }

 private:
  struct Entry {
    Index side = -1;
    double low = 0, high = 0;
  };

  template <class View>
  void visit(const Entry& entry, const View& view) {
    windows_.push_back({entry.side / 3, entry.low, entry.high});
    for (const Index side : {MarginSurface::nextSide(entry.side), MarginSurface::previousSide(entry.side)}) {
      if (surface_.isBorder(side)) continue;
      const PlanVector a = surface_.begin(side), b = surface_.end(side);
      const std::optional<Range> range = view.rangeIfNear(a, b, {entry.low, entry.high});
      if (!range) continue;
      const double low = std::max(range->low, entry.low), high = std::min(range->high, entry.high);
      if (low > high + view.touch) continue;
      const bool exits = view.exits(a, b);
      for (const Index other : surface_.beyond(side)) {
        if (exits && isNew(other, low, high, view.touch))
          stack_.push_back({other, low, high});
        else if (!exits && surface_.beginVertex(other) != surface_.endVertex(side))
          windows_.push_back({other / 3, low, high});  // borders of a link may be a rounding apart
      }
    }
  }

  bool isNew(Index side, double low, double high, double touch) {
    const auto [number, isFirst] = seen_.insert(side);
    if (isFirst) lastRange_.push_back(-1);
    Index& last = lastRange_[static_cast<std::size_t>(number)];
    for (Index i = last; i >= 0; i = ranges_[i].before)
      if (ranges_[i].low - touch <= low && high <= ranges_[i].high + touch) return false;
    ranges_.push_back({low, high, last});
    last = static_cast<Index>(ranges_.size()) - 1;
    return true;
  }

  /// A range in which a side was entered.
  struct EnteredRange {
    double low = 0, high = 0;
    Index before = -1;  ///< the range of the same side before it
  };

  const MarginSurface& surface_;
  Poll poll_;
  std::uint32_t visited_ = 0;
  std::vector<Entry> stack_;
  NumberedTable<Index> seen_;     ///< sides that were entered
  std::vector<Index> lastRange_;  ///< of each of them, in ranges_
  std::vector<EnteredRange> ranges_;
  std::vector<BeamWindow> windows_;
};

}  // namespace footfall::detail
