// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/shortest_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

#include "core/exact/source_predicates.hpp"

namespace footfall::reference {
using namespace detail;
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Index = std::uint32_t;

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

struct Way {
  Index to;
  Vec3 left, right;  ///< ends of the side, seen when crossing it
  bool isStep = false;
};

/// Triangles by the vertices of their sides, in the direction of the triangle; then those over steps.
std::vector<std::vector<Way>> waysOf(const NavigationMesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Index>> sides;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) sides[{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]}].push_back(t);
  std::vector<std::vector<Way>> ways(mesh.triangles.size());
  for (const auto& [side, triangles] : sides) {
    const auto back = sides.find({side.second, side.first});
    if (triangles.size() != 1 || back == sides.end() || back->second.size() != 1) continue;
    ways[triangles[0]].push_back({back->second[0], mesh.vertices[side.second], mesh.vertices[side.first]});
  }
  for (const StepLink& link : mesh.links) {
    ways[link.fromTriangle].push_back(
        {link.toTriangle, mesh.vertices[link.from[1]], mesh.vertices[link.from[0]], true});
    ways[link.toTriangle].push_back({link.fromTriangle, mesh.vertices[link.to[1]], mesh.vertices[link.to[0]], true});
  }
  return ways;
}

bool isIn(const NavigationMesh& mesh, Index t, const Vec3& p) {
  for (int i = 0; i < 3; ++i)
    if (facing(mesh.vertices[mesh.triangles[t][i]], mesh.vertices[mesh.triangles[t][(i + 1) % 3]], p) < 0) return false;
  return true;
}

/// True when the straight line from p to q goes through these sides in order, where it may run along one.
bool seesThrough(const Vec3& p, const Vec3& q, const Way* const* first, const Way* const* last) {
  const double dx = q.x - p.x, dy = q.y - p.y, squared = dx * dx + dy * dy, slack = 1e-9;
  const auto parameter = [&](const Vec3& x) { return ((x.x - p.x) * dx + (x.y - p.y) * dy) / squared; };
  double reached = 0;
  for (; first != last; ++first) {
    const Vec3 &left = (*first)->left, &right = (*first)->right;
    if (p.x == q.x && p.y == q.y) {
      const double off = planDistance(left, p) + planDistance(right, p) - planDistance(left, right);
      if (facing(left, right, p) != 0 || off > slack) return false;
      continue;
    }
    const int ofLeft = facing(p, q, left), ofRight = facing(p, q, right);
    if (ofLeft < 0 || ofRight > 0) return false;
    double low = parameter(left), high = parameter(right);
    if (ofLeft != 0 || ofRight != 0) {
      const auto area = [&](const Vec3& x) { return std::fabs(dx * (x.y - p.y) - dy * (x.x - p.x)); };
      const double share = ofLeft == 0 ? 0 : ofRight == 0 ? 1 : area(left) / (area(left) + area(right));
      low = high = low + share * (high - low);
    }
    if (low > high) std::swap(low, high);
    reached = std::max(reached, low);
    if (reached > high + slack || reached > 1 + slack || high < -slack) return false;
  }
  return true;
}

/// The shortest way through these sides in order: over their ends, as far as they see each other.
double shortestThrough(const std::vector<const Way*>& sides, const Vec3& from, const Vec3& to) {
  struct Stop {
    Vec3 p;
    std::size_t side;  ///< number of the next side
    double length;
  };
  std::vector<Stop> stops{{from, 0, 0}};
  const auto reach = [&](const Vec3& p, std::size_t side) {
    double shortest = kInfinity;
    for (const Stop& stop : stops) {
      const bool isSeen = stop.side <= side && seesThrough(stop.p, p, sides.data() + stop.side, sides.data() + side);
      if (isSeen) shortest = std::min(shortest, stop.length + planDistance(stop.p, p));
    }
    return shortest;
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Stop left{sides[i]->left, i + 1, reach(sides[i]->left, i)};
    const Stop right{sides[i]->right, i + 1, reach(sides[i]->right, i)};
    stops.push_back(left);
    stops.push_back(right);
  }
  return reach(to, sides.size());
}

}  // namespace

