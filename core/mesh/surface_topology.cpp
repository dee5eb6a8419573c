// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_topology.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

constexpr std::uint32_t kNone = SurfaceTopology::kNone;

struct Side {
  std::uint64_t key;  ///< the smaller vertex, then the larger
  std::uint32_t triangle;
  std::uint8_t side;
  bool rises;  ///< goes from the smaller vertex to the larger
};

std::vector<Side> sidesOf(const NavigationMesh& mesh, const std::function<void()>& poll) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % 4096 == 0) poll();
    const Triangle& f = mesh.triangles[t];
    if (facing(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]) <= 0) continue;
    for (std::uint8_t i = 0; i < 3; ++i) {
      const std::uint32_t a = f[i], b = f[(i + 1) % 3];
      sides.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), t, i, a < b});
    }
  }
  poll();
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.triangle < b.triangle; });
  poll();
  return sides;
}

/// Sets that grow together; the smallest member stands for its set.
class Sets {
 public:
  explicit Sets(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0U); }
  std::uint32_t find(std::uint32_t x) {
    while (parents_[x] != x) x = parents_[x] = parents_[parents_[x]];
    return x;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace

SurfaceTopology makeSurfaceTopology(const NavigationMesh& mesh, const std::function<void()>& poll) {
  const std::size_t count = mesh.triangles.size();
  SurfaceTopology topology;
  topology.neighbours.assign(count, {kNone, kNone, kNone});
  topology.fans.assign(count, {kNone, kNone, kNone});
  topology.components.assign(count, kNone);

  const std::vector<Side> sides = sidesOf(mesh, poll);
  Sets corners(3 * count), parts(count);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t last = i + 1;
    while (last < sides.size() && sides[last].key == sides[i].key) ++last;
    const Side& a = sides[i];
    if (last == i + 2 && a.rises != sides[i + 1].rises) {
      const Side& b = sides[i + 1];
      topology.neighbours[a.triangle][a.side] = b.triangle;
      topology.neighbours[b.triangle][b.side] = a.triangle;
      corners.unite(3 * a.triangle + a.side, 3 * b.triangle + (b.side + 1) % 3);
      corners.unite(3 * a.triangle + (a.side + 1) % 3, 3 * b.triangle + b.side);
      parts.unite(a.triangle, b.triangle);
    }
    i = last;
  }
  poll();

  std::vector<char> takesPart(count, 0);
  for (const Side& side : sides) takesPart[side.triangle] = 1;
  for (std::uint32_t t = 0; t < count; ++t) {
    if (takesPart[t] == 0) continue;
    const std::uint32_t first = parts.find(t);
    topology.components[t] = first == t ? topology.componentCount++ : topology.components[first];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t representative = corners.find(3 * t + i);
      if (representative == 3 * t + i) {
        topology.fans[t][i] = static_cast<std::uint32_t>(topology.fanVertices.size());
        topology.fanVertices.push_back(mesh.triangles[t][i]);
        topology.isOpen.push_back(0);
      } else {
        topology.fans[t][i] = topology.fans[representative / 3][representative % 3];
      }
      if (topology.neighbours[t][i] == kNone || topology.neighbours[t][(i + 2) % 3] == kNone)
        topology.isOpen[topology.fans[t][i]] = 1;
    }
  }
  return topology;
}

}  // namespace footfall::detail
