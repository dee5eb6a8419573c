// ReachableFilter: keeps the regions that hold a seed, and those that drops lead to from there (model, Reachable
// places).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A seed is a point of doubles and so exact. It means the highest walkable place at or under it; triangles are taken
// with their outlines, so that on an edge or a corner it means all regions that meet there at that height. Rounded
// places with their bounds leave a few triangles for each seed; rational numbers decide about those.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/assembly/dropped_parts.hpp"
#include "core/assembly/mesh_assembly.hpp"
#include "core/base/number_text.hpp"
#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kNumbers = 3;  // of a seed
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using PlanPlace = std::array<mpq_class, 2>;

mpq_class crossOf(const PlanPlace& a, const PlanPlace& b, const PlanPlace& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// The height of a face's plane, which is not vertical, at a place in the plan.
mpq_class heightAt(const SourceMesh& source, Index face, const PlanPlace& place) {
  std::array<std::array<mpq_class, 3>, 3> v;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = source.vertices[source.triangles[face][k]];
    v[k] = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
  }
  const auto [nx, ny, nz] = cross(v[1] - v[0], v[2] - v[0]);
  return v[0][2] - (nx * (place[0] - v[0][0]) + ny * (place[1] - v[0][1])) / nz;
}

class SeedFinder {
 public:
  SeedFinder(const WalkableState& state, std::vector<Vec3> seeds) : state_(state), seeds_(std::move(seeds)) {
    const int scale = state.kernel->mesh().grid.scaleExponent();
    // Exact but where a number becomes too small for a double.
    const auto scaled = [&](double coordinate) {
      const double value = std::ldexp(coordinate, scale);
      const bool isExact = std::ldexp(value, -scale) == coordinate;
      return ErrorDouble(value, isExact ? 0 : std::numeric_limits<double>::denorm_min());
    };
    for (std::size_t s = 0; s < seeds_.size(); ++s) byX_.push_back({scaled(seeds_[s].x), scaled(seeds_[s].y), s});
    std::ranges::sort(byX_, {}, [](const Scaled& s) { return std::pair(s.x.value, s.number); });
  }

  /// The triangles of each seed: those that hold the seed's place at the height that the seed stands for; ascending.
  /// Throws ValueError for the first seed without one.
  std::vector<std::vector<Index>> find(RunContext& context) const {
    std::vector<std::vector<Index>> under = findUnder(context);
    std::vector<std::optional<mpq_class>> depths(seeds_.size());
    parallelFor(seeds_.size(), [&](std::size_t s) {
      context.checkCancelled();
      depths[s] = keepHighest(s, under[s], context);
    });
    for (std::size_t s = 0; s < seeds_.size(); ++s)
      if (!depths[s] || (state_.agentHeight > 0 && *depths[s] > mpq_class(state_.agentHeight))) fail(s, depths[s]);
    return under;
  }

 private:
  /// A place in the scaled coordinates of a mesh.
  struct Scaled {
    ErrorDouble x, y;
    std::size_t number = 0;
  };

  // The triangles at each seed's place in the plan, outlines included.
  [[nodiscard]] std::vector<std::vector<Index>> findUnder(RunContext& context) const {
    const WalkableMesh& mesh = *state_.mesh;
    using Pair = std::pair<std::size_t, Index>;
    PerThread<std::vector<Pair>> found;
    parallelRanges(mesh.triangles.size(), 4096, [&](const auto& range) {
      context.checkCancelled();
      std::vector<Pair>& here = found.local();
      for (std::size_t t = range.begin(); t != range.end(); ++t)
        visitNear(mesh.triangles[t], [&](const Scaled& seed) {
          if (isUnder(mesh.triangles[t], seed)) here.emplace_back(seed.number, static_cast<Index>(t));
        });
    });
    std::vector<std::vector<Index>> under(seeds_.size());
    for (const std::vector<Pair>& pairs : found)
      for (const auto& [seed, triangle] : pairs) under[seed].push_back(triangle);
    for (std::vector<Index>& triangles : under) std::ranges::sort(triangles);
    return under;
  }

  // Seeds that may be over a triangle by its box. Scaling may have cut something off where a number became tiny.
  template <class Visit>
  void visitNear(const MeshTriangle& t, const Visit& visit) const {
    double left = kInfinity, right = -kInfinity, near = kInfinity, far = -kInfinity;
    for (const Index corner : t.corners) {
      const MeshVertex& v = state_.mesh->vertices[corner];
      left = std::min(left, std::nextafter(v.x - v.error, -kInfinity));
      right = std::max(right, std::nextafter(v.x + v.error, kInfinity));
      near = std::min(near, std::nextafter(v.y - v.error, -kInfinity));
      far = std::max(far, std::nextafter(v.y + v.error, kInfinity));
    }
    const auto xOf = [](const Scaled& seed) { return seed.x.value; };
    for (auto seed = std::ranges::lower_bound(byX_, left, {}, xOf); seed != byX_.end() && xOf(*seed) <= right; ++seed)
      if (seed->y.value >= near && seed->y.value <= far) visit(*seed);
  }

