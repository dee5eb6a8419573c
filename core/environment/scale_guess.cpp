// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/scale_guess.hpp"

#include <algorithm>
#include <array>

namespace footfall::detail {
namespace {

// Limits in metres. Landscapes of games are up to a few hundred metres long, and their towers a few dozen high; a
// doll's house is no level.
constexpr double kLongest = 400, kHighest = 80, kShortest = 1;
constexpr double kLowest = 1.8;  // agents are as high
constexpr std::array kUsual = {1.0, 0.01, 0.001};

bool isPlausibleLength(const Vec3& size, double scale) {
  const double length = scale * std::max(size.x, size.y);
  return length >= kShortest && length <= kLongest;
}

bool isPlausible(const Vec3& size, double scale) {
  return isPlausibleLength(size, scale) && scale * size.z <= kHighest;
}

}  // namespace

std::optional<double> betterScale(const Vec3& size, double metresPerUnit) {
  if (isPlausible(size, metresPerUnit)) return std::nullopt;
  const auto other =
      std::ranges::find_if(kUsual, [&](double scale) { return isPlausible(size, scale) && size.z * scale >= kLowest; });
  return other == kUsual.end() ? std::nullopt : std::optional(*other);
}

bool isTooHigh(const Vec3& size, double metresPerUnit) {
  return isPlausibleLength(size, metresPerUnit) && metresPerUnit * size.z > kHighest;
}

}  // namespace footfall::detail
