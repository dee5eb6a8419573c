// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/line_crowds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace footfall::ui {
namespace {

constexpr std::size_t kFew = 64;  // fewer lines do not fill a picture
constexpr float kSquares = 256;   // grid squares along the largest extent
// height of a band in grid squares: lines at other heights, but not far above each other, form one crowd
constexpr float kBand = 32;

using Point = std::array<float, 3>;

float lengthOf(const LineSegment& line) {
  return std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1], line.to[2] - line.from[2]);
}

/// Lines in the squares of a grid over the plan, in bands of height.
class CrowdGrid {
 public:
  explicit CrowdGrid(const std::vector<LineSegment>& lines) {
    Point upper = lines.front().from;
    lower_ = upper;
    for (const LineSegment& line : lines)
      for (const Point& p : {line.from, line.to})
        for (std::size_t axis = 0; axis < 3; ++axis) {
          lower_[axis] = std::min(lower_[axis], p[axis]);
          upper[axis] = std::max(upper[axis], p[axis]);
        }
    side_ = std::max({upper[0] - lower_[0], upper[1] - lower_[1], upper[2] - lower_[2]}) / kSquares;
    if (!(side_ > 0) || !std::isfinite(side_)) return;
    band_ = kBand * side_;
    for (std::size_t axis = 0; axis < 3; ++axis)
      counts_[axis] = static_cast<int>((upper[axis] - lower_[axis]) / (axis < 2 ? side_ : band_)) + 1;
    sums_.resize(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2]);
    for (const LineSegment& line : lines) add(line);
  }

  [[nodiscard]] std::array<float, 2> crowdOf(const LineSegment& line) const {
    if (sums_.empty()) return {};
    Sum sum;
    const int samples = samplesOf(line);
    forSamples(line, samples, [&](const std::array<int, 3>& at) { addAround(at, sum); });
    // The line itself contributes one line through the whole neighbourhood, plus the error of the grid; if there is no
    // more, it is alone.
    const float own = static_cast<float>(samples) * kAround * side_;
    const float share = std::clamp(2 * (sum.length / own - 1.25F), 0.0F, 1.0F);
    const float area = own * kAround * side_;
    return {share * sum.length / area, share * sum.number / area};
  }

 private:
  struct Sum {
    float length = 0, number = 0;
  };
  static constexpr float kAround = 3;  // squares in either direction

  [[nodiscard]] int samplesOf(const LineSegment& line) const { return static_cast<int>(lengthOf(line) / side_) + 1; }
  template <typename Visit>
  void forSamples(const LineSegment& line, int samples, Visit visit) const {
    for (int i = 0; i < samples; ++i) {
      const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(samples);
      std::array<int, 3> at{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float place = line.from[axis] + t * (line.to[axis] - line.from[axis]) - lower_[axis];
        at[axis] = std::clamp(static_cast<int>(place / (axis < 2 ? side_ : band_)), 0, counts_[axis] - 1);
      }
      visit(at);
    }
  }
  [[nodiscard]] std::size_t indexOf(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * counts_[1] + y) * counts_[0] + x;
  }
  void add(const LineSegment& line) {
    const int samples = samplesOf(line);
    const float part = lengthOf(line) / static_cast<float>(samples);
    forSamples(line, samples, [&](const std::array<int, 3>& at) {
      Sum& sum = sums_[indexOf(at[0], at[1], at[2])];
      sum.length += part;
      sum.number += 1 / static_cast<float>(samples);
    });
  }
  void addAround(const std::array<int, 3>& at, Sum& sum) const {
    for (int y = std::max(at[1] - 1, 0); y <= std::min(at[1] + 1, counts_[1] - 1); ++y)
      for (int x = std::max(at[0] - 1, 0); x <= std::min(at[0] + 1, counts_[0] - 1); ++x) {
        const Sum& square = sums_[indexOf(x, y, at[2])];
        sum.length += square.length;
        sum.number += square.number;
      }
  }

  Point lower_{};
  float side_ = 0, band_ = 0;
  std::array<int, 3> counts_{};
  std::vector<Sum> sums_;
};

}  // namespace

void setCrowds(std::vector<LineSegment>& lines) {
  if (lines.size() < kFew) return;
  const CrowdGrid grid(lines);
  for (LineSegment& line : lines) line.crowd = grid.crowdOf(line);
}

}  // namespace footfall::ui
