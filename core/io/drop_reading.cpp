// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/drop_reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"
#include "core/mesh/adjacency.hpp"

namespace footfall::detail {
namespace {

// Files contain the lines of drops and not the mesh elements that they belong to. The nearest elements within a small
// distance are used. All distances are relative to the largest coordinate.
constexpr double kNear = 0x1p-16;      ///< far more than numbers in files are rounded by
constexpr double kWrongWay = 0x1p-20;  ///< a side that runs against the starts must be nearer by this
/// relative to the width of a drop: how far behind the landing the triangle is looked up
constexpr double kOutwards = 0x1p-16;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distanceToSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 way = b - a;
  const double squared = dot(way, way);
  const double t = squared > 0 ? std::clamp(dot(p - a, way) / squared, 0.0, 1.0) : 0;
  return length(p - (a + t * way));
}

Vec3 middleOf(const std::array<Vec3, 2>& p) { return 0.5 * p[0] + 0.5 * p[1]; }

class DropPlaces {
 public:
  explicit DropPlaces(const NavigationMesh& mesh)
      : mesh_(mesh), corners_(mesh.triangles), isBorder_(3 * mesh.triangles.size(), 0) {
    const Adjacency topology = findEdges(corners_, mesh.vertices.size());
    for (Index e = 0; e < topology.edgeCount(); ++e)
      if (const auto sides = topology.sidesOf(e); sides.size() == 1) isBorder_[sides[0]] = 1;
    std::vector<Box> boxes;
    std::vector<std::int32_t> ids;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      ids.push_back(static_cast<std::int32_t>(boxes.size()));
      boxes.push_back({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                       {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
      for (const Vec3* p : {&a, &b, &c})
        largest_ = std::max({largest_, std::fabs(p->x), std::fabs(p->y), std::fabs(p->z)});
    }
    if (!boxes.empty()) tree_.build(boxes, ids);
  }

  /// The side of the border that is nearest to both places together; the first one of several.
  std::optional<Index> side(const std::array<Vec3, 2>& starts) {
    std::optional<Index> best;
    double least = kInfinity;
    forNear(middleOf(starts), [&](std::uint32_t t) {
      for (Index side = static_cast<Index>(3 * t); side < static_cast<Index>(3 * t + 3); ++side) {
        if (isBorder_[side] == 0) continue;
        const Vec3 &a = mesh_.vertices[corners_.beginOf(side)], &b = mesh_.vertices[corners_.endOf(side)];
        double apart = distanceToSegment(a, b, starts[0]) + distanceToSegment(a, b, starts[1]);
        // The other side of an obstacle edge runs against the starts.
        if (dot(b - a, starts[1] - starts[0]) < 0) apart += kWrongWay * largest_;
        if (apart > least || (apart == least && best && *best < side)) continue;
        least = apart;
        best = side;
      }
    });
    return best;
  }

  /// The triangle that holds a place best: by height, then by its distance in the plan.
  std::optional<std::uint32_t> triangle(const Vec3& place) {
    std::optional<std::uint32_t> best;
    double least = kInfinity;
    forNear(place, [&](std::uint32_t t) {
      const Triangle& f = mesh_.triangles[t];
      const Vec3 &a = mesh_.vertices[f[0]], &b = mesh_.vertices[f[1]], &c = mesh_.vertices[f[2]];
      const Vec3 n = normalOf(a, b, c);
      if (!(n.z > 0)) return;
      double apart = std::fabs(dot(n, place - a)) / n.z;
      for (const auto& [p, q] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
        const double dx = q.x - p.x, dy = q.y - p.y;
        apart += std::max(0.0, (dy * (place.x - p.x) - dx * (place.y - p.y)) / std::hypot(dx, dy));
      }
      if (apart > least || (apart == least && best && *best < t)) return;
      least = apart;
      best = t;
    });
    return best;
  }

 private:
  template <class Visit>
  void forNear(const Vec3& p, const Visit& visit) {
    const double margin = kNear * largest_;
    const Box query{{p.x - margin, p.y - margin, p.z - margin}, {p.x + margin, p.y + margin, p.z + margin}};
    tree_.visitOverlapping(query, stack_, [&](std::int32_t t) {
      visit(static_cast<std::uint32_t>(t));
      return true;
    });
  }

  const NavigationMesh& mesh_;
  TriangleCorners corners_;
  std::vector<char> isBorder_;
  TriangleTree tree_;
  double largest_ = 0;
  std::vector<std::int32_t> stack_;
};

}  // namespace

void completeDrops(const std::vector<DropLine>& lines, NavigationMesh& mesh) {
  if (lines.empty() || mesh.triangles.empty()) return;
  DropPlaces places(mesh);
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    DropLink drop;
    for (const std::size_t end : {0, 1}) {
      drop.start[end] = lines[i + end][0];
      drop.landing[end] = lines[i + end][1];
      drop.depth = std::max(drop.depth, drop.start[end].z - drop.landing[end].z);
    }
    const Vec3 way = drop.start[1] - drop.start[0];
    drop.width = std::hypot(way.x, way.y);
    const auto side = places.side(drop.start);
    // Agents land on the right of the edge, and the triangle lies beyond it.
    const auto landing = places.triangle(middleOf(drop.landing) + kOutwards * Vec3{way.y, -way.x, 0});
    if (!side || !landing) continue;
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(*side / 3)];
    const int k = *side % 3;
    drop.from = {t[k], t[next(k)]};
    drop.fromTriangle = static_cast<std::uint32_t>(*side / 3);
    drop.toTriangle = *landing;
    mesh.drops.push_back(drop);
  }
}

}  // namespace footfall::detail
