// Building small environments by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::test {

/// A triangle soup that grows. Every triangle has its own vertices unless stated otherwise, as in real files.
class Soup {
 public:
  Soup& triangle(const Vec3& a, const Vec3& b, const Vec3& c);
  /// Two triangles (a, b, c) and (a, c, d).
  Soup& quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  /// A horizontal rectangle that faces up.
  Soup& floor(double x0, double y0, double x1, double y1, double z);
  /// The same, facing down.
  Soup& ceiling(double x0, double y0, double x1, double y1, double z);
  /// A vertical rectangle above the plan segment.
  Soup& wall(double x0, double y0, double x1, double y1, double z0, double z1);
  /// A rectangle that faces up and rises along x from z0 at x0 to z1 at x1.
  Soup& ramp(double x0, double y0, double x1, double y1, double z0, double z1);
  /// Six closed sides that face out.
  Soup& box(const Vec3& lower, const Vec3& upper);
  Soup& add(const Soup& other);

  /// The same with each vertex replaced.
  [[nodiscard]] Soup mapped(const std::function<Vec3(const Vec3&)>& map) const;

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  [[nodiscard]] const std::vector<std::array<Vec3, 3>>& triangles() const { return triangles_; }
  /// Z up; vertices are not shared.
  [[nodiscard]] std::shared_ptr<Environment> environment(bool bothSides = false) const;

 private:
  std::vector<std::array<Vec3, 3>> triangles_;
};

/// The environment with triangles (and with them their vertices) in another order and each triangle starting at
/// another corner. `order[i]` is the old index of the new triangle i.
std::shared_ptr<Environment> shuffled(const Environment& environment, const std::vector<std::uint32_t>& order,
                                      std::uint32_t turn);

/// C++ like text of a soup, to copy into a test.
std::string toText(const Environment& environment);

}  // namespace footfall::test
