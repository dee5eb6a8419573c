// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/mesh_relation.hpp"

namespace footfall::detail {
namespace {

/// The triangles of each face, in their order.
struct TrianglesOfFaces {
  std::vector<Index> first;  ///< start of each face, and the end
  std::vector<Index> triangles;

  TrianglesOfFaces(const WalkableMesh& mesh, std::size_t faceCount) : first(faceCount + 1, 0) {
    for (const MeshTriangle& t : mesh.triangles) ++first[t.face + 1];
    for (std::size_t f = 0; f < faceCount; ++f) first[f + 1] += first[f];
    triangles.resize(mesh.triangles.size());
    std::vector<Index> next(first.begin(), first.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      triangles[next[mesh.triangles[t].face]++] = static_cast<Index>(t);
  }
};

}  // namespace

MeshRelation relateMeshes(const EarlierResult& earlier, const WalkableMesh& before, const WalkableMesh& now) {
  MeshRelation relation;
  relation.triangleBefore.assign(now.triangles.size(), -1);
  relation.vertexBefore.assign(now.vertices.size(), -1);
  relation.vertexNow.assign(before.vertices.size(), -1);
  const auto isSameVertex = [&](Index then, Index v) {
    if (relation.vertexNow[then] >= 0 || relation.vertexBefore[v] >= 0) return relation.vertexNow[then] == v;
    if (!earlier.isSame(before.vertices[then], now.vertices[v])) return false;
    relation.vertexNow[then] = v;
    relation.vertexBefore[v] = then;
    return true;
  };
  const std::size_t facesBefore = earlier.state().walkable.size();
  const TrianglesOfFaces ofBefore(before, facesBefore);
  // The number of triangles of each earlier face that have been compared: they come in the same order.
  std::vector<Index> next(ofBefore.first.begin(), ofBefore.first.end() - 1);
  for (std::size_t t = 0; t < now.triangles.size(); ++t) {
    const MeshTriangle& triangle = now.triangles[t];
    const Index face = earlier.faceBefore(triangle.face);
    if (face < 0 || next[face] == ofBefore.first[face + 1]) continue;
    const Index candidate = ofBefore.triangles[next[face]++];
    const MeshTriangle& then = before.triangles[candidate];
    if (then.obstacleEdges == triangle.obstacleEdges && isSameVertex(then.corners[0], triangle.corners[0]) &&
        isSameVertex(then.corners[1], triangle.corners[1]) && isSameVertex(then.corners[2], triangle.corners[2])) {
      relation.triangleBefore[t] = candidate;
      ++relation.related;
    }
  }
  return relation;
}

}  // namespace footfall::detail
