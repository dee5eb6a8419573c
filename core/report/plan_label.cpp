// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_label.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace footfall::detail {
namespace {

constexpr int kMostSquares = 4000;  // a label is worth no more

double squaredDistance(const SheetPoint& p, const SheetPoint& a, const SheetPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double f = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  const double x = p.x - a.x - f * dx, y = p.y - a.y - f * dy;
  return x * x + y * y;
}

/// The distance to the outline; negative outside.
double depthAt(std::span<const std::vector<SheetPoint>> rings, const SheetPoint& p) {
  bool isInside = false;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<SheetPoint>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const SheetPoint &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isInside = !isInside;
      least = std::min(least, squaredDistance(p, a, b));
    }
  }
  return isInside ? std::sqrt(least) : -std::sqrt(least);
}

struct Square {
  SheetPoint middle;
  double half = 0, depth = 0;
  [[nodiscard]] double most() const { return depth + half * std::sqrt(2.0); }
  bool operator<(const Square& o) const {
    return std::tuple(most(), middle.x, middle.y) < std::tuple(o.most(), o.middle.x, o.middle.y);
  }
};

}  // namespace

RoomiestPlace findRoomiestPlace(std::span<const std::vector<SheetPoint>> rings, double precision, Poll poll) {
  RoomiestPlace best;
  if (rings.empty() || rings.front().empty()) return best;
  SheetPoint lower = rings.front().front(), upper = lower;
  for (const SheetPoint& p : rings.front()) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
  }
  best.at = lower;
  std::priority_queue<Square> open;
  const auto add = [&](const SheetPoint& middle, double half) {
    const Square square{middle, half, depthAt(rings, middle)};
    if (square.depth > best.radius) best = {middle, square.depth};
    open.push(square);
  };
  const double size = std::max({upper.x - lower.x, upper.y - lower.y, precision});
  add({(lower.x + upper.x) / 2, (lower.y + upper.y) / 2}, size / 2);
  for (int i = 0; i < kMostSquares && !open.empty(); ++i) {
    const Square square = open.top();
    open.pop();
    if (square.most() <= best.radius + precision) break;
    poll();
    const double half = square.half / 2;
    for (const double x : {-half, half})
      for (const double y : {-half, half}) add({square.middle.x + x, square.middle.y + y}, half);
  }
  return best;
}

}  // namespace footfall::detail