std::optional<double> shortestOfAllSequences(const NavigationMesh& mesh, const SurfacePlace& from,
                                             const SurfacePlace& to, std::size_t most) {
  const auto ways = waysOf(mesh);
  std::vector<const Way*> sides;
  std::vector<char> isUsed(mesh.triangles.size(), 0);
  double shortest = kInfinity;
  std::size_t count = 0;
  const std::function<void(Index)> visit = [&](Index t) {
    if (++count > most) return;
    if (t == to.triangle) {
      shortest = std::min(shortest, shortestThrough(sides, from.position, to.position));
      return;
    }
    isUsed[t] = 1;
    for (const Way& way : ways[t]) {
      if (isUsed[way.to] != 0) continue;
      sides.push_back(&way);
      visit(way.to);
      sides.pop_back();
    }
    isUsed[t] = 0;
  };
  visit(from.triangle);
  if (count > most) return std::nullopt;
  return shortest;
}

double lengthOverSidePoints(const NavigationMesh& mesh, const SurfacePlace& from, const SurfacePlace& to, int points) {
  // Points belong to one side of one triangle, and lead to the same point of the side behind it, or over a gap.
  const auto perSide = static_cast<std::size_t>(points) + 2;
  const std::size_t perTriangle = 3 * perSide;
  std::map<std::pair<Index, Index>, std::vector<std::pair<Index, int>>> sides;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Index a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      sides[{std::min(a, b), std::max(a, b)}].emplace_back(t, i);
    }
  using Side = std::pair<Index, std::size_t>;  // a side of a triangle
  std::map<Side, std::vector<Side>> steps;
  const auto sideOf = [&](Index t, Index from) {
    return Side{t, static_cast<std::size_t>(std::ranges::find(mesh.triangles[t], from) - mesh.triangles[t].begin())};
  };
  for (const StepLink& link : mesh.links) {
    const Side from = sideOf(link.fromTriangle, link.from[0]), to = sideOf(link.toTriangle, link.to[0]);
    steps[from].push_back(to);
    steps[to].push_back(from);
  }
  const auto position = [&](std::size_t node) {
    const Triangle& f = mesh.triangles[node / perTriangle];
    const std::size_t side = node % perTriangle / perSide;
    const double s = static_cast<double>(node % perSide) / static_cast<double>(perSide - 1);
    const Vec3 &a = mesh.vertices[f[side]], &b = mesh.vertices[f[(side + 1) % 3]];
    return Vec3{std::lerp(a.x, b.x, s), std::lerp(a.y, b.y, s), 0};
  };
  std::vector<double> lengths(mesh.triangles.size() * perTriangle, kInfinity);
  std::priority_queue<std::pair<double, std::size_t>> open;
  const auto improve = [&](std::size_t node, double length) {
    if (length >= lengths[node]) return;
    lengths[node] = length;
    open.emplace(-length, node);
  };
  for (std::size_t i = 0; i < perTriangle; ++i) {
    const std::size_t node = from.triangle * perTriangle + i;
    improve(node, planDistance(from.position, position(node)));
  }
  double best = from.triangle == to.triangle ? planDistance(from.position, to.position) : kInfinity;
  while (!open.empty()) {
    const double length = -open.top().first;
    const std::size_t node = open.top().second;
    open.pop();
    if (length > lengths[node]) continue;
    if (length >= best) break;
    const auto t = static_cast<Index>(node / perTriangle);
    if (t == to.triangle) best = std::min(best, length + planDistance(position(node), to.position));
    for (std::size_t i = 0; i < perTriangle; ++i)
      improve(t * perTriangle + i, length + planDistance(position(node), position(t * perTriangle + i)));
    const std::size_t side = node % perTriangle / perSide;
    const Index a = mesh.triangles[t][side], b = mesh.triangles[t][(side + 1) % 3];
    const auto cross = [&](Index other, std::size_t otherSide) {
      const std::size_t there = other * perTriangle + otherSide * perSide + (perSide - 1 - node % perSide);
      improve(there, length + planDistance(position(node), position(there)));  // The two ends lie apart over a gap.
    };
    if (const auto found = steps.find({t, side}); found != steps.end()) {
      for (const auto& [other, otherSide] : found->second) cross(other, otherSide);
    }
    const auto& both = sides[{std::min(a, b), std::max(a, b)}];
    if (both.size() != 2) continue;
    const auto& [other, otherSide] = both[both[0].first == t ? 1 : 0];
    cross(other, static_cast<std::size_t>(otherSide));
  }
  return best;
}

