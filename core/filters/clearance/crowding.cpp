// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/crowding.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::detail {
namespace {

double planArea(const Box& a, const Box& b) {
  double area = 1;
  for (const std::size_t axis : {0, 1})
    area *= std::max(0.0, std::min(a.upper[axis], b.upper[axis]) - std::max(a.lower[axis], b.lower[axis]));
  return area;
}

}  // namespace

Crowding::Crowding(const SourceMesh& mesh, Index face) : mesh_(mesh), box_(boxOf(mesh, face)) {}

void Crowding::restart(Index face) {
  box_ = boxOf(mesh_, face);
  few_.clear();
  areas_ = 0;
  squares_ = 0;
}

void Crowding::restart(Index face, const Depths& depths, std::size_t areas) {
  restart(face);
  areas_ = areas;
  depths_ = depths;
  for (const std::uint64_t depth : depths_) squares_ += depth * depth;
}

double Crowding::commonArea(Index obstacle) const { return planArea(box_, boxOf(mesh_, obstacle)); }

void Crowding::add(Index obstacle) {
  if (mesh_.facing[obstacle] == 0) return;
  if (++areas_ > kFewest) {
    count(boxOf(mesh_, obstacle));
    return;
  }
  few_.push_back(obstacle);
  if (areas_ < kFewest) return;
  depths_.fill(0);
  for (const Index one : few_) count(boxOf(mesh_, one));
}

void Crowding::remove(const Box& obstacle) {
  --areas_;
  count(obstacle, true);
}

void Crowding::count(const Box& box, bool isRemoved) {
  if (isCrowd() && !isRemoved) return;  // it stays one, and sums do not overflow
  // The share of each part of the face's box along an axis that the obstacle's box covers, and the parts that have one.
  std::array<std::array<double, kParts>, 2> shares{};
  std::array<std::size_t, 2> first{}, last{};
  for (const std::size_t axis : {0, 1}) {
    const double width = (box_.upper[axis] - box_.lower[axis]) / kParts;
    if (!(width > 0) || !std::isfinite(width)) return;
    const double low = (box.lower[axis] - box_.lower[axis]) / width;
    const double high = (box.upper[axis] - box_.lower[axis]) / width;
    first[axis] = static_cast<std::size_t>(std::clamp(low, 0.0, kParts - 1.0));
    last[axis] = static_cast<std::size_t>(std::clamp(high, 0.0, kParts - 1.0));
    for (std::size_t i = first[axis]; i <= last[axis]; ++i) {
      const auto start = static_cast<double>(i);
      shares[axis][i] = std::clamp(high - start, 0.0, 1.0) - std::clamp(low - start, 0.0, 1.0);
    }
  }
  for (std::size_t y = first[1]; y <= last[1]; ++y)
    for (std::size_t x = first[0]; x <= last[0]; ++x) {
      std::uint64_t& depth = depths_[y * kParts + x];
      const auto more = static_cast<std::uint64_t>(std::max(shares[0][x] * shares[1][y], 0.0) * kUnits);
      if (isRemoved) {
        depth -= more;
        squares_ -= more * (2 * depth + more);
        continue;
      }
      squares_ += more * (2 * depth + more);
      depth += more;
    }
}

}  // namespace footfall::detail
