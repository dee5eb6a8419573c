// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/axis_islands.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/disjoint_sets.hpp"

namespace footfall::detail {
namespace {

constexpr std::uint32_t kNoPart = 0xFFFFFFFF;

/// The distance between the nearest places of both features of an arc, at the end where it is larger.
double widthBetween(const ClearanceField& field, const CorridorAxis& axis, const AxisArc& arc) {
  double width = 0;
  for (const std::uint32_t node : {arc.from, arc.to}) {
    const FieldVector p = axis.nodes[node].place;
    width = std::max(width, lengthOf(field.features()[arc.features[0]].nearestTo(p) -
                                     field.features()[arc.features[1]].nearestTo(p)));
  }
  return width;
}

}  // namespace

std::vector<char> arcsToLeaveOut(const ClearanceField& field, const CorridorAxis& axis, Poll poll) {
  std::vector<char> isLeftOut(axis.arcs.size(), 0), reachesBorder = axis.reachesBorder;
  DisjointSets regions(reachesBorder.size());
  const auto regionOf = [&](std::uint32_t region) { return regions.find(static_cast<Index>(region)); };
  const auto open = [&](std::uint32_t a) {
    isLeftOut[a] = 1;
    const Index first = regionOf(axis.arcs[a].regions[0]), second = regionOf(axis.arcs[a].regions[1]);
    regions.unite(first, second);
    reachesBorder[regionOf(axis.arcs[a].regions[0])] = reachesBorder[first] != 0 || reachesBorder[second] != 0 ? 1 : 0;
  };
  for (std::uint32_t a = 0; a < axis.arcs.size(); ++a) {
    if (a % 4096 == 0) poll();
    if (pairOf(field, axis.arcs[a].features[0], axis.arcs[a].features[1]) == AxisPair::Joined) open(a);
  }
  std::vector<std::pair<double, std::uint32_t>> shores;
  for (std::uint32_t a = 0; a < axis.arcs.size(); ++a) {
    const auto [first, second] = axis.arcs[a].regions;
    if (isLeftOut[a] == 0 && (reachesBorder[regionOf(first)] == 0 || reachesBorder[regionOf(second)] == 0))
      shores.emplace_back(widthBetween(field, axis, axis.arcs[a]), a);
  }
  std::sort(shores.begin(), shores.end());
  for (const auto& shore : shores) {
    const Index first = regionOf(axis.arcs[shore.second].regions[0]);
    const Index second = regionOf(axis.arcs[shore.second].regions[1]);
    if (first != second && (reachesBorder[first] == 0 || reachesBorder[second] == 0)) open(shore.second);
  }
  return isLeftOut;
}

void leaveOutSmallParts(const ClearanceField& field, const CorridorAxis& axis, std::vector<char>& isLeftOut) {
  DisjointSets sets(axis.nodes.size());
  const auto partOf = [&](std::uint32_t a) {
    return static_cast<std::uint32_t>(sets.find(static_cast<Index>(axis.arcs[a].from)));
  };
  for (std::uint32_t a = 0; a < axis.arcs.size(); ++a)
    if (isLeftOut[a] == 0) sets.unite(static_cast<Index>(axis.arcs[a].from), static_cast<Index>(axis.arcs[a].to));
  std::vector<double> areas(axis.nodes.size(), 0);
  for (std::uint32_t a = 0; a < axis.arcs.size(); ++a)
    if (isLeftOut[a] == 0) areas[partOf(a)] += areaOf(field, axis, axis.arcs[a]);
  const auto& components = field.surface().topology.components;
  std::vector<std::uint32_t> largest(field.surface().faces.size(), kNoPart);  // of each component
  for (std::uint32_t a = 0; a < axis.arcs.size(); ++a) {
    if (isLeftOut[a] != 0) continue;
    std::uint32_t& best = largest[static_cast<std::size_t>(components[axis.arcs[a].face])];
    if (best == kNoPart || areas[partOf(a)] > areas[best]) best = partOf(a);
  }
  for (std::uint32_t a = 0; a < axis.arcs.size(); ++a)
    if (isLeftOut[a] == 0 && largest[static_cast<std::size_t>(components[axis.arcs[a].face])] != partOf(a))
      isLeftOut[a] = 1;
}

}  // namespace footfall::detail