std::string findPathError(const NavigationMesh& mesh, const PathResult& path, double tolerance) {
  if (path.points.empty()) return "there is no path";
  if (path.triangles.size() + 1 != path.points.size()) return "not one triangle for each piece";
  if (!(path.points.front() == path.start->position)) return "it does not begin at the start";
  if (!(path.points.back() == path.end->position)) return "it does not end at the end";
  const auto distanceFrom = [&](Index t, const Vec3& p) {
    const Triangle& f = mesh.triangles[t];
    double outside = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 &a = mesh.vertices[f[i]], &b = mesh.vertices[f[(i + 1) % 3]];
      const double area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      outside = std::max(outside, -area / planDistance(a, b));
    }
    return outside;
  };
  const auto ways = waysOf(mesh);
  double plan = 0;
  for (std::size_t i = 0; i < path.triangles.size(); ++i) {
    const Index t = path.triangles[i];
    const auto isGap = [&](std::size_t piece) { return std::ranges::find(path.gaps, piece) != path.gaps.end(); };
    if (isGap(i)) {
      plan += planDistance(path.points[i], path.points[i + 1]);
      if (!isGap(i + 1) && distanceFrom(t, path.points[i + 1]) > tolerance)
        return "piece " + std::to_string(i) + " does not lead over a gap to its triangle";
      continue;
    }
    for (const Vec3& p : {path.points[i], path.points[i + 1]})
      if (distanceFrom(t, p) > tolerance) return "piece " + std::to_string(i) + " leaves its triangle";
    plan += planDistance(path.points[i], path.points[i + 1]);
    const bool isStep = std::ranges::find(path.steps, i) != path.steps.end();
    if (isStep && planDistance(path.points[i], path.points[i + 1]) != 0) return "a step is not upright";
    if (i == 0 || path.triangles[i - 1] == t) continue;
    // The path goes around this point from one triangle into the next: through triangles that all reach the point, and
    // over the path's links.
    std::set<Index> seen{path.triangles[i - 1]};
    std::vector<Index> stack{path.triangles[i - 1]};
    while (!stack.empty() && seen.count(t) == 0) {
      const Index from = stack.back();
      stack.pop_back();
      for (const Way& way : ways[from]) {
        if (way.isStep && !isStep) continue;
        const double side = planDistance(way.left, way.right);
        const double off = planDistance(way.left, path.points[i]) + planDistance(way.right, path.points[i]) - side;
        if (off <= tolerance && seen.insert(way.to).second) stack.push_back(way.to);
      }
    }
    if (seen.count(t) == 0) return "pieces " + std::to_string(i - 1) + " and " + std::to_string(i) + " do not meet";
  }
  if (std::fabs(plan - path.planLength) > 1e-9 * plan + tolerance) return "its length is not that of its pieces";
  if (path.length < path.planLength - tolerance) return "it is shorter in space than in the plan";
  if (!isIn(mesh, path.start->triangle, path.start->position)) return "the start is not in its triangle";
  if (!isIn(mesh, path.end->triangle, path.end->position)) return "the end is not in its triangle";
  return {};
}

}  // namespace footfall::reference
