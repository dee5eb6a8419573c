// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices and triangles of both meshes are sorted, so that all maps rise.
#include "core/exact/mesh_match.hpp"

#include <algorithm>

namespace footfall::detail {
namespace {

constexpr Index kPolled = 1 << 15;

void matchVertices(const SourceMesh& base, const SourceMesh& now, SourceEdit& edit, const Poll& poll) {
  const auto count = static_cast<Index>(base.vertices.size());
  edit.vertexOf.assign(base.vertices.size(), -1);
  edit.planOf.assign(base.vertices.size(), -1);
  std::size_t next = 0;
  for (Index v = 0; v < count; ++v) {
    if (v % kPolled == 0) poll();
    const Vec3& place = base.vertices[v];
    while (next < now.vertices.size() && isBefore(now.vertices[next], place)) ++next;
    if (next == now.vertices.size() || now.vertices[next] != place) continue;
    edit.vertexOf[v] = static_cast<Index>(next);
    edit.planOf[base.planIds[v]] = now.planIds[next];
  }
}

void matchTriangles(const SourceMesh& base, const SourceMesh& now, SourceEdit& edit, const Poll& poll) {
  const auto count = static_cast<Index>(base.triangles.size()), countNow = static_cast<Index>(now.triangles.size());
  edit.triangleOf.assign(base.triangles.size(), -1);
  edit.baseOf.assign(now.triangles.size(), -1);
  Index next = 0;
  for (Index t = 0; t < count; ++t) {
    if (t % kPolled == 0) poll();
    std::array<Index, 3> corners = base.triangles[t];
    for (Index& v : corners) v = edit.vertexOf[v];
    const bool isThere = *std::min_element(corners.begin(), corners.end()) >= 0;
    while (isThere && next < countNow && now.triangles[next] < corners) ++next;
    if (!isThere || next == countNow || now.triangles[next] != corners) {
      edit.removed.push_back(boxOf(base, t));
      continue;
    }
    edit.triangleOf[t] = next;
    edit.baseOf[next++] = t;
  }
  for (Index t = 0; t < countNow; ++t) {
    if (edit.baseOf[t] >= 0) continue;
    if (now.degenerate[t] == 0) edit.addedTriangles.push_back(t);
    edit.added.push_back(boxOf(now, t));
  }
}

}  // namespace

std::shared_ptr<const SourceEdit> matchSourceMeshes(const std::shared_ptr<const SourceMesh>& base,
                                                    const SourceMesh& now, const Poll& poll) {
  if (base->grid.scaleExponent() != now.grid.scaleExponent()) return nullptr;
  auto edit = std::make_shared<SourceEdit>();
  edit->base = base;
  matchVertices(*base, now, *edit, poll);
  matchTriangles(*base, now, *edit, poll);
  return edit;
}

}  // namespace footfall::detail
