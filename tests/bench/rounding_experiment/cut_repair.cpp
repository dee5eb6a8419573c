// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/rounding_experiment/cut_repair.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/vector.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

using Corners = std::array<Vec3, 3>;

// Turning the axes keeps orientations: z becomes the coordinate `axis`.
Vec3 turnedTo(const Vec3& p, int axis) {
  if (axis == 0) return {p.y, p.z, p.x};
  return axis == 1 ? Vec3{p.z, p.x, p.y} : p;
}

int facingAlong(const Corners& c, int axis) {
  return facing(turnedTo(c[0], axis), turnedTo(c[1], axis), turnedTo(c[2], axis));
}

/// The axis along which a triangle has the largest area.
int mainAxis(const Corners& c) {
  const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
  const std::array<double, 3> parts{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  return static_cast<int>(std::ranges::max_element(parts) - parts.begin());
}

Corners sourceCorners(const SourceMesh& mesh, Index triangle) {
  const auto& f = mesh.triangles[static_cast<std::size_t>(triangle)];
  return {mesh.vertices[static_cast<std::size_t>(f[0])], mesh.vertices[static_cast<std::size_t>(f[1])],
          mesh.vertices[static_cast<std::size_t>(f[2])]};
}

Corners cornersOf(const RoundedCut& cut, const CutTriangle& triangle) {
  const auto at = [&](std::size_t k) { return cut.vertices[static_cast<std::size_t>(triangle.corners[k])]; };
  return {at(0), at(1), at(2)};
}

bool hasRepeatedCorner(const CutTriangle& t) {
  return t.corners[0] == t.corners[1] || t.corners[1] == t.corners[2] || t.corners[2] == t.corners[0];
}

/// Each vertex becomes the first one in its place.
void weld(RoundedCut& cut) {
  std::vector<Index> order(cut.vertices.size()), becomes(cut.vertices.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, [&](Index a, Index b) {
    const Vec3 &p = cut.vertices[static_cast<std::size_t>(a)], &q = cut.vertices[static_cast<std::size_t>(b)];
    return isBefore(p, q) || (!isBefore(q, p) && a < b);
  });
  Index first = -1;
  for (const Index v : order) {
    const bool isSame = first >= 0 && !isBefore(cut.vertices[static_cast<std::size_t>(first)],
                                                cut.vertices[static_cast<std::size_t>(v)]);
    if (!isSame) first = v;
    becomes[static_cast<std::size_t>(v)] = first;
  }
  for (CutTriangle& t : cut.triangles)
    for (Index& v : t.corners) v = becomes[static_cast<std::size_t>(v)];
}

/// Two vertices: what goes, and what stands for it.
struct Collapse {
  Index from = -1, to = -1;
};

/// The corner opposite the longest side goes to the nearer of the other two; where it is a source vertex, which never
/// goes, the first corner that is none goes instead. Nothing where all are source vertices, which rounding never moved.
Collapse collapseOf(const RoundedCut& cut, const CutTriangle& t, std::size_t sources) {
  const Corners c = cornersOf(cut, t);
  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k) lengths[k] = length(c[(k + 1) % 3] - c[k]);
  const auto longest = static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = (longest + 2 + i) % 3;
    if (static_cast<std::size_t>(t.corners[from]) < sources) continue;
    const std::size_t next = (from + 1) % 3, last = (from + 2) % 3;
    return {t.corners[from], lengths[last] <= lengths[from] ? t.corners[last] : t.corners[next]};
  }
  return {};
}

Index lastOf(std::vector<Index>& becomes, Index v) {
  while (becomes[static_cast<std::size_t>(v)] != v) {
    Index& next = becomes[static_cast<std::size_t>(v)];
    next = becomes[static_cast<std::size_t>(next)];
    v = next;
  }
  return v;
}

}  // namespace

int turnOf(const SourceMesh& mesh, Index source, const std::array<Vec3, 3>& corners) {
  const Corners whole = sourceCorners(mesh, source);
  // Doubles may choose an axis along which a needle has no area at all.
  int axis = mainAxis(whole);
  for (int i = 0; i < 3 && facingAlong(whole, axis) == 0; ++i) axis = (axis + 1) % 3;
  const int turn = facingAlong(corners, axis);
  return facingAlong(whole, axis) < 0 ? -turn : turn;
}

RoundedCut roundCut(const CutEnvironment& cut) { return {cut.places, cut.triangles}; }

CutCases countCases(const SourceMesh& mesh, const Partition& partition, const CutEnvironment& cut,
                    const RoundedCut& rounded) {
  const CutGeometry geometry(mesh, partition);
  std::vector<char> isExact(cut.vertices.size(), 1);
  for (std::size_t v = mesh.vertices.size(); v < cut.vertices.size(); ++v) {
    const auto exact = geometry.exactPlace(cut.vertices[v]);
    const Vec3& place = cut.places[v];
    isExact[v] = exact[0] == place.x && exact[1] == place.y && exact[2] == place.z ? 1 : 0;
  }
  CutCases cases;
  for (std::size_t i = 0; i < rounded.triangles.size(); ++i) {
    const CutTriangle& t = rounded.triangles[i];
    if (mesh.degenerate[static_cast<std::size_t>(t.source)] != 0) continue;  // before rounding already
    const Corners c = cornersOf(rounded, t);
    const int equal = (c[0] == c[1] ? 1 : 0) + (c[1] == c[2] ? 1 : 0) + (c[2] == c[0] ? 1 : 0);
    const bool allExact =
        std::ranges::all_of(t.corners, [&](Index v) { return isExact[static_cast<std::size_t>(v)] != 0; });
    if (allExact)
      ++cases.exact;
    else if (equal > 0)
      ++(equal == 3 ? cases.point : cases.edge);
    else if (isDegenerate(c[0], c[1], c[2]))
      ++cases.collinear;
    else if (turnOf(mesh, t.source, c) < 0)
      ++cases.flipped;
    else
      ++cases.moved;
  }
  return cases;
}

void repairCut(const SourceMesh& mesh, RoundedCut& rounded) {
  weld(rounded);
  const std::size_t sources = mesh.vertices.size();
  const auto isWhole = [&](const CutTriangle& t) {
    return mesh.degenerate[static_cast<std::size_t>(t.source)] == 0 && hasRepeatedCorner(t);
  };
  std::erase_if(rounded.triangles, isWhole);
  std::vector<Index> becomes(rounded.vertices.size());
  std::iota(becomes.begin(), becomes.end(), Index{0});
  for (bool again = true; again;) {
    again = false;
    for (const CutTriangle& t : rounded.triangles) {
      CutTriangle now = t;
      for (Index& v : now.corners) v = lastOf(becomes, v);
      if (mesh.degenerate[static_cast<std::size_t>(t.source)] != 0 || hasRepeatedCorner(now)) continue;
      if (turnOf(mesh, t.source, cornersOf(rounded, now)) >= 0) continue;
      const Collapse collapse = collapseOf(rounded, now, sources);
      if (collapse.from < 0) continue;
      becomes[static_cast<std::size_t>(collapse.from)] = collapse.to;
      again = true;
    }
    for (CutTriangle& t : rounded.triangles)
      for (Index& v : t.corners) v = lastOf(becomes, v);
    std::erase_if(rounded.triangles, isWhole);
  }
  std::erase_if(rounded.triangles, [&](const CutTriangle& t) {
    if (mesh.degenerate[static_cast<std::size_t>(t.source)] != 0) return false;
    return turnOf(mesh, t.source, cornersOf(rounded, t)) <= 0;  // also those that stand upright on their plane
  });
}

}  // namespace footfall::bench
