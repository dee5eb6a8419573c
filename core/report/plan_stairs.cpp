// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_stairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/mesh/adjacency.hpp"

namespace footfall::detail {
namespace {

constexpr double kStraight = 0.9;  // the cosine up to which steps are in a row
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A step from its lower side, which has the walkable area on the left.
struct Step {
  PlanPlace a{}, b{};
  double length = 0;
  std::uint32_t lower = 0, upper = 0;  ///< triangles
  Index lowerTread = 0, upperTread = 0;
};

std::vector<Step> stepsOf(const NavigationMesh& mesh, const std::vector<Index>& treads) {
  std::vector<Step> steps;
  for (const StepLink& link : mesh.links) {
    if (link.kind != StepKind::Step) continue;
    const auto heightOf = [&mesh](const std::array<std::uint32_t, 2>& edge) {
      return mesh.vertices[edge[0]].z + mesh.vertices[edge[1]].z;
    };
    const bool isUp = heightOf(link.from) <= heightOf(link.to);
    const auto& edge = isUp ? link.from : link.to;
    Step step;
    step.a = {mesh.vertices[edge[0]].x, mesh.vertices[edge[0]].y};
    step.b = {mesh.vertices[edge[1]].x, mesh.vertices[edge[1]].y};
    step.length = std::hypot(step.b[0] - step.a[0], step.b[1] - step.a[1]);
    step.lower = isUp ? link.fromTriangle : link.toTriangle;
    step.upper = isUp ? link.toTriangle : link.fromTriangle;
    step.lowerTread = treads[step.lower];
    step.upperTread = treads[step.upper];
    if (step.length > 0) steps.push_back(step);
  }
  return steps;
}

bool isInRow(const Step& s, const Step& t) {
  if (s.lowerTread != t.lowerTread || s.upperTread != t.upperTread) return false;
  const double cosine =
      ((s.b[0] - s.a[0]) * (t.b[0] - t.a[0]) + (s.b[1] - s.a[1]) * (t.b[1] - t.a[1])) / (s.length * t.length);
  return cosine > kStraight;
}

std::vector<PlanFlight::Riser> joinSteps(const std::vector<Step>& steps, std::vector<const Step*>& firsts) {
  std::map<PlanPlace, std::vector<Index>> beginning;
  for (std::size_t i = 0; i < steps.size(); ++i) beginning[steps[i].a].push_back(static_cast<Index>(i));
  DisjointSets rows(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto next = beginning.find(steps[i].b);
    if (next == beginning.end()) continue;
    for (const Index k : next->second)
      if (isInRow(steps[i], steps[k])) rows.unite(static_cast<Index>(i), k);
  }
  Index count = 0;
  const std::vector<Index> rowOf = rows.numbers(count);
  std::vector<PlanFlight::Riser> risers(static_cast<std::size_t>(count));
  firsts.assign(risers.size(), nullptr);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& s = steps[i];
    PlanFlight::Riser& riser = risers[rowOf[i]];
    if (firsts[rowOf[i]] == nullptr) {
      firsts[rowOf[i]] = &s;
      riser.lower = s.lower;
      riser.upper = s.upper;
    }
    riser.length += s.length;
    for (int k = 0; k < 2; ++k) riser.middle[k] += s.length * (s.a[k] + s.b[k]) / 2;
    // The direction is to the right of the lower border.
    riser.up[0] += s.b[1] - s.a[1];
    riser.up[1] -= s.b[0] - s.a[0];
  }
  for (PlanFlight::Riser& riser : risers) {
    const double norm = std::hypot(riser.up[0], riser.up[1]);
    for (int k = 0; k < 2; ++k) {
      riser.middle[k] /= riser.length;
      riser.up[k] = norm > 0 ? riser.up[k] / norm : 0;
    }
  }
  return risers;
}

}  // namespace

std::vector<PlanFlight> findFlights(const NavigationMesh& mesh, double longestTread, Poll poll) {
  Index treadCount = 0;
  const std::vector<Index> treads = findParts(mesh.triangles, mesh.vertices.size(), treadCount, poll);
  const std::vector<Step> steps = stepsOf(mesh, treads);
  std::vector<const Step*> firsts;
  const std::vector<PlanFlight::Riser> risers = joinSteps(steps, firsts);
  poll();

  // The longest riser down from each tread, and up.
  std::vector<std::size_t> down(static_cast<std::size_t>(treadCount), kNone), up(down);
  const auto prefer = [&risers](std::size_t& best, std::size_t riser) {
    if (best == kNone || risers[riser].length > risers[best].length) best = riser;
  };
  for (std::size_t i = 0; i < risers.size(); ++i) {
    prefer(up[firsts[i]->lowerTread], i);
    prefer(down[firsts[i]->upperTread], i);
  }
  std::vector<std::size_t> after(risers.size(), kNone);
  std::vector<char> isLater(risers.size(), 0);
  for (std::size_t i = 0; i < risers.size(); ++i) {
    const Index tread = firsts[i]->upperTread;
    const std::size_t next = up[tread];
    if (next == kNone || down[tread] != i) continue;
    if (std::hypot(risers[next].middle[0] - risers[i].middle[0], risers[next].middle[1] - risers[i].middle[1]) >
        longestTread)
      continue;
    after[i] = next;
    isLater[next] = 1;
  }
  // Each riser rises, so rows have an end; treads that are level with each other could still go round.
  std::vector<char> isUsed(risers.size(), 0);
  std::vector<PlanFlight> flights;
  for (std::size_t i = 0; i < risers.size(); ++i) {
    if (isLater[i] != 0) continue;
    PlanFlight flight;
    for (std::size_t at = i; at != kNone && isUsed[at] == 0; at = after[at]) {
      isUsed[at] = 1;
      flight.risers.push_back(risers[at]);
    }
    flights.push_back(std::move(flight));
  }
  return flights;
}

}  // namespace footfall::detail
