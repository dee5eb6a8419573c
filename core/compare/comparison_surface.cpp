// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/vector.hpp"
#include "core/exact/grid.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail::comparison {
namespace {

constexpr std::size_t kRange = 4096;

bool before(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

Positions collectPositions(const NavigationMesh& a, const NavigationMesh& b, double extra, RunContext& context) {
  Positions all;
  for (const NavigationMesh* mesh : {&a, &b}) {
    std::vector<bool> used(mesh->vertices.size(), false);
    for (const Triangle& triangle : mesh->triangles)
      for (const std::uint32_t v : triangle) used[v] = true;
    for (const StepLink& link : mesh->links)
      for (const std::uint32_t v : {link.from[0], link.from[1], link.to[0], link.to[1]}) used[v] = true;
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v]) all.places.push_back(mesh->vertices[v]);
  }
  context.checkCancelled();
  parallelSort(all.places.begin(), all.places.end(), before);
  all.places.erase(std::unique(all.places.begin(), all.places.end()), all.places.end());
  Grid grid;
  grid.include(extra);
  for (const Vec3& p : all.places)
    for (const double x : {p.x, p.y, p.z}) grid.include(x);
  all.unit = grid.empty() ? 0 : grid.low;
  all.width = grid.width();
  all.integers.resize(all.places.size());
  forRanges(all.places.size(), kRange, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t i = first; i < last; ++i) {
      const Vec3& p = all.places[i];
      all.integers[i] = {onGrid(p.x, all.unit), onGrid(p.y, all.unit), onGrid(p.z, all.unit)};
    }
  });
  return all;
}

Surface makeSurface(const NavigationMesh& mesh, const std::vector<Vec3>& places, RunContext& context) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices.size(), kUnused);
  const auto numberOf = [&](std::uint32_t v) {
    if (number[v] == kUnused) {
      const auto found = std::lower_bound(places.begin(), places.end(), mesh.vertices[v], before);
      number[v] = static_cast<std::uint32_t>(found - places.begin());
    }
    return number[v];
  };
  Surface surface;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % kRange == 0) context.checkCancelled();
    const Triangle& t = mesh.triangles[i];
    if (isDegenerate(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]])) continue;
    surface.triangles.push_back({numberOf(t[0]), numberOf(t[1]), numberOf(t[2])});
    surface.numbers.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<bool> used(places.size(), false);
  for (const Triangle& triangle : surface.triangles)
    for (const std::uint32_t v : triangle) used[v] = true;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) surface.positions.push_back(static_cast<std::uint32_t>(v));
  return surface;
}

}  // namespace

mpz_class onGrid(double x, int unit) {
  int exponent = 0;
  const double digits = std::ldexp(std::frexp(x, &exponent), 53);
  mpz_class result(digits);  // a whole number below 2^53
  const int shift = exponent - 53 - unit;
  if (shift >= 0) {
    result <<= static_cast<unsigned>(shift);
  } else {
    result >>= static_cast<unsigned>(-shift);  // only zeros go: the number lies on the grid
  }
  return result;
}

std::array<mpz_class, 3> exactNormal(const Positions& positions, const Triangle& triangle) {
  const auto& [a, b, c] =
      std::tie(positions.integers[triangle[0]], positions.integers[triangle[1]], positions.integers[triangle[2]]);
  return cross(b - a, c - a);
}

ComparedSurfaces makeSurfaces(const NavigationMesh& a, const NavigationMesh& b, double extra, RunContext& context) {
  ComparedSurfaces result;
  result.positions = collectPositions(a, b, extra, context);
  result.surfaces = {makeSurface(a, result.positions.places, context),
                     makeSurface(b, result.positions.places, context)};
  return result;
}

}  // namespace footfall::detail::comparison
