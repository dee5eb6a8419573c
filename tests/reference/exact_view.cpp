// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/exact_view.hpp"

#include "core/assembly/walkable_state.hpp"

namespace footfall::detail {
namespace {

std::array<std::string, 3> textOf(const std::array<mpq_class, 3>& p) {
  return {p[0].get_str(), p[1].get_str(), p[2].get_str()};
}

}  // namespace

std::vector<ExactTriangle> exactWalkableTriangles(const WalkableState& state) {
  const SourceMesh& source = state.kernel->mesh();
  std::vector<ExactTriangle> result;
  if (!state.mesh) {
    for (std::size_t t = 0; t < source.triangles.size(); ++t) {
      if (state.walkable[t] == 0) continue;
      ExactTriangle triangle;
      for (int k = 0; k < 3; ++k) {
        const Vec3& p = source.vertices[source.triangles[t][k]];
        triangle.corners[k] = textOf({mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)});
      }
      triangle.sourceTriangle = source.inputTriangles[t];
      result.push_back(triangle);
    }
    return result;
  }
  std::vector<std::array<std::string, 3>> places;
  for (const MeshVertex& v : state.mesh->vertices) {
    if (v.source >= 0) {
      const Vec3& p = source.vertices[v.source];
      places.push_back(textOf({mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}));
    } else {
      places.push_back(textOf(state.kernel->exactPosition(v.point, v.face)));
    }
  }
  for (std::size_t i = 0; i < state.mesh->triangles.size(); ++i) {
    const MeshTriangle& t = state.mesh->triangles[i];
    ExactTriangle triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.corners[k] = places[t.corners[k]];
      triangle.obstacleEdge[k] = (t.obstacleEdges >> k & 1) != 0;
    }
    triangle.sourceTriangle = source.inputTriangles[t.face];
    if (!state.mesh->layers.empty()) triangle.layer = static_cast<int>(state.mesh->layers[i]);
    result.push_back(triangle);
  }
  return result;
}

}  // namespace footfall::detail
