// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/dropped_parts.hpp"

#include <algorithm>
#include <optional>

#include "core/base/triangle_tree.hpp"

namespace footfall::detail {

// What AreaFilter took away does not come back when floors are cut anew. The outlines of earlier parts stay among the
// cuts, so a new triangle lies in an earlier part as a whole, and any inner point tells which.
std::shared_ptr<const WalkableMesh> withoutDropped(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                   const WalkableMesh& dropped, RunContext& context,
                                                   ExactFallbacks& fallbacks) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  const auto boxOf = [](const WalkableMesh& m, const MeshTriangle& t) {
    Box box;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex& v = m.vertices[t.corners[k]];
      const std::array<double, 3> c{v.x, v.y, v.z};
      for (int i = 0; i < 3; ++i) {
        const double low = c[i] - v.error, high = c[i] + v.error;
        box.lower[i] = k == 0 ? low : std::min(box.lower[i], low);
        box.upper[i] = k == 0 ? high : std::max(box.upper[i], high);
      }
    }
    return box;
  };
  for (std::size_t i = 0; i < dropped.triangles.size(); ++i) {
    boxes.push_back(boxOf(dropped, dropped.triangles[i]));
    ids.push_back(static_cast<std::int32_t>(i));
  }
  TriangleTree tree;
  tree.build(std::move(boxes), std::move(ids), context);

  using Place = std::array<mpq_class, 3>;
  const auto placeOf = [&](const MeshVertex& v) { return kernel.exactPosition(v.point, v.face); };
  const auto contains = [&](const MeshTriangle& t, const mpq_class& x, const mpq_class& y) {
    std::array<Place, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = placeOf(dropped.vertices[t.corners[k]]);
    for (int k = 0; k < 3; ++k) {
      const Place &a = p[k], &b = p[(k + 1) % 3];
      if ((b[0] - a[0]) * (y - a[1]) < (b[1] - a[1]) * (x - a[0])) return false;
    }
    return true;
  };
  auto result = std::make_shared<WalkableMesh>();
  result->vertices = mesh.vertices;
  std::vector<std::int32_t> stack;
  for (const MeshTriangle& t : mesh.triangles) {
    context.checkCancelled();
    std::optional<std::array<mpq_class, 2>> centre;
    bool gone = false;
    tree.visitOverlapping(boxOf(mesh, t), stack, [&](std::int32_t i) {
      const MeshTriangle& d = dropped.triangles[i];
      if (d.face != t.face && !kernel.coplanar(t.face, d.face, fallbacks)) return true;
      if (!centre) {
        centre.emplace();
        for (const Index c : t.corners) {
          const Place p = placeOf(mesh.vertices[c]);
          (*centre)[0] += p[0] / 3;
          (*centre)[1] += p[1] / 3;
        }
      }
      gone = contains(d, (*centre)[0], (*centre)[1]);
      return !gone;
    });
    if (!gone) result->triangles.push_back(t);
  }
  return result;
}

}  // namespace footfall::detail
