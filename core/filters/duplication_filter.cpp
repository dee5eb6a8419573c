// DuplicationFilter: vertices closer than a distance become one (model, Duplication, thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clusters are the classes of the relation "joined by a chain of vertices, each closer than the distance to the next",
// over all vertices of the environment, floors and obstacles alike. All vertices of a cluster move to its first one by
// x, then y, then z. Both are properties of the set of positions, so the order of the input cannot matter, and
// afterwards no two vertices are closer than the distance.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "core/base/counted_text.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/rounding/generation.hpp"

namespace footfall::detail {
namespace {

bool isCloser(const Vec3& a, const Vec3& b, double distance) {
  const double dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
  const double squared = dx * dx + dy * dy + dz * dz, limit = distance * distance;
  // Four roundings on either side at most; where that is not clear, or something overflows or vanishes, exactly.
  const double bound = (squared + limit) * (8 * 0x1p-53);
  if (std::isfinite(squared) && limit > 0x1p-900) {
    if (squared < limit - bound) return true;
    if (squared > limit + bound) return false;
  }
  const mpq_class ex = mpq_class(a.x) - mpq_class(b.x), ey = mpq_class(a.y) - mpq_class(b.y),
                  ez = mpq_class(a.z) - mpq_class(b.z), d(distance);
  return ex * ex + ey * ey + ez * ez < d * d;
}

/// Cubes of the size of the distance: only neighbouring cubes can hold vertices that are closer.
struct CubeHash {
  std::size_t operator()(const std::array<std::int64_t, 3>& c) const {
    std::uint64_t h = 0x243F6A8885A308D3ULL;
    for (const std::int64_t x : c) {
      h = (h ^ static_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    return h;
  }
};

// The last cube: beyond it doubles are farther apart than the distance, or so far out that they share one last cube.
std::int64_t cubeOf(double x, double distance) {
  return static_cast<std::int64_t>(std::floor(std::clamp(x / distance, -0x1p52, 0x1p52)));
}

// The first place of the cluster of each place; places are sorted and distinct.
std::vector<Index> clusterPlaces(const std::vector<Vec3>& places, double distance, RunContext& context) {
  std::unordered_map<std::array<std::int64_t, 3>, std::vector<Index>, CubeHash> cubes;
  DisjointSets sets(places.size());
  for (Index i = 0; i < static_cast<Index>(places.size()); ++i) {
    if ((i & 255) == 0) context.checkCancelled();
    const Vec3& p = places[i];
    const std::array<std::int64_t, 3> cube{cubeOf(p.x, distance), cubeOf(p.y, distance), cubeOf(p.z, distance)};
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          const auto it = cubes.find({cube[0] + dx, cube[1] + dy, cube[2] + dz});
          if (it == cubes.end()) continue;
          for (const Index j : it->second)
            if (sets.find(i) != sets.find(j) && isCloser(p, places[j], distance)) sets.unite(i, j);
        }
    cubes[cube].push_back(i);
  }
  std::vector<Index> first(places.size());
  for (Index i = 0; i < static_cast<Index>(places.size()); ++i) first[i] = sets.find(i);
  return first;
}

}  // namespace

FilterOutcome applyDuplication(const StatePtr& state, double distance, RunContext& context) {
  FilterOutcome outcome;
  outcome.state = state;
  if (distance == 0) {
    // Equal positions are one vertex from the start; say how many there were.
    const std::size_t given = state->environment->vertices.size();
    outcome.note = Text(
        FOOTFALL_TEXT("%1 at %2"), countedText(given, FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices")),
        countedText(state->kernel->mesh().vertices.size(), FOOTFALL_TEXT("1 position"), FOOTFALL_TEXT("%1 positions")));
    return outcome;
  }
  GenerationSoup soup = makeGenerationSoup(state, context, outcome.fallbacks);
  std::vector<Vec3>& vertices = soup.vertices;
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::array{vertices[i].x, vertices[i].y, vertices[i].z}; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<Vec3> places;
  std::vector<Index> placeOf(vertices.size());
  for (const std::size_t i : order) {
    if (places.empty() || !(places.back() == vertices[i])) places.push_back(vertices[i]);
    placeOf[i] = static_cast<Index>(places.size()) - 1;
  }
  const std::vector<Index> first = clusterPlaces(places, distance, context);
  std::size_t moved = 0;
  for (Index i = 0; i < static_cast<Index>(first.size()); ++i) moved += first[i] != i;
  outcome.note = countedText(moved, FOOTFALL_TEXT("1 vertex merged"), FOOTFALL_TEXT("%1 vertices merged"));
  if (moved == 0) return outcome;
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = places[first[placeOf[i]]];
  outcome.state = nextGeneration(*state, soup, true, context, outcome.fallbacks);
  if (state->mesh && !state->mesh->layers.empty())
    outcome.state = applyLayerSubdivision(outcome.state, {}, context).state;
  return outcome;
}

}  // namespace footfall::detail
