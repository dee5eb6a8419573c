// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/storey_names.hpp"

#include <cmath>
#include <cstddef>

namespace footfall::detail {

std::vector<std::string> storeyNames(const NavigationMesh& mesh) {
  constexpr double kBelow = 0.5;  // metres
  constexpr double kLeastShare = 0.1;
  const std::vector<Storey>& storeys = mesh.frame.storeys;
  if (storeys.empty() || mesh.layers.empty()) return {};
  std::vector<std::vector<double>> areas(mesh.layerCount, std::vector<double>(storeys.size(), 0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
    const double top = (a.z + b.z + c.z) / 3 + kBelow / mesh.frame.metresPerUnit;
    std::size_t storey = 0;
    while (storey + 1 < storeys.size() && storeys[storey + 1].height <= top) ++storey;
    areas[mesh.layers[t]][storey] += std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  std::vector<std::string> names;
  for (const std::vector<double>& ofLayer : areas) {
    double sum = 0;
    for (const double area : ofLayer) sum += area;
    std::string& name = names.emplace_back();
    for (std::size_t s = 0; s < storeys.size(); ++s) {
      if (ofLayer[s] == 0 || ofLayer[s] < kLeastShare * sum) continue;
      if (!name.empty()) name += ", ";
      name += storeys[s].name;
    }
  }
  return names;
}

}  // namespace footfall::detail
