// When a walker is where on a path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "footfall/path.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

inline constexpr double kGravity = 9.81;  ///< metres a second, each second

/// A path with times. Slopes, steps and gaps are walked at one speed along their length in space, heights of steps
/// included; drops are fallen under gravity, and take no less than their width takes to walk.
class WalkTrack {
 public:
  WalkTrack() = default;
  /// `speed` is in metres a second, above 0.
  WalkTrack(const PathResult& path, double metresPerUnit, double speed);

  [[nodiscard]] bool isEmpty() const { return points_.empty(); }
  /// The time from the start to the end; 0 where both are one place.
  [[nodiscard]] double seconds() const { return times_.empty() ? 0 : times_.back(); }

  /// Where the walker's feet are, after so many seconds (clamped). The track must not be empty.
  [[nodiscard]] Vec3 feetAt(double seconds) const;
  [[nodiscard]] bool isFallingAt(double seconds) const;
  /// Where the walker looks, in degrees from X towards Y: the way from a moment before to a moment later, so that it
  /// turns in corners and does not jump.
  [[nodiscard]] double turnAt(double seconds) const;
  /// The height of the feet, averaged over a moment, so that eyes do not jolt on stairs.
  [[nodiscard]] double smoothHeightAt(double seconds) const;

 private:
  [[nodiscard]] std::size_t pieceAt(double seconds) const;

  std::vector<Vec3> points_;
  std::vector<double> times_;  ///< arrival at each point
  std::vector<bool> isDrop_;   ///< of each piece
};

/// The time that a path takes at a speed in metres a second.
double walkSeconds(const PathResult& path, double metresPerUnit, double speed);

}  // namespace footfall::ui
