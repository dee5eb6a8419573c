// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/insertion_order.hpp"

#include <algorithm>
#include <cstdint>

#include "core/base/hilbert_curve.hpp"

namespace footfall::detail {
void sortAlongCurve(const FaceGeometry& geometry, std::vector<Index>& points) {
  double left = 0, right = 0, bottom = 0, top = 0;
  for (int k = 0; k < 3; ++k) {
    const ApproximatePoint& p = geometry.approximate(k);
    left = std::min(left, p.x), right = std::max(right, p.x);
    bottom = std::min(bottom, p.y), top = std::max(top, p.y);
  }
  // Faces so small beside the environment that nothing tells their points apart are sorted by what the points are.
  const double width = std::max(right - left, top - bottom);
  const double scale = width > 0x1p-900 ? 65535 / width : 0;
  const auto cell = [](double v) { return static_cast<std::uint32_t>(std::clamp(v, 0.0, 65535.0)); };
  std::vector<std::pair<std::uint64_t, Index>> order;
  order.reserve(points.size());
  for (const Index p : points) {
    const ApproximatePoint& a = geometry.approximate(p);
    order.emplace_back(hilbertIndex(cell((a.x - left) * scale), cell((a.y - bottom) * scale)), p);
  }
  std::sort(order.begin(), order.end(), [&](const auto& p, const auto& q) {
    return p.first != q.first ? p.first < q.first : p.second != q.second && geometry[p.second] < geometry[q.second];
  });
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = order[i].second;
}

}  // namespace footfall::detail
