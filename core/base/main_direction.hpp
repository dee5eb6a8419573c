// The direction in the plan that most edges of a level follow, for boxes that fit a level that somebody turned.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace footfall::detail {

/// Collects edges. What is found depends on the order of the edges, and saves time only.
class MainDirection {
 public:
  /// More edges add time and little else.
  static constexpr int kEnough = 1536;

  void add(double dx, double dy);

  /// A vector of about unit length along or across which many edges lie. Nothing when no direction is that common, or
  /// when as many edges follow the axes.
  [[nodiscard]] std::optional<std::array<double, 2>> find() const;

 private:
  /// Turned by quarters until x is positive and y is not negative.
  struct Edge {
    double x, y, length;
    int bin;
  };
  std::vector<Edge> edges_;
};

}  // namespace footfall::detail
