// Windows of the clearance field: stretches of an edge, and the border feature whose distance holds there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/field_surface.hpp"

namespace footfall::detail {

/// A piece of the border: an edge, or a corner. Its numbers are the geometry that distances need.
struct FieldFeature {
  FieldVector place;       ///< the corner, or where the edge begins
  FieldVector along;       ///< an edge's direction, with the walkable side on its left
  FieldVector inward;      ///< an edge's normal
  double length = -1;      ///< of an edge; negative for a corner
  std::uint32_t face = 0;  ///< an edge's face, or one at the corner
  std::uint8_t side = 0;   ///< an edge's side of it, or the corner

  [[nodiscard]] bool isCorner() const { return length < 0; }
  /// Its point that is nearest to `p` in the plan.
  [[nodiscard]] FieldVector nearestTo(FieldVector p) const;
};

/// The distance to a feature from `lo` to `hi` along an edge is `offset` + `slope` s (an edge), or the root of (s -
/// `offset`) squared + `slope` (a corner).
struct FieldWindow {
  static constexpr std::uint8_t kNowhere = 2;

  double lo = 0, hi = 0, offset = 0, slope = 0;
  std::uint32_t feature = 0;
  std::uint8_t into = kNowhere;  ///< which face of the edge its rays go into
  bool isCorner = false;
  bool isFresh = false;  ///< its rays were not followed yet

  [[nodiscard]] double distance(double s) const {
    if (!isCorner) return offset + slope * s;
    return std::sqrt((s - offset) * (s - offset) + slope);
  }
};

/// The distances of a feature along an edge, without limits.
FieldWindow windowOf(const FieldFeature& feature, std::uint32_t number, const FieldEdge& edge);

/// Stretches along an edge, ascending.
using FieldStretches = std::vector<std::array<double, 2>>;

/// The stretches of [lo, hi], two at most, in which `a` is proven to be farther than `b`: by `margin` up to rounding,
/// by a quarter of it at the ends, where that is looked at. Returns how many.
int fartherStretches(const FieldWindow& a, const FieldWindow& b, double margin, double lo, double hi,
                     std::array<std::array<double, 2>, 2>& stretches);

/// The places, up to two, where the distances of two windows are equal, ignoring their limits. Returns their number.
int equalPlaces(const FieldWindow& a, const FieldWindow& b, std::array<double, 2>& places);

/// Takes [lo, hi] out of stretches.
void takeOut(FieldStretches& stretches, double lo, double hi);

/// Adds a window to those of an edge where none is nearer by `margin`, and takes out of the others where it is. What it
/// adds is fresh, unless it goes nowhere. Returns whether something fresh came.
bool addWindow(std::vector<FieldWindow>& windows, const FieldWindow& window, double margin);

/// The windows of one edge, each without the parts where another one is nearer by `margin`; in the order of `lo` and of
/// the feature.
std::vector<FieldWindow> nearestWindows(const std::vector<FieldWindow>& windows, double margin);

}  // namespace footfall::detail
