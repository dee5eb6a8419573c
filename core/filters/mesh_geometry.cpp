// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/mesh_geometry.hpp"

#include <cmath>

#include "core/exact/face_geometry.hpp"

namespace footfall {

Index MeshGeometry::origin(Index vertex) const { return kernel_.mesh().triangles[vertices_[vertex].face][0]; }

int MeshGeometry::orientation(Index a, Index b, Index c) {
  if (a == b || b == c || a == c) return 0;
  const MeshVertex &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
  const int filtered =
      filteredOrientation({p.x, p.y, p.error}, {q.x, q.y, q.error}, {r.x, r.y, r.error}, kernel_.sign().slack);
  if (filtered != kUnknownSign) return filtered;
  if (p.source >= 0 && q.source >= 0 && r.source >= 0)
    return kernel_.orientation(p.source, q.source, r.source, fallbacks);
  return kernel_.orientation(p.point, q.point, r.point, origin(b), fallbacks);
}

int MeshGeometry::compare(Index a, Index b, int axis) {
  const MeshVertex &p = vertices_[a], &q = vertices_[b];
  const double u = axis == 0 ? p.x : p.y, v = axis == 0 ? q.x : q.y;
  const double bound = (p.error + q.error + (std::fabs(u) + std::fabs(v)) * 0x1p-52) * kInflate;
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  return kernel_.compare(p.point, q.point, axis, origin(a), fallbacks);
}

bool MeshGeometry::isBetween(Index u, Index v, Index w) {
  if (orientation(u, v, w) != 0) return false;
  for (const int axis : {0, 1}) {
    const int first = compare(u, v, axis);
    if (first != 0) return compare(v, w, axis) == first;
  }
  return false;
}

// Two triangles are apart when an edge of one has all corners of the other on its outer side.
bool MeshGeometry::overlap(const MeshTriangle& s, const MeshTriangle& t) {
  const auto separates = [&](const MeshTriangle& m, const MeshTriangle& n) {
    for (int k = 0; k < 3; ++k) {
      const Index a = m.corners[k], b = m.corners[(k + 1) % 3];
      bool outside = true;
      for (int j = 0; j < 3 && outside; ++j) outside = orientation(a, b, n.corners[j]) <= 0;
      if (outside) return true;
    }
    return false;
  };
  return !separates(s, t) && !separates(t, s);
}

}  // namespace footfall
