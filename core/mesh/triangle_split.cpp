// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {

// A fan from the corner opposite the first edge with vertices; the two other edges pass to its first and last piece.
void splitTriangle(const MeshTriangle& triangle, const EdgeVertices& on, std::vector<MeshTriangle>& result) {
  int k = 0;
  while (k < 3 && (on[k] == nullptr || on[k]->empty())) ++k;
  if (k == 3) {
    result.push_back(triangle);
    return;
  }
  const std::vector<Index>& inner = *on[k];
  const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  const auto flag = [&](int edge) { return triangle.obstacleEdges >> edge & 1; };
  Index from = triangle.corners[k];
  for (std::size_t i = 0; i <= inner.size(); ++i) {
    const bool last = i == inner.size();
    MeshTriangle part;
    part.corners = {from, last ? triangle.corners[k1] : inner[i], triangle.corners[k2]};
    part.face = triangle.face;
    int flags = flag(k);
    EdgeVertices rest{};
    if (last) {
      flags |= flag(k1) << 1;
      rest[1] = on[k1];
    }
    if (i == 0) {
      flags |= flag(k2) << 2;
      rest[2] = on[k2];
    }
    part.obstacleEdges = static_cast<std::uint8_t>(flags);
    splitTriangle(part, rest, result);
    from = part.corners[1];
  }
}

}  // namespace footfall::detail
