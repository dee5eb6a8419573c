// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/run_filters.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/number_text.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::test {
using namespace detail;
namespace {

using Edge = std::array<std::uint32_t, 2>;

double length(const NavigationMesh& mesh, const Edge& edge) {
  const Vec3 &a = mesh.vertices[edge[0]], &b = mesh.vertices[edge[1]];
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

Vec3 normal(const NavigationMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

std::size_t countRoots(std::vector<std::size_t>& parents, const std::vector<std::array<std::size_t, 2>>& pairs) {
  const auto find = [&](std::size_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
  };
  for (const auto& [a, b] : pairs) parents[find(a)] = find(b);
  std::size_t count = 0;
  for (std::size_t i = 0; i < parents.size(); ++i) count += parents[i] == i;
  return count;
}

Edge sorted(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

StatePtr runFilters(StatePtr state, const std::string& filters) {
  RunContext context;
  for (const PipelineStep& step : parsePipeline(filters, "test").steps)
    state = applyFilter(*step.filter, step.values, state, context).state;
  return state;
}

StatePtr runFilters(std::shared_ptr<const Environment> environment, const std::string& filters) {
  RunContext context;
  return runFilters(makeInitialState(std::move(environment), context), filters);
}

std::string minimalPipeline(double clearance, double slope) {
  std::string text = "SlopeFilter ";
  appendNumber(text, slope);
  text += " 0\nVerticalClearanceFilter ";
  appendNumber(text, clearance);
  return text + "\n";
}

NavigationMesh navigationMesh(const StatePtr& state) {
  RunContext context;
  return *makeNavigationMesh(state, context);
}

std::size_t countParts(const NavigationMesh& mesh) {
  std::map<Edge, std::size_t> first;
  std::vector<std::size_t> parents(mesh.triangles.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [it, isNew] = first.try_emplace(sorted(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]), i);
      if (!isNew) pairs.push_back({i, it->second});
    }
  }
  return countRoots(parents, pairs);
}

std::size_t countPartsByVertex(const NavigationMesh& mesh) {
  std::vector<std::size_t> first(mesh.vertices.size(), mesh.triangles.size());
  std::vector<std::size_t> parents(mesh.triangles.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      if (first[v] == mesh.triangles.size()) first[v] = i;
      pairs.push_back({i, first[v]});
    }
  }
  return countRoots(parents, pairs);
}

double area(const NavigationMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n = normal(mesh, t);
    sum += 0.5 * std::hypot(n.x, n.y, n.z);
  }
  return sum;
}

double planArea(const NavigationMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += 0.5 * normal(mesh, t).z;
  return sum;
}

double obstacleLength(const NavigationMesh& mesh) {
  double sum = 0;
  for (const Edge& edge : mesh.obstacleEdges) sum += length(mesh, edge);
  return sum;
}

double connectionLength(const NavigationMesh& mesh) {
  double sum = 0;
  for (const Edge& edge : mesh.connections) sum += length(mesh, edge);
  return sum;
}

std::string findMeshError(const NavigationMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  if (mesh.sourceTriangles.size() != count) return "sourceTriangles does not have one number for each triangle";
  if (!mesh.layers.empty() && mesh.layers.size() != count) return "layers does not have one number for each triangle";
  for (const std::uint32_t layer : mesh.layers)
    if (layer >= mesh.layerCount) return "layer out of range";
  std::map<Edge, int> uses;
  std::map<Edge, int> directed;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] >= mesh.vertices.size()) return "vertex index out of range";
      ++uses[sorted(t[k], t[(k + 1) % 3])];
      if (++directed[{t[k], t[(k + 1) % 3]}] > 1) return "two triangles on the same side of an edge";
    }
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const mpq_class ux = mpq_class(b.x) - mpq_class(a.x), uy = mpq_class(b.y) - mpq_class(a.y);
    const mpq_class vx = mpq_class(c.x) - mpq_class(a.x), vy = mpq_class(c.y) - mpq_class(a.y);
    if (ux * vy - uy * vx <= 0) return "a triangle does not face up";
  }
  for (const auto& [edge, n] : uses)
    if (n > 2) return "an edge has more than two triangles";
  for (const Edge& edge : mesh.obstacleEdges)
    if (uses[sorted(edge[0], edge[1])] != 1) return "an obstacle edge is not an edge of one side";
  for (const Edge& edge : mesh.connections)
    if (uses[sorted(edge[0], edge[1])] == 0) return "a connection is no edge of the mesh";
  return {};
}

}  // namespace footfall::test
