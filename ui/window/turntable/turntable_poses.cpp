// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/turntable/turntable_poses.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr double kSteepest = 80;  // degrees
constexpr double kFree = 0.06;    // of the picture, on each side

Vec3 middleOf(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Vec3 lower = points.front(), upper = points.front();
  for (const Vec3& p : points) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  return 0.5 * (lower + upper);
}

/// How far an eye must be from `middle` to have all points in sight.
double distanceFor(std::span<const Vec3> points, const Vec3& middle, const Sight& sight, const QSize& picture,
                   double field) {
  const double tall = std::tan(field / 2) * (1 - 2 * kFree);
  const double wide = tall * picture.width() / picture.height();
  const Vec3 ahead = directionOf(sight), up = directionOf({sight.turn, sight.pitch + 90}), right = cross(ahead, up);
  double distance = 0;
  for (const Vec3& point : points) {
    const Vec3 p = point - middle;
    const double aside = std::max(std::fabs(dot(p, right)) / wide, std::fabs(dot(p, up)) / tall);
    distance = std::max(distance, aside - dot(p, ahead));
  }
  return distance;
}

}  // namespace

std::vector<CameraPose> turntablePoses(std::span<const Vec3> points, const Sight& first, int frames,
                                       const QSize& picture, double field) {
  const Vec3 middle = middleOf(points);
  const auto sightAt = [&](int frame) {
    return Sight{first.turn + 360.0 * frame / frames, std::clamp(first.pitch, -kSteepest, kSteepest)};
  };
  // One distance for all frames: nothing grows and shrinks while it turns.
  double distance = 0;
  for (int i = 0; i < frames; ++i)
    distance = std::max(distance, distanceFor(points, middle, sightAt(i), picture, field));
  if (distance == 0) distance = 1;
  std::vector<CameraPose> poses;
  for (int i = 0; i < frames; ++i)
    poses.push_back(poseOfEye(middle - distance * directionOf(sightAt(i)), sightAt(i), distance));
  return poses;
}

}  // namespace footfall::ui
