// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_pages.hpp"

#include <algorithm>
#include <map>

#include "core/base/vector.hpp"
#include "core/mesh/adjacency.hpp"

namespace footfall::detail {
namespace {

constexpr double kNear = 0.25;   // share of the agent's height: floors at about one level
constexpr double kLeast = 0.05;  // share of the largest storey: smaller ones are landings

struct Level {
  double height = 0, area = 0;
};

double planAreaOf(const NavigationMesh& mesh, const Triangle& t) {
  return normalOf(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]).z / 2;
}

double middleOf(const NavigationMesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[0]].z + mesh.vertices[t[1]].z + mesh.vertices[t[2]].z) / 3;
}

/// Ascending.
std::vector<double> storeyHeights(const NavigationMesh& mesh, double agentHeight) {
  std::map<double, double> areas;
  for (const Triangle& t : mesh.triangles) areas[middleOf(mesh, t)] += planAreaOf(mesh, t);
  // Each with what lies about as high.
  std::vector<Level> levels;
  double sum = 0;
  for (auto at = areas.begin(), first = at, last = at; at != areas.end(); ++at) {
    for (; last != areas.end() && last->first <= at->first + kNear * agentHeight; ++last) sum += last->second;
    for (; first->first < at->first - kNear * agentHeight; ++first) sum -= first->second;
    levels.push_back({at->first, sum + at->second});
  }
  std::stable_sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) { return a.area > b.area; });
  std::vector<double> heights;
  for (const Level& level : levels) {
    if (level.area < kLeast * levels.front().area) break;
    const bool isFar = std::all_of(heights.begin(), heights.end(),
                                   [&](double height) { return std::abs(height - level.height) >= agentHeight; });
    if (isFar) heights.push_back(level.height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

std::vector<std::size_t> pageNumbers(const NavigationMesh& mesh, PlanPages pages, double agentHeight,
                                     double agentStep) {
  std::vector<std::size_t> numbers(mesh.triangles.size(), 0);
  if (pages == PlanPages::Layers) {
    if (!mesh.layers.empty()) std::copy(mesh.layers.begin(), mesh.layers.end(), numbers.begin());
    return numbers;
  }
  const std::vector<double> heights = storeyHeights(mesh, agentHeight);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double height = middleOf(mesh, mesh.triangles[i]) + std::max(agentStep, kNear * agentHeight);
    const auto above = std::upper_bound(heights.begin(), heights.end(), height);
    numbers[i] = above == heights.begin() ? 0 : static_cast<std::size_t>(above - heights.begin()) - 1;
  }
  return numbers;
}

}  // namespace

std::vector<PlanPage> makePlanPages(const NavigationMesh& mesh, PlanPages pages, double agentHeight, double agentStep,
                                    Poll poll) {
  std::vector<std::size_t> pageOf = pageNumbers(mesh, pages, agentHeight, agentStep);
  std::vector<std::size_t> counts;
  for (const std::size_t page : pageOf) {
    if (page >= counts.size()) counts.resize(page + 1);
    ++counts[page];
  }
  std::vector<PlanPage> made;
  std::vector<std::size_t> renumbered(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    renumbered[i] = made.size();
    if (counts[i] == 0) continue;
    const bool isStorey = pages == PlanPages::Storeys;
    // Layers are numbered as in exports, storeys as people count.
    const std::string name = isStorey ? "storey " + std::to_string(made.size() + 1) : "layer " + std::to_string(i);
    made.push_back({mesh.layers.empty() && !isStorey ? std::string("walkable area") : name, {}, {}});
  }
  for (std::size_t t = 0; t < pageOf.size(); ++t) {
    pageOf[t] = renumbered[pageOf[t]];
    made[pageOf[t]].triangles.push_back(static_cast<std::uint32_t>(t));
  }

  const TriangleCorners corners(mesh.triangles);
  const Adjacency edges = findEdges(corners, mesh.vertices.size(), poll);
  for (Index e = 0; e < edges.edgeCount(); ++e) {
    const auto sides = edges.sidesOf(e);
    if (sides.size() != 2) continue;
    const std::size_t a = pageOf[sides[0] / 3], b = pageOf[sides[1] / 3];
    if (a == b) continue;
    const std::array<std::uint32_t, 2> edge{static_cast<std::uint32_t>(corners.beginOf(sides[0])),
                                            static_cast<std::uint32_t>(corners.endOf(sides[0]))};
    made[a].passages.push_back({edge, b});
    made[b].passages.push_back({edge, a});
  }
  for (const StepLink& link : mesh.links) {
    const std::size_t a = pageOf[link.fromTriangle], b = pageOf[link.toTriangle];
    if (a == b) continue;
    made[a].passages.push_back({link.from, b});
    made[b].passages.push_back({link.to, a});
  }
  return made;
}

}  // namespace footfall::detail
