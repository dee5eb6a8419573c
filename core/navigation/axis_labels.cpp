// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/axis_labels.hpp"

#include <algorithm>
#include <limits>

namespace footfall::detail {
namespace {

/// Places between which no two windows change their order.
std::vector<double> placesOf(std::span<const FieldWindow> windows, double length) {
  std::vector<double> places{0, length};
  const auto add = [&](double s) {
    if (s > 0 && s < length) places.push_back(s);
  };
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const FieldWindow& a = windows[i];
    add(a.lo);
    add(a.hi);
    for (std::size_t k = i + 1; k < windows.size(); ++k) {
      const FieldWindow& b = windows[k];
      const double lo = std::max(a.lo, b.lo), hi = std::min(a.hi, b.hi);
      if (a.feature == b.feature || lo > hi) continue;
      std::array<double, 2> equal{};
      const int count = equalPlaces(a, b, equal);
      for (int e = 0; e < count; ++e)
        if (equal[e] > lo && equal[e] < hi) add(equal[e]);
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

std::vector<AxisLabel> labelsOf(const ClearanceField& field, std::uint32_t edge) {
  const double length = field.surface().edges[edge].length;
  const auto windows = field.windowsOf(edge);
  const std::vector<double> places = placesOf(windows, length);
  std::vector<AxisLabel> labels;
  double begin = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double end = places[i];
    if (end - begin <= field.margin() && i + 1 < places.size()) continue;
    const double middle = begin + (end - begin) / 2;
    double least = std::numeric_limits<double>::infinity(), before = least;
    std::uint32_t nearest = FieldEdge::kNone;
    for (const FieldWindow& window : windows) {
      if (window.lo > middle || window.hi < middle) continue;
      const double distance = window.distance(middle);
      if (!labels.empty() && window.feature == labels.back().feature) before = std::min(before, distance);
      if (distance < least || (distance == least && window.feature < nearest)) {
        least = distance;
        nearest = window.feature;
      }
    }
    begin = end;
    if (nearest == FieldEdge::kNone || (!labels.empty() && before <= least + field.margin() / 2)) {
      if (!labels.empty()) labels.back().end = end;
      continue;
    }
    labels.push_back({nearest, end});
  }
  return labels;
}

}  // namespace footfall::detail
