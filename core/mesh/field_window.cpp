// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/field_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace footfall::detail {
namespace {

using TwoStretches = std::array<std::array<double, 2>, 2>;

/// The stretches where a linear function is above 0.
int aboveZero(double atLo, double slope, double lo, double hi, TwoStretches& stretches) {
  const double atHi = atLo + slope * (hi - lo);
  if (atLo <= 0 && atHi <= 0) return 0;
  stretches[0] = {lo, hi};
  if (atLo > 0 && atHi > 0) return 1;
  const double root = lo + (hi - lo) * (atLo / (atLo - atHi));
  stretches[0][atLo > 0 ? 1 : 0] = root;
  return 1;
}

/// The least of corner - edge, which is convex, lies there.
double leastExcess(const FieldWindow& corner, const FieldWindow& edge) {
  const double rest = 1 - edge.slope * edge.slope;
  if (rest <= 0)
    return edge.slope > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  return corner.offset + edge.slope * std::sqrt(corner.slope / rest);
}

/// The interval in which the corner is nearer than the line (offset + slope s), relative to `lo`, by a quadratic
/// equation. Empty, as {1, 0}, where there is none.
std::array<double, 2> nearerThanLine(const FieldWindow& corner, double line, double slope, double lo) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double at = corner.offset - lo, start = line + slope * lo;
  const double a = 1 - slope * slope, b = -(at + start * slope), c = at * at + corner.slope - start * start;
  if (a < 1e-13) {
    if (b == 0) return c < 0 ? std::array{-kInfinity, kInfinity} : std::array{1.0, 0.0};
    const double root = -c / (2 * b);
    return b > 0 ? std::array{-kInfinity, root} : std::array{root, kInfinity};
  }
  const double disc = b * b - a * c;
  if (disc <= 0) return {1, 0};
  const double root = b > 0 ? -(b + std::sqrt(disc)) : -(b - std::sqrt(disc));
  std::array<double, 2> roots{root / a, root != 0 ? c / root : 0};
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return roots;
}

/// `a` is a corner, `b` an edge: a - b is convex, so what is taken lies beyond both of its roots.
int cornerBeyondEdge(const FieldWindow& a, const FieldWindow& b, double margin, double lo, double hi,
                     TwoStretches& stretches) {
  const auto excess = [&](double s) { return a.distance(s) - b.distance(s); };
  auto roots = nearerThanLine(a, b.offset + margin, b.slope, lo);
  const double least = std::clamp(leastExcess(a, b), lo, hi);
  if (roots[0] > roots[1]) {
    stretches[0] = {lo, hi};
    return excess(least) >= margin / 4 ? 1 : 0;
  }
  int count = 0;
  const double left = lo + roots[0], right = lo + roots[1];
  if (left > lo && excess(std::min(left, hi)) >= margin / 4 && (left <= least || excess(least) >= margin / 4))
    stretches[count++] = {lo, std::min(left, hi)};
  if (right < hi && excess(std::max(right, lo)) >= margin / 4 && (right >= least || excess(least) >= margin / 4))
    stretches[count++] = {std::max(right, lo), hi};
  return count;
}

/// `a` is an edge, `b` a corner: b - a is convex, so between two places where it is below 0 it is so everywhere.
int edgeBeyondCorner(const FieldWindow& a, const FieldWindow& b, double margin, double lo, double hi,
                     TwoStretches& stretches) {
  const auto roots = nearerThanLine(b, a.offset - margin, a.slope, lo);
  if (roots[0] > roots[1]) return 0;
  const double left = std::max(lo, lo + roots[0]), right = std::min(hi, lo + roots[1]);
  if (left >= right || a.distance(left) - b.distance(left) < margin / 4 ||
      a.distance(right) - b.distance(right) < margin / 4)
    return 0;
  stretches[0] = {left, right};
  return 1;
}

/// Takes out of `window` what another one is nearer at, where that lies in [lo, hi].
void takeNearer(const FieldWindow& window, const FieldWindow& other, double margin, double lo, double hi,
                FieldStretches& left) {
  lo = std::max({lo, window.lo, other.lo});
  hi = std::min({hi, window.hi, other.hi});
  if (lo > hi) return;
  TwoStretches taken;
  const int count = fartherStretches(window, other, margin, lo, hi, taken);
  for (int i = 0; i < count; ++i) takeOut(left, taken[i][0], taken[i][1]);
}

}  // namespace

FieldVector FieldFeature::nearestTo(FieldVector p) const {
  return isCorner() ? place : place + along * std::clamp(dot(p - place, along), 0.0, length);
}

FieldWindow windowOf(const FieldFeature& feature, std::uint32_t number, const FieldEdge& edge) {
  FieldWindow window;
  window.feature = number;
  window.isCorner = feature.isCorner();
  if (window.isCorner) {
    const FieldVector way = feature.place - edge.begin;
    window.offset = dot(way, edge.along);
    const double aside = cross(edge.along, way);
    window.slope = aside * aside;
  } else {
    window.offset = dot(edge.begin - feature.place, feature.inward);
    window.slope = dot(edge.along, feature.inward);
  }
  return window;
}

