// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/dropped_parts.hpp"

#include <algorithm>
#include <optional>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/parallel.hpp"
#include "core/base/triangle_tree.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 16;
constexpr std::size_t kTrianglesPerTask = 2048;

/// The number of each triangle among those that stay, or -1.
std::vector<Index> numbersOfKept(const RegionChoice& choice, RunContext& context) {
  std::vector<Index> numbers(choice.region.size());
  Index next = 0;
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (t % kPolled == 0) context.checkCancelled();
    numbers[t] = choice.keep[choice.region[t]] != 0 ? next++ : -1;
  }
  return numbers;
}

}  // namespace

// Removed parts do not come back when floors are cut anew. The outlines of earlier parts stay among the cuts, so a new
// triangle lies in an earlier part as a whole, and any inner point identifies it.
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

std::shared_ptr<const WalkableState> withRegions(const WalkableState& state, const RegionChoice& choice,
                                                 const SameFilter& sameOf, RunContext& context,
                                                 ExactFallbacks& fallbacks) {
  context.checkCancelled();
  const WalkableMesh& mesh = *state.mesh;
  auto kept = std::make_shared<WalkableMesh>();
  auto dropped = std::make_shared<WalkableMesh>();
  if (state.dropped) *dropped = *state.dropped;
  const std::vector<Index> renumbered = numbersOfKept(choice, context);
  const auto keep = [&] {
    const auto keptCount = static_cast<std::size_t>(
        std::count_if(renumbered.begin(), renumbered.end(), [](Index number) { return number >= 0; }));
    kept->triangles.resize(keptCount);
    if (!mesh.layers.empty()) kept->layers.resize(keptCount);
    forRanges(renumbered.size(), kTrianglesPerTask, [&](std::size_t first, std::size_t last) {
      context.checkCancelled();
      for (std::size_t t = first; t < last; ++t) {
        if (renumbered[t] < 0) continue;
        kept->triangles[renumbered[t]] = mesh.triangles[t];
        if (!mesh.layers.empty()) kept->layers[renumbered[t]] = mesh.layers[t];
      }
    });
  };
  const auto drop = [&] {
    std::vector<Index> droppedVertex(mesh.vertices.size(), -1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (t % kPolled == 0) context.checkCancelled();
      if (renumbered[t] >= 0) continue;
      MeshTriangle triangle = mesh.triangles[t];
      for (Index& v : triangle.corners) {
        if (droppedVertex[v] < 0) {
          droppedVertex[v] = static_cast<Index>(dropped->vertices.size());
          dropped->vertices.push_back(mesh.vertices[v]);
        }
        v = droppedVertex[v];
      }
      dropped->triangles.push_back(triangle);
    }
  };
  const bool isTaken = choice.isLast && state.mesh.use_count() == 1;
  std::shared_ptr<const Adjacency> topology;
  parallelInvoke(
      keep, drop,
      [&] { topology = std::make_shared<const Adjacency>(edgesOfSome(choice.topology, renumbered, context)); },
      [&] {
        if (!isTaken) kept->vertices = mesh.vertices;
      });
  if (isTaken) kept->vertices = std::move(ownMeshOf(state)->vertices);
  kept->layerCount = mesh.layerCount;
  kept->links = linksBetween(mesh.links, kept->triangles, *topology);
  kept->drops = dropsBetween(mesh, kept->triangles, renumbered, *topology);
  auto result = std::make_shared<WalkableState>(state);
  if (!state.cuts) {
    // Floors without cuts are in one region each: those that went are no floors for a later clearance filter.
    const auto keepFloorsOf = [&](const WalkableMesh& floors) {
      result->walkable.assign(state.walkable.size(), 0);
      for (const MeshTriangle& t : floors.triangles) result->walkable[t.face] = 1;
    };
    auto plain = std::make_shared<WalkableState>(state);
    plain->mesh = nullptr;
    plain->simplified = false;
    // Triangles of a simplified mesh may span several floors.
    if (!state.simplified)
      keepFloorsOf(*kept);
    else if (mesh.links.empty())
      result->walkable = sameOf(std::move(plain))->walkable;
    else  // Behind a clearance filter no floors overlap in one plane.
      keepFloorsOf(
          *withoutDropped(*state.kernel, *assembleMesh(*plain, context, fallbacks), *dropped, context, fallbacks));
    dropped = nullptr;  // rejected source triangles are obstacles as they are
  }
  result->topology = std::move(topology);
  result->topologyOwner = kept;
  result->mesh = std::move(kept);
  result->dropped = std::move(dropped);
  return result;
}

Text regionsRemoved(std::int64_t removed, std::int64_t all) {
  return all == 1 ? Text(FOOTFALL_TEXT("%1 of 1 region removed"), removed)
                  : Text(FOOTFALL_TEXT("%1 of %2 regions removed"), Text::count(removed), Text::count(all));
}

}  // namespace footfall::detail
