// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/known_overlaps.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/assembly/mesh_relation.hpp"
#include "core/base/box_tree.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/layers/double_cover.hpp"
#include "core/filters/layers/growing_boxes.hpp"
#include "core/filters/layers/layer_pieces.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPerTask = 64, kMostPairsOfTriangle = 8, kMostTestsOfTriangle = 256;

/// Compares triangles of no group with all, and settles them. Leaves all as it is where too many overlap, or too many
/// are near each other.
void settle(KnownOverlaps& known, const PlanKernel& kernel, const WalkableMesh& mesh, const PlanTriangles& plan,
            RunContext& context, ExactFallbacks& fallbacks) {
  std::vector<Index> changed;
  for (std::size_t t = 0; t < known.group.size(); ++t)
    if (known.group[t] < 0) changed.push_back(static_cast<Index>(t));
  BoxTree<2> tree;
  tree.build(
      changed, [&](Index t) { return plan.boundsOf(t); }, context);
  struct Local {
    MeshGeometry geometry;
    std::vector<std::array<Index, 2>> found;
  };
  PerThread<Local> locals([&] { return Local{MeshGeometry(kernel, mesh.vertices), {}}; });
  const std::size_t most = kMostPairsOfTriangle * known.group.size();
  const std::size_t mostTests = kMostTestsOfTriangle * known.group.size();
  std::atomic<std::size_t> count = 0, tests = 0;
  parallelRanges(known.group.size(), kPerTask, [&](const auto& range) {
    Local& local = locals.local();
    context.checkCancelled();
    for (std::size_t i = range.begin(); i != range.end() && count <= most && tests <= mostTests; ++i) {
      std::size_t own = 0;
      const auto t = static_cast<Index>(i);
      const BoxTree<2>::Bounds& bounds = plan.boundsOf(t);
      tree.visitOverlapping(bounds, [&](Index o) {
        if ((known.group[i] < 0 && o <= t) || haveApartInsides(bounds, plan.boundsOf(o))) return;
        ++own;
        if (!local.geometry.overlap(plan.planOf(t), plan.planOf(o)) || ++count > most) return;
        local.found.push_back({t, o});
      });
      tests += own;
    }
  });
  if (count > most || tests > mostTests) return;  // the place where it stopped depends on threads
  for (Local& local : locals) {
    known.pairs.insert(known.pairs.end(), local.found.begin(), local.found.end());
    local.found = {};
    fallbacks += local.geometry.fallbacks;
  }
  for (const Index t : changed) known.group[t] = kSettled;
}

/// The number in the earlier mesh of each triangle with the same places in the plan, or -1. Triangles of a face that
/// was divided anew are in another order than they were: those are looked up by their corners.
std::vector<Index> trianglesBefore(MeshRelation relation, const WalkableMesh& before, const WalkableMesh& now) {
  using Corners = std::array<Index, 3>;
  std::vector<Index>& triangles = relation.triangleBefore;
  std::vector<char> isRelated(before.triangles.size(), 0);
  for (const Index then : triangles)
    if (then >= 0) isRelated[then] = 1;
  std::vector<std::pair<Corners, Index>> others;
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    if (isRelated[t] != 0) continue;
    Corners corners = before.triangles[t].corners;
    std::sort(corners.begin(), corners.end());
    others.emplace_back(corners, static_cast<Index>(t));
  }
  std::sort(others.begin(), others.end());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (triangles[t] >= 0) continue;
    Corners corners = now.triangles[t].corners;
    for (Index& v : corners) v = relation.vertexBefore[v];
    std::sort(corners.begin(), corners.end());
    const auto same = std::lower_bound(others.begin(), others.end(), std::pair{corners, Index{0}});
    if (same == others.end() || same->first != corners || isRelated[same->second] != 0) continue;
    triangles[t] = same->second;  // a second triangle with the same corners is not related
    isRelated[same->second] = 1;
  }
  return std::move(triangles);
}

}  // namespace

KnownOverlaps knownFrom(const StatePtr& before, const PlanKernel& kernel, const WalkableMesh& mesh,
                        const PlanTriangles& plan, RunContext& context, ExactFallbacks& fallbacks) {
  const auto earlier = EarlierResult::relate(before, kernel);
  if (!earlier || !before->overlaps || before->mesh->layers.empty()) return {};
  MeshRelation relation = relateMeshes(*earlier, *before->mesh, mesh);
  context.checkCancelled();
  if (2 * static_cast<std::size_t>(relation.related) <= mesh.triangles.size()) return {};
  KnownOverlaps known;
  known.group.assign(mesh.triangles.size(), -1);
  const std::vector<Index> trianglesThen = trianglesBefore(std::move(relation), *before->mesh, mesh);
  std::vector<Index> now(before->mesh->triangles.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Index then = trianglesThen[t];
    if (then < 0) continue;
    now[then] = static_cast<Index>(t);
    known.group[t] = static_cast<Index>(before->mesh->layers[then]);
  }
  for (const auto& [s, t] : *before->overlaps)
    if (now[s] >= 0 && now[t] >= 0) known.pairs.push_back({now[s], now[t]});
  settle(known, kernel, mesh, plan, context, fallbacks);
  return known;
}

std::vector<char> findRegionsAboveThemselves(const std::vector<Index>& regionOf, Index regionCount,
                                             const KnownOverlaps& known, const PlanKernel* kernel,
                                             const WalkableMesh& mesh, const Adjacency& topology, RunContext& context,
                                             ExactFallbacks& fallbacks) {
  std::vector<char> divided(regionCount, 0);
  for (const auto& [s, t] : known.pairs)
    if (regionOf[s] == regionOf[t]) divided[regionOf[s]] = 1;
  if (known.isAll) return divided;

  // A region of one group, and of triangles of which all overlaps are known, lies above itself where a pair shows it.
  std::vector<char> isSwept(regionCount, static_cast<char>(known.group.empty()));
  std::vector<Index> main(regionCount, kSettled);
  for (std::size_t t = 0; t < known.group.size(); ++t) {
    if (known.group[t] == kSettled) continue;
    Index& own = main[regionOf[t]];
    if (own == kSettled) own = known.group[t];
    if (own < 0 || own != known.group[t]) isSwept[regionOf[t]] = 1;
  }
  std::vector<Index> setOf = regionOf;
  bool isAny = false;
  for (Index& set : setOf) {
    if (isSwept[set] == 0 || divided[set] != 0)
      set = -1;
    else
      isAny = true;
  }
  if (!isAny) return divided;
  const std::vector<char> swept = findDoubleCovers(setOf, regionCount, findTrianglesAcross(mesh, topology, context),
                                                   *kernel, mesh, context, fallbacks);
  for (Index r = 0; r < regionCount; ++r)
    if (swept[r] != 0) divided[r] = 1;
  return divided;
}

}  // namespace footfall::detail
