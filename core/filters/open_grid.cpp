// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/open_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/exact/face_geometry.hpp"

namespace footfall::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastRise = 0x1p-1000;  ///< least rise of an edge whose quotients are numbers

struct Interval {
  double low = kInfinity, high = -kInfinity;
  void include(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

}  // namespace

/// A triangle cut at heights.
class Slices {
 public:
  explicit Slices(const OpenGrid::Outline& outline) : corners_(outline) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const ApproximatePoint &a = corners_[k], &b = corners_[(k + 1) % 3];
      error_ = std::max(error_, a.error);
      largest = std::max({largest, std::fabs(a.x), std::fabs(a.y)});
      widths_.include(a.x, a.x);
      heights_.include(a.y, a.y);
      const bool isLevel = std::fabs(b.y - a.y) < kLeastRise;
      perHeight_[k] = isLevel ? 0 : 1 / (b.y - a.y);
      margins_[k] = a.x == b.x ? 0 : isLevel ? kInfinity : (std::fabs(a.x) + std::fabs(b.x)) * 0x1p-49;
    }
    if (error_ > 0) error_ += largest * 0x1p-50;  // adding and subtracting it is rounded, too
  }

  [[nodiscard]] double lowest() const { return heights_.low - error_; }
  [[nodiscard]] double highest() const { return heights_.high + error_; }
  [[nodiscard]] double leftmost() const { return widths_.low - error_; }
  [[nodiscard]] double rightmost() const { return widths_.high + error_; }

  /// The interval contains the true triangle between two heights.
  [[nodiscard]] Interval around(double low, double high) const {
    Interval result;
    low -= error_, high += error_;
    for (const ApproximatePoint& p : corners_)
      if (p.y >= low && p.y <= high) result.include(p.x, p.x);
    for (const double y : {low, high})
      for (std::size_t k = 0; k < 3; ++k)
        if (passes(k, y)) result.include(at(k, y) - margins_[k], at(k, y) + margins_[k]);
    return {result.low - error_, result.high + error_};
  }

  /// The places at which the sides pass a height. All between the two, taken in by the margins, lies inside there.
  [[nodiscard]] Interval insideAt(double y) const {
    Interval result;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!passes(k, y)) continue;
      const double x = at(k, y);
      result.low = std::min(result.low, x + margins_[k]);
      result.high = std::max(result.high, x - margins_[k]);
    }
    return result;
  }
  /// The heights between which a row lies, as insideAt() has to be asked for inside().
  [[nodiscard]] double below(double low) const { return low - error_; }
  [[nodiscard]] double above(double high) const { return high + error_; }
  /// True when both are the same numbers.
  [[nodiscard]] bool isExact() const { return error_ == 0; }
  /// False: nothing between the heights below(low) and above(high) of a row is certain to lie inside.
  [[nodiscard]] bool holds(double below, double above) const {
    return !(below < heights_.low || above > heights_.high);
  }
  /// All between these two and between two heights, of which insideAt() is given, lies in the true triangle.
  [[nodiscard]] Interval inside(const Interval& below, const Interval& above) const {
    // The left side is convex and the right one concave, so that the ends of the slice are the narrowest.
    const double left = std::max(below.low, above.low), right = std::min(below.high, above.high);
    return {left + error_, right - error_};
  }

 private:
  [[nodiscard]] bool passes(std::size_t k, double y) const {
    const double a = corners_[k].y, b = corners_[(k + 1) % 3].y;
    return a != b && (a <= y || b <= y) && (a >= y || b >= y);
  }
  [[nodiscard]] double at(std::size_t k, double y) const {
    const ApproximatePoint &a = corners_[k], &b = corners_[(k + 1) % 3];
    return a.x + (y - a.y) * perHeight_[k] * (b.x - a.x);
  }

  OpenGrid::Outline corners_;
  std::array<double, 3> perHeight_{}, margins_{};  ///< slope and margin of the edge from each corner
  double error_ = 0;
  Interval widths_, heights_;
};

namespace {

/// True when an edge of the first triangle certainly has the second one on its outer side.
bool isBeside(const OpenGrid::Outline& triangle, const OpenGrid::Outline& other, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const ApproximatePoint &a = triangle[k], &b = triangle[(k + 1) % 3];
    const MaybeSign inner = filteredOrientation(a, b, triangle[(k + 2) % 3], slack);
    if (inner && std::all_of(other.begin(), other.end(),
                             [&](const ApproximatePoint& p) { return filteredOrientation(a, b, p, slack) == -*inner; }))
      return true;
  }
  return false;
}

}  // namespace

OpenGrid::OpenGrid(const PlanKernel& kernel, Index triangle) : slack_(kernel.sign().slack) {
  const Outline face = outlineInPlan(kernel, triangle, kernel.mesh().triangles[triangle][0]);
  // The true face lies within, too.
  const Slices whole(face);
  const Interval columns{whole.leftmost(), whole.rightmost()}, rows{whole.lowest(), whole.highest()};
  const auto divide = [](const Interval& range, std::array<double, kSquares + 1>& borders) {
    for (std::size_t i = 0; i <= kSquares; ++i) {
      const double share = static_cast<double>(i) / kSquares;
      borders[i] = range.low * (1 - share) + range.high * share;
    }
    std::sort(borders.begin(), borders.end());  // rounding may swap those of a face without width
    borders.front() = range.low;
    borders.back() = range.high;
    return range.high - range.low > kLeastRise ? kSquares / (range.high - range.low) : 0;
  };
  columnsPerUnit_ = divide(columns, x_);
  rowsPerUnit_ = divide(rows, y_);
  open(face);
}

