// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/insertion_order.hpp"

#include <algorithm>
#include <cstdint>

#include "core/base/hilbert_curve.hpp"

namespace footfall::detail {

CurvePlaces::CurvePlaces(const FaceGeometry& geometry) {
  double right = 0, top = 0;
  for (int k = 0; k < 3; ++k) {
    const ApproximatePoint& p = geometry.approximate(k);
    left_ = std::min(left_, p.x), right = std::max(right, p.x);
    bottom_ = std::min(bottom_, p.y), top = std::max(top, p.y);
  }
  // Faces so small beside the environment that their rounded points coincide are sorted by what the points are.
  const double width = std::max(right - left_, top - bottom_);
  scale_ = width > 0x1p-900 ? 65535 / width : 0;
}

std::uint64_t CurvePlaces::of(const ApproximatePoint& point) const {
  const auto stepOf = [](double v) { return static_cast<std::uint32_t>(std::clamp(v, 0.0, 65535.0)); };
  return hilbertIndex(stepOf((point.x - left_) * scale_), stepOf((point.y - bottom_) * scale_));
}

void sortAlongCurve(const FaceGeometry& geometry, std::vector<Index>& points) {
  const CurvePlaces places(geometry);
  std::vector<std::pair<std::uint64_t, Index>> order;
  order.reserve(points.size());
  for (const Index p : points) order.emplace_back(places.of(geometry.approximate(p)), p);
  std::sort(order.begin(), order.end(), [&](const auto& p, const auto& q) {
    return p.first != q.first ? p.first < q.first : p.second != q.second && geometry[p.second] < geometry[q.second];
  });
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = order[i].second;
}

}  // namespace footfall::detail
