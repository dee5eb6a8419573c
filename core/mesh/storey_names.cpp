// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/storey_names.hpp"

#include <cmath>
#include <cstddef>

namespace footfall::detail {

std::string storeysOf(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles) {
  constexpr double kBelow = 0.5;  // metres
  constexpr double kLeastShare = 0.1;
  const std::vector<Storey>& storeys = mesh.frame.storeys;
  std::vector<double> areas(storeys.size(), 0);
  double sum = 0;
  for (const std::uint32_t t : triangles) {
    if (storeys.empty()) break;
    const Triangle& corners = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
    const double top = (a.z + b.z + c.z) / 3 + kBelow / mesh.frame.metresPerUnit;
    std::size_t storey = 0;
    while (storey + 1 < storeys.size() && storeys[storey + 1].height <= top) ++storey;
    const double area = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    areas[storey] += area;
    sum += area;
  }
  std::string names;
  for (std::size_t s = 0; s < storeys.size(); ++s) {
    if (areas[s] == 0 || areas[s] < kLeastShare * sum) continue;
    if (!names.empty()) names += ", ";
    names += storeys[s].name;
  }
  return names;
}

std::vector<std::string> storeyNames(const NavigationMesh& mesh) {
  if (mesh.frame.storeys.empty() || mesh.layers.empty()) return {};
  std::vector<std::vector<std::uint32_t>> members(mesh.layerCount);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) members[mesh.layers[t]].push_back(t);
  std::vector<std::string> names;
  for (const std::vector<std::uint32_t>& layer : members) names.push_back(storeysOf(mesh, layer));
  return names;
}

}  // namespace footfall::detail