OpenGrid::Row OpenGrid::columnsMeeting(double low, double high) const {
  if (!(low <= high) || high < x_.front() || low > x_.back()) return 0;
  // The square by arithmetic, then by the borders as they are.
  const auto squareAt = [&](double x) {
    const double c = std::clamp((x - x_.front()) * columnsPerUnit_, 0.0, static_cast<double>(kSquares - 1));
    return static_cast<std::size_t>(c);
  };
  std::size_t first = squareAt(low), last = squareAt(high);
  while (first > 0 && x_[first] >= low) --first;
  while (first + 1 < kSquares && x_[first + 1] < low) ++first;
  while (last + 1 < kSquares && x_[last + 1] <= high) ++last;
  while (last > 0 && x_[last] > high) --last;
  return (~Row{0} << first) & (~Row{0} >> (kSquares - 1 - last));
}

OpenGrid::Row OpenGrid::columnsWithin(double low, double high) const {
  if (!(low <= high) || high < x_.front() || low > x_.back()) return 0;
  // The first border that is not below `low`, and the last one that is not above `high`.
  const auto borderAt = [&](double x) {
    const double b = std::clamp((x - x_.front()) * columnsPerUnit_, 0.0, static_cast<double>(kSquares));
    return static_cast<std::size_t>(b);
  };
  std::size_t first = borderAt(low), last = borderAt(high);
  while (first > 0 && x_[first - 1] >= low) --first;
  while (first < kSquares && x_[first] < low) ++first;
  while (last < kSquares && x_[last + 1] <= high) ++last;
  while (last > 0 && x_[last] > high) --last;
  if (first >= last) return 0;
  return (~Row{0} << first) & (~Row{0} >> (kSquares - last));
}

template <class Visit>
bool OpenGrid::visitRows(double low, double high, const Visit& visit) const {
  if (high < y_.front() || low > y_.back()) return false;
  const double share = std::clamp((low - y_.front()) * rowsPerUnit_, 0.0, static_cast<double>(kSquares - 1));
  auto row = static_cast<std::size_t>(share);
  while (row > 0 && y_[row] >= low) --row;
  for (; row < kSquares && y_[row] <= high; ++row)
    if (visit(row)) return true;
  return false;
}

OpenGrid::Row OpenGrid::squaresMet(const Slices& triangle, std::size_t row) const {
  const Interval around = triangle.around(y_[row], y_[row + 1]);
  return columnsMeeting(around.low, around.high);
}

void OpenGrid::close() {
  open_.fill(0);
  openColumns_ = 0;
  opened_.clear();
  areAllListed_ = true;
}

void OpenGrid::open(const Outline& outline) {
  constexpr std::size_t kMostListed = 64;
  areAllListed_ = areAllListed_ && opened_.size() < kMostListed;
  if (areAllListed_) opened_.push_back(outline);
  const Slices triangle(outline);
  visitRows(triangle.lowest(), triangle.highest(), [&](std::size_t row) {
    open_[row] |= squaresMet(triangle, row);
    openColumns_ |= open_[row];
    return false;
  });
}

void OpenGrid::cover(const Outline& outline) {
  if (!mayMeet(outline)) return;
  const Slices triangle(outline);
  const Row columns = columnsMeeting(triangle.leftmost(), triangle.rightmost());
  constexpr std::size_t kNone = kSquares;
  std::size_t known = kNone;  // the row that begins where `upper` is known
  Interval upper;
  visitRows(triangle.lowest(), triangle.highest(), [&](std::size_t row) {
    const double below = triangle.below(y_[row]), above = triangle.above(y_[row + 1]);
    if ((open_[row] & columns) == 0 || !triangle.holds(below, above)) return false;
    const Interval lower = known == row ? upper : triangle.insideAt(below);
    upper = triangle.insideAt(above);
    known = triangle.isExact() ? row + 1 : kNone;
    const Interval inside = triangle.inside(lower, upper);
    open_[row] &= ~columnsWithin(inside.low, inside.high);
    return false;
  });
  openColumns_ = std::accumulate(open_.begin(), open_.end(), Row{0}, std::bit_or<>());
}

bool OpenGrid::mayReach(const Outline& outline) const {
  if (!mayMeet(outline)) return false;
  const Slices triangle(outline);
  const Row columns = columnsMeeting(triangle.leftmost(), triangle.rightmost());
  const auto meetsSquare = [&](std::size_t row) {
    return (open_[row] & columns) != 0 && (open_[row] & squaresMet(triangle, row)) != 0;
  };
  if (!visitRows(triangle.lowest(), triangle.highest(), meetsSquare)) return false;
  return !areAllListed_ || std::any_of(opened_.begin(), opened_.end(), [&](const Outline& opened) {
    return !isBeside(opened, outline, slack_) && !isBeside(outline, opened, slack_);
  });
}

// A test by boxes; it removes most of a crowd.
bool OpenGrid::mayMeet(const Outline& outline) const {
  Interval columns, rows;
  double error = 0, largest = 0;
  for (const ApproximatePoint& p : outline) {
    columns.include(p.x, p.x);
    rows.include(p.y, p.y);
    error = std::max(error, p.error);
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  if (error > 0) error += largest * 0x1p-50;
  const Row met = columnsMeeting(columns.low - error, columns.high + error);
  return (met & openColumns_) != 0 &&
         visitRows(rows.low - error, rows.high + error, [&](std::size_t row) { return (open_[row] & met) != 0; });
}

bool OpenGrid::isClosed() const {
  return std::all_of(open_.begin(), open_.end(), [](Row row) { return row == 0; });
}

OpenGrid::Outline outlineInPlan(const PlanKernel& kernel, Index triangle, Index origin) {
  const SourceMesh& mesh = kernel.mesh();
  const auto at = [&](Index v) { return kernel.approximateSource(mesh.planIds[v], origin); };
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {at(a), at(b), at(c)};
}

}  // namespace footfall::detail
