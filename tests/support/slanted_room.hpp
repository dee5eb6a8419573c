// A convex room whose long sides are straight rows of edges with rounded ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "footfall/navigation_mesh.hpp"

namespace footfall::test {

/// A parallelogram in the plan: two sides stand along y, and two are rows of edges along a slope that doubles do not
/// have. Its triangles are long and thin.
class SlantedRoom {
 public:
  SlantedRoom(std::size_t columns, std::mt19937& random) : slope_(0), base_(0), height_(0), middle_(0) {
    // Distributions of the standard library differ between its implementations.
    const auto number = [&random](std::uint32_t least, std::uint32_t most) {
      return static_cast<double>(least + random() % (most - least + 1));
    };
    constexpr double kSlopes[] = {-0.5, -1.0 / 3, 0.25, -0.7, 1.1};
    x_.push_back(0);
    while (x_.size() < columns) x_.push_back(x_.back() + number(1, 60) / 15);
    slope_ = kSlopes[random() % 5];
    height_ = number(5, 64);
    middle_ = height_ * number(1, 8) / 9;
    base_ = -number(0, 299);
  }

  [[nodiscard]] NavigationMesh mesh() const {
    NavigationMesh mesh;
    for (const double above : {0.0, middle_, height_})
      for (const double x : x_) mesh.vertices.push_back({x, slope_ * x + base_ + above, 0});
    const auto columns = static_cast<std::uint32_t>(x_.size());
    for (std::uint32_t row = 0; row < 2; ++row)
      for (std::uint32_t i = 0; i + 1 < columns; ++i) {
        const std::uint32_t below = row * columns + i, above = below + columns;
        mesh.triangles.push_back({below, below + 1, above + 1});
        mesh.triangles.push_back({below, above + 1, above});
      }
    return mesh;
  }

  /// A place by its shares of the width and the height.
  [[nodiscard]] Vec3 at(double across, double up) const {
    const double x = across * x_.back();
    return {x, slope_ * x + base_ + up * height_, 0};
  }

 private:
  std::vector<double> x_;
  double slope_, base_, height_, middle_;
};

}  // namespace footfall::test
