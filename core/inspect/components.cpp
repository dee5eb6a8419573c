// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/poll.hpp"
#include "core/base/sorted_list.hpp"
#include "core/base/vector.hpp"
#include "core/mesh/adjacency.hpp"
#include "footfall/inspect.hpp"

namespace footfall {
using namespace detail;
namespace {

constexpr std::size_t kPolled = 1 << 16;

void include(Component& component, const Vec3& p) {
  Vec3 &lower = component.lower, &upper = component.upper;
  lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
  upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
}

// Sums relative to the component's first vertex, so that a small component far from the origin keeps its digits.
void addTriangle(Component& component, const NavigationMesh& mesh, std::size_t t) {
  const Triangle& triangle = mesh.triangles[t];
  const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]], &c = mesh.vertices[triangle[2]];
  if (component.triangles == 0) {
    component.firstTriangle = static_cast<std::uint32_t>(t);
    component.lower = component.upper = a;
  }
  for (const Vec3& p : {a, b, c}) include(component, p);
  const Vec3& origin = mesh.vertices[mesh.triangles[component.firstTriangle][0]];
  // Infinite where doubles end, and never NaN, as the difference of two infinite products is.
  const double product = areaOf(a, b, c);
  const double area = std::isnan(product) ? std::numeric_limits<double>::infinity() : product;
  const auto middle = [](double p, double q, double r, double o) { return ((p - o) + (q - o) + (r - o)) / 3; };
  component.centre.x += area * middle(a.x, b.x, c.x, origin.x);
  component.centre.y += area * middle(a.y, b.y, c.y, origin.y);
  component.centre.z += area * middle(a.z, b.z, c.z, origin.z);
  component.area += area;
  ++component.triangles;
}

void finishCentre(Component& component, const NavigationMesh& mesh) {
  const Vec3& origin = mesh.vertices[mesh.triangles[component.firstTriangle][0]];
  Vec3& centre = component.centre;
  if (component.area > 0 && std::isfinite(component.area))
    centre = {origin.x + centre.x / component.area, origin.y + centre.y / component.area,
              origin.z + centre.z / component.area};
  else
    centre = origin;
}

/// Parts that a step leads between become one; they stay numbered in the order of their first triangles.
void joinOverLinks(const NavigationMesh& mesh, std::vector<Index>& partOf, Index& partCount) {
  DisjointSets sets(static_cast<std::size_t>(partCount));
  for (const StepLink& link : mesh.links) sets.unite(partOf[link.fromTriangle], partOf[link.toTriangle]);
  const std::vector<Index> joined = sets.numbers(partCount);
  for (Index& part : partOf) part = joined[part];
}

}  // namespace

double Components::totalArea() const {
  return std::accumulate(list.begin(), list.end(), 0.0,
                         [](double sum, const Component& component) { return sum + component.area; });
}

double Components::connectedShare() const {
  const double total = totalArea();
  if (!(total > 0)) return 0;
  if (std::isinf(total)) {  // areas beyond all doubles count alike, and all others for nothing
    const auto count = std::count_if(list.begin(), list.end(), [](const Component& c) { return std::isinf(c.area); });
    return count > 0 ? 1.0 / static_cast<double>(count) : 0;
  }
  return std::accumulate(list.begin(), list.end(), 0.0, [total](double sum, const Component& component) {
    const double share = component.area / total;
    return sum + share * share;
  });
}

Components findComponents(const NavigationMesh& mesh, const RunContext* context) {
  const Poll poll(context);
  Index count = 0;
  std::vector<Index> region = findParts(mesh.triangles, mesh.vertices.size(), count, poll);
  if (!mesh.links.empty()) joinOverLinks(mesh, region, count);
  poll();

  std::vector<Component> found(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (t % kPolled == 0) poll();
    addTriangle(found[region[t]], mesh, t);
    // Triangles come by layer.
    auto& layers = found[region[t]].layers;
    if (!mesh.layers.empty() && (layers.empty() || layers.back() != mesh.layers[t])) layers.push_back(mesh.layers[t]);
  }
  for (Component& component : found) {
    finishCentre(component, mesh);
    sortOnce(component.layers);
  }

  std::vector<std::uint32_t> order(found.size()), rank(found.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (found[a].area != found[b].area) return found[a].area > found[b].area;
    return found[a].firstTriangle < found[b].firstTriangle;
  });
  Components components;
  components.list.reserve(found.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    rank[order[place]] = static_cast<std::uint32_t>(place);
    components.list.push_back(std::move(found[order[place]]));
  }
  components.ofTriangle.reserve(region.size());
  for (const Index r : region) components.ofTriangle.push_back(rank[r]);
  return components;
}

}  // namespace footfall
