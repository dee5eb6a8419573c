// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/main_direction.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace footfall::detail {
namespace {

constexpr int kBins = 4096;            // a quarter of a turn has this many
constexpr double kLeastShare = 0.125;  // of the length of all edges
constexpr double kOverAxes = 2;        // times as long as the edges along the axes

}  // namespace

void MainDirection::add(double dx, double dy) {
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0) || !std::isfinite(length)) return;
  double x = dx / length, y = dy / length;
  if (x < 0 || (x == 0 && y < 0)) x = -x, y = -y;
  if (y < 0) {
    const double turned = -y;
    y = x;
    x = turned;
  } else if (x == 0) {
    x = y;
    y = 0;
  }
  edges_.push_back({x, y, length, std::min(static_cast<int>(y / (x + y) * kBins), kBins - 1)});
}

// Rounding spreads a direction over two bins, which are taken together; the first bin follows the last one.
std::optional<std::array<double, 2>> MainDirection::find() const {
  std::vector<double> lengths(kBins, 0.0);
  double sum = 0;
  for (const Edge& edge : edges_) {
    lengths[static_cast<std::size_t>(edge.bin)] += edge.length;
    sum += edge.length;
  }
  const auto inPair = [&](int bin) {
    return lengths[static_cast<std::size_t>(bin)] + lengths[static_cast<std::size_t>((bin + 1) % kBins)];
  };
  int best = 0;
  for (int bin = 1; bin < kBins; ++bin)
    if (inPair(bin) > inPair(best)) best = bin;
  const double alongAxes = inPair(kBins - 1) + lengths[1];
  if (!(inPair(best) >= kLeastShare * sum) || inPair(best) < kOverAxes * alongAxes) return std::nullopt;
  const Edge* longest = nullptr;
  for (const Edge& edge : edges_)
    if ((edge.bin == best || edge.bin == (best + 1) % kBins) && (longest == nullptr || edge.length > longest->length))
      longest = &edge;
  if (longest == nullptr) return std::nullopt;
  return std::array<double, 2>{longest->x, longest->y};
}

}  // namespace footfall::detail
