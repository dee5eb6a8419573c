// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walk_track.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"

namespace footfall::ui {
namespace {

constexpr double kLooksBack = 0.25;  // seconds of the way that say where the walker looks
constexpr double kLooksAhead = 0.5;  // the same, to come
constexpr double kSmoothing = 0.15;  // seconds to each side over which heights are averaged
constexpr int kSamples = 4;          // heights to each side

}  // namespace

WalkTrack::WalkTrack(const PathResult& path, double metresPerUnit, double speed) : points_(path.points) {
  isDrop_.assign(points_.empty() ? 0 : points_.size() - 1, false);
  for (const std::size_t piece : path.drops) isDrop_[piece] = true;
  double time = 0;
  if (!points_.empty()) times_.push_back(time);
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Vec3 way = points_[i + 1] - points_[i];
    if (isDrop_[i]) {
      time += std::max(std::sqrt(2 * std::fabs(way.z) * metresPerUnit / kGravity),
                       std::hypot(way.x, way.y) * metresPerUnit / speed);
    } else {
      time += length(way) * metresPerUnit / speed;
    }
    times_.push_back(time);
  }
}

std::size_t WalkTrack::pieceAt(double seconds) const {
  const auto next = std::upper_bound(times_.begin(), times_.end(), seconds);
  const auto index = static_cast<std::size_t>(next - times_.begin());
  return std::min(index == 0 ? 0 : index - 1, points_.size() - 2);
}

Vec3 WalkTrack::feetAt(double seconds) const {
  if (points_.size() == 1 || seconds <= 0) return points_.front();
  if (seconds >= this->seconds()) return points_.back();
  const std::size_t i = pieceAt(seconds);
  const double whole = times_[i + 1] - times_[i];
  const double part = whole > 0 ? (seconds - times_[i]) / whole : 1;
  const Vec3& from = points_[i];
  const Vec3 way = points_[i + 1] - from;
  return {from.x + part * way.x, from.y + part * way.y, from.z + (isDrop_[i] ? part * part : part) * way.z};
}

bool WalkTrack::isFallingAt(double seconds) const {
  return points_.size() > 1 && seconds > 0 && seconds < this->seconds() && isDrop_[pieceAt(seconds)];
}

double WalkTrack::turnAt(double seconds) const {
  // At an end, as much of the way as there is.
  const double all = this->seconds();
  const double at = std::clamp(seconds, 0.0, all);
  for (double reach = 1; reach < 1e4; reach *= 4) {
    const Vec3 way = feetAt(at + kLooksAhead * reach) - feetAt(at - kLooksBack * reach);
    if (std::hypot(way.x, way.y) > 0) return std::atan2(way.y, way.x) * 180 / M_PI;
    if (kLooksBack * reach > all) break;
  }
  return 0;
}

double WalkTrack::smoothHeightAt(double seconds) const {
  if (isFallingAt(seconds)) return feetAt(seconds).z;
  double sum = 0;
  int count = 0;
  for (int i = -kSamples; i <= kSamples; ++i) {
    const double at = seconds + i * kSmoothing / kSamples;
    if (isFallingAt(at)) continue;
    sum += feetAt(at).z;
    ++count;
  }
  return sum / count;
}

double walkSeconds(const PathResult& path, double metresPerUnit, double speed) {
  return WalkTrack(path, metresPerUnit, speed).seconds();
}

}  // namespace footfall::ui