  [[nodiscard]] bool isUnder(const MeshTriangle& t, const Scaled& seed) const {
    bool isDecided = true;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex &a = vertex(t, k), &b = vertex(t, next(k));
      const ErrorDouble ax(a.x, a.error), ay(a.y, a.error), bx(b.x, b.error), by(b.y, b.error);
      const MaybeSign side = state_.kernel->sign()((bx - ax) * (seed.y - ay) - (by - ay) * (seed.x - ax));
      if (side == -1) return false;
      isDecided = isDecided && side.has_value();
    }
    if (isDecided) return true;
    std::array<PlanPlace, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = exactPlace(vertex(t, k));
    const PlanPlace place = exactPlace(seed.number);
    for (int k = 0; k < 3; ++k)
      if (crossOf(corners[k], corners[next(k)], place) < 0) return false;
    return true;
  }

  // The distance of the triangles below the seed.
  std::optional<mpq_class> keepHighest(std::size_t s, std::vector<Index>& triangles, RunContext& context) const {
    const std::vector<MeshTriangle>& all = state_.mesh->triangles;
    const PlanPlace place = exactPlace(s);
    const mpq_class z(seeds_[s].z);
    std::map<Index, mpq_class> heights;  // of planes
    std::optional<mpq_class> highest;
    for (const Index t : triangles) {
      const auto [entry, isNew] = heights.try_emplace(all[t].face);
      if (!isNew) continue;
      context.checkCancelled();
      entry->second = heightAt(state_.kernel->mesh(), all[t].face, place);
      if (entry->second <= z && (!highest || entry->second > *highest)) highest = entry->second;
    }
    if (!highest) return std::nullopt;
    std::erase_if(triangles, [&](Index t) { return heights.at(all[t].face) != *highest; });
    return mpq_class(z - *highest);
  }

  // `depth`: how far under the seed the highest walkable place is, where there is one.
  [[noreturn]] void fail(std::size_t s, const std::optional<mpq_class>& depth) const {
    const auto textOf = [](double number) {
      std::string text;
      appendNumber(text, number);
      return text;
    };
    const Vec3 p = inFileFrame(seeds_[s], state_.environment->up);
    const Text seed(FOOTFALL_TEXT("seed %1 at %2 %3 %4"), s + 1, textOf(p.x), textOf(p.y), textOf(p.z));
    if (!depth)
      throw ValueError(kNumbers * s,
                       {FOOTFALL_TEXT("%1 has no walkable place under it; move it over one, or remove it"), seed});
    throw ValueError(kNumbers * s,
                     {FOOTFALL_TEXT("%1 is %2 above the next walkable place, more than the clearance of %3; move it "
                                    "nearer to a walkable place, or remove it"),
                      seed, textOf(depth->get_d()), textOf(state_.agentHeight)});
  }

  [[nodiscard]] const MeshVertex& vertex(const MeshTriangle& t, int k) const {
    return state_.mesh->vertices[t.corners[k]];
  }
  [[nodiscard]] PlanPlace exactPlace(std::size_t seed) const {
    return {mpq_class(seeds_[seed].x), mpq_class(seeds_[seed].y)};
  }
  [[nodiscard]] PlanPlace exactPlace(const MeshVertex& v) const {
    if (v.source >= 0) {
      const Vec3& p = state_.kernel->mesh().vertices[v.source];
      return {mpq_class(p.x), mpq_class(p.y)};
    }
    const auto p = state_.kernel->exactPosition(v.point, v.face);
    return {p[0], p[1]};
  }

  const WalkableState& state_;
  std::vector<Vec3> seeds_;  ///< Z up
  std::vector<Scaled> byX_;
};

std::vector<Vec3> placesOf(std::span<const double> numbers, UpAxis up) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i + kNumbers <= numbers.size(); i += kNumbers)
    places.push_back(fromFileFrame({numbers[i], numbers[i + 1], numbers[i + 2]}, up));
  return places;
}

/// Keeps the regions to which drops lead from those that are kept.
void followDrops(const WalkableMesh& mesh, const Adjacency& topology, const std::vector<Index>& region,
                 std::vector<char>& keep) {
  std::vector<std::vector<Index>> below(keep.size());
  for (const MeshDrop& drop : mesh.drops) {
    const Index side = findSide(mesh.triangles, topology, drop.edge[0], drop.edge[1]);
    if (side >= 0) below[region[side / 3]].push_back(region[drop.triangle]);
  }
  std::vector<Index> open;
  for (std::size_t r = 0; r < keep.size(); ++r)
    if (keep[r] != 0) open.push_back(static_cast<Index>(r));
  while (!open.empty()) {
    const Index from = open.back();
    open.pop_back();
    for (const Index to : below[from]) {
      if (keep[to] != 0) continue;
      keep[to] = 1;
      open.push_back(to);
    }
  }
}

}  // namespace

FilterOutcome applyReachable(const StatePtr& given, std::span<const double> seeds, RunContext& context) {
  FilterOutcome outcome;
  const StatePtr state = withMesh(given, context, outcome.fallbacks);
  const SeedFinder finder(*state, placesOf(seeds, state->environment->up));
  const std::vector<std::vector<Index>> triangles = finder.find(context);
  const auto topology = topologyOf(*state, context);
  Index regionCount = 0;
  const std::vector<Index> region = findRegions(*state->mesh, *topology, regionCount);
  std::vector<char> keep(regionCount, 0);
  for (const std::vector<Index>& meant : triangles)
    for (const Index t : meant) keep[region[t]] = 1;
  followDrops(*state->mesh, *topology, region, keep);
  const auto removed = std::ranges::count(keep, 0);
  if (removed > 0) {
    outcome.state = withRegions(
        *state, {*topology, region, keep},
        [&](const StatePtr& other) { return applyReachable(other, seeds, context).state; }, context, outcome.fallbacks);
    outcome.note = regionsRemoved(removed, regionCount);
    return outcome;
  }
  auto known = std::make_shared<WalkableState>(*state);
  known->topology = topology;
  known->topologyOwner = state->mesh;
  outcome.state = std::move(known);
  return outcome;
}

}  // namespace footfall::detail