int fartherStretches(const FieldWindow& a, const FieldWindow& b, double margin, double lo, double hi,
                     std::array<std::array<double, 2>, 2>& stretches) {
  if (!a.isCorner && !b.isCorner)
    return aboveZero(a.distance(lo) - b.distance(lo) - margin, a.slope - b.slope, lo, hi, stretches);
  if (a.isCorner && b.isCorner) {
    // Squares differ by a linear function. Their difference exceeds margin * (a + b) wherever a exceeds b by margin.
    const double most = std::max(b.distance(lo), b.distance(hi));
    const double atLo = (b.offset - a.offset) * (2 * lo - a.offset - b.offset) + (a.slope - b.slope);
    return aboveZero(atLo - margin * (2 * most + margin), 2 * (b.offset - a.offset), lo, hi, stretches);
  }
  return a.isCorner ? cornerBeyondEdge(a, b, margin, lo, hi, stretches)
                    : edgeBeyondCorner(a, b, margin, lo, hi, stretches);
}

int equalPlaces(const FieldWindow& a, const FieldWindow& b, std::array<double, 2>& places) {
  if (a.isCorner != b.isCorner) {
    const FieldWindow &corner = a.isCorner ? a : b, &edge = a.isCorner ? b : a;
    const auto roots = nearerThanLine(corner, edge.offset, edge.slope, 0);
    if (roots[0] > roots[1]) return 0;
    int count = 0;
    for (const double root : roots)
      if (std::isfinite(root)) places[count++] = root;
    return count;
  }
  const double slope = a.isCorner ? 2 * (b.offset - a.offset) : a.slope - b.slope;
  const double start =
      a.isCorner ? (a.offset - b.offset) * (a.offset + b.offset) + (a.slope - b.slope) : a.offset - b.offset;
  if (slope == 0) return 0;
  places[0] = -start / slope;
  return std::isfinite(places[0]) ? 1 : 0;
}

void takeOut(FieldStretches& stretches, double lo, double hi) {
  if (lo >= hi) return;
  for (std::size_t i = 0; i < stretches.size();) {
    auto& s = stretches[i];
    if (s[1] < lo || s[0] > hi) {
      ++i;
    } else if (s[0] < lo && s[1] > hi) {
      const std::array<double, 2> rest{hi, s[1]};
      s[1] = lo;
      stretches.insert(stretches.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
      i += 2;
    } else if (s[0] < lo) {
      s[1] = lo;
      ++i;
    } else if (s[1] > hi) {
      s[0] = hi;
      ++i;
    } else {
      stretches.erase(stretches.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

bool addWindow(std::vector<FieldWindow>& windows, const FieldWindow& window, double margin) {
  thread_local FieldStretches mine, left;
  mine.assign(1, {window.lo, window.hi});
  for (const FieldWindow& other : windows) {
    if (other.feature == window.feature) {
      if (other.into == window.into) takeOut(mine, other.lo, other.hi);
    } else {
      takeNearer(window, other, margin, window.lo, window.hi, mine);
    }
    if (mine.empty()) return false;
  }
  const std::size_t count = windows.size();
  for (std::size_t i = 0; i < count; ++i) {
    FieldWindow& other = windows[i];
    if (other.feature == window.feature || other.hi < mine.front()[0] || other.lo > mine.back()[1]) continue;
    left.assign(1, {other.lo, other.hi});
    for (const auto& stretch : mine) takeNearer(other, window, margin, stretch[0], stretch[1], left);
    if (left.empty()) {
      other.hi = -std::numeric_limits<double>::infinity();
      continue;
    }
    FieldWindow more = other;
    std::tie(other.lo, other.hi) = std::tie(left[0][0], left[0][1]);
    for (std::size_t k = 1; k < left.size(); ++k) {
      std::tie(more.lo, more.hi) = std::tie(left[k][0], left[k][1]);
      windows.push_back(more);
    }
  }
  windows.erase(std::remove_if(windows.begin(), windows.end(), [](const FieldWindow& w) { return w.hi < w.lo; }),
                windows.end());
  for (const auto& stretch : mine) {
    windows.push_back(window);
    std::tie(windows.back().lo, windows.back().hi) = std::tie(stretch[0], stretch[1]);
    windows.back().isFresh = window.into != FieldWindow::kNowhere;
  }
  return window.into != FieldWindow::kNowhere;
}

std::vector<FieldWindow> nearestWindows(const std::vector<FieldWindow>& windows, double margin) {
  if (windows.size() <= 1) return windows;
  std::vector<FieldWindow> nearest;
  nearest.reserve(windows.size());
  thread_local FieldStretches left;
  for (const FieldWindow& window : windows) {
    left.assign(1, {window.lo, window.hi});
    for (const FieldWindow& other : windows)
      if (other.feature != window.feature) takeNearer(window, other, margin, window.lo, window.hi, left);
    for (const auto& stretch : left) {
      nearest.push_back(window);
      std::tie(nearest.back().lo, nearest.back().hi) = std::tie(stretch[0], stretch[1]);
    }
  }
  std::sort(nearest.begin(), nearest.end(), [](const FieldWindow& a, const FieldWindow& b) {
    return std::tie(a.lo, a.feature, a.into, a.hi) < std::tie(b.lo, b.feature, b.into, b.hi);
  });
  return nearest;
}

}  // namespace footfall::detail
