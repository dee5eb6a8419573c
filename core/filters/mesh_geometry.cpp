// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/mesh_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/exact/face_geometry.hpp"

namespace footfall {

Index MeshGeometry::origin(Index vertex) const { return kernel_.mesh().triangles[vertices_[vertex].face][0]; }

int MeshGeometry::filtered(Index a, Index b, Index c) const {
  const MeshVertex &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
  return filteredOrientation({p.x, p.y, p.error}, {q.x, q.y, q.error}, {r.x, r.y, r.error}, kernel_.sign().slack);
}

int MeshGeometry::orientation(Index a, Index b, Index c) {
  if (a == b || b == c || a == c) return 0;
  const int sign = filtered(a, b, c);
  if (sign != kUnknownSign) return sign;
  const MeshVertex &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
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

// Two triangles are apart when an edge of one has all corners of the other on its outer side. What doubles tell about all
// six edges comes first: only where none of them separates for sure are the doubtful ones decided exactly.
bool MeshGeometry::overlap(const MeshTriangle& s, const MeshTriangle& t) {
  enum { kSeparates, kDoubtful, kDoesNot };
  const auto judge = [&](const MeshTriangle& m, const MeshTriangle& n, int k) {
    const Index a = m.corners[k], b = m.corners[(k + 1) % 3];
    int verdict = kSeparates;
    for (const Index c : n.corners) {
      if (c == a || c == b) continue;
      const int side = filtered(a, b, c);
      if (side == 1) return static_cast<int>(kDoesNot);
      if (side == kUnknownSign) verdict = kDoubtful;
    }
    return verdict;
  };
  std::array<int, 6> verdicts{};
  for (int k = 0; k < 6; ++k) {
    verdicts[k] = k < 3 ? judge(s, t, k) : judge(t, s, k - 3);
    if (verdicts[k] == kSeparates) return false;
  }
  for (int k = 0; k < 6; ++k) {
    if (verdicts[k] == kDoesNot) continue;
    const MeshTriangle &m = k < 3 ? s : t, &n = k < 3 ? t : s;
    const Index a = m.corners[k % 3], b = m.corners[(k + 1) % 3];
    if (std::all_of(n.corners.begin(), n.corners.end(), [&](Index c) { return orientation(a, b, c) <= 0; }))
      return false;
  }
  return true;
}

}  // namespace footfall
