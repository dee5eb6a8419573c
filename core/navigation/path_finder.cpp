// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number_text.hpp"
#include "core/base/poll.hpp"
#include "core/navigation/drop_route.hpp"
#include "core/navigation/path_figures.hpp"
#include "core/navigation/path_ground.hpp"
#include "core/navigation/path_search.hpp"
#include "core/navigation/plan_crossing.hpp"
#include "core/navigation/plan_distance.hpp"
#include "footfall/errors.hpp"
#include "footfall/path.hpp"

namespace footfall {
using namespace detail;
namespace {

/// Puts the points of a path together: where it crosses a side, it is on the side, at the height that the side has.
class Tracer {
 public:
  Tracer(const NavigationMesh& mesh, const SurfaceTopology& topology, const SidePath& sides, PathResult& result)
      : mesh_(mesh), topology_(topology), sides_(sides), result_(result) {}

  void run() {
    result_.points = {result_.start->position};
    std::uint32_t triangle = sides_.startTriangle;
    for (std::size_t i = 0; i < sides_.crossings.size(); ++i) {
      const bool isBend = nextBend(i) != kNoElement && isEndOf(nextBend(i), i);
      const auto [entered, side, root] = sides_.crossings[i];
      const Vec3 before = crossing(i, triangle, topology_.sideBehind(entered, side), true);
      const Vec3 behind = crossing(i, entered, side, false);
      add(before, triangle, isBend);
      if (before.z != behind.z) addStep(behind, entered, isBend);
      triangle = entered;
    }
    add(result_.end->position, triangle, false);
  }

 private:
  /// The corner at which the straight piece through crossing i ends; kNoElement for the end of the path.
  [[nodiscard]] std::uint32_t nextBend(std::size_t i) const {
    const auto& all = sides_.crossings;
    const std::uint32_t root = all[i].root;
    while (i < all.size() && all[i].root == root) ++i;
    return i < all.size() ? all[i].root : sides_.lastBend;
  }
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> endsOf(std::size_t i) const {
    const auto& [triangle, side, root] = sides_.crossings[i];
    return {topology_.fans[triangle][side], topology_.fans[triangle][(side + 1) % 3]};
  }
  [[nodiscard]] bool isEndOf(std::uint32_t fan, std::size_t i) const {
    const auto [left, right] = endsOf(i);
    return fan == left || fan == right;
  }
  [[nodiscard]] const Vec3& point(std::uint32_t fan) const { return mesh_.vertices[topology_.fanVertices[fan]]; }

  /// Crossing i on the given side of one of its two triangles; they differ in height where it is a step.
  [[nodiscard]] Vec3 crossing(std::size_t i, std::uint32_t triangle, int side, bool isTurned) const {
    const auto [left, right] = endsOf(i);
    const std::uint32_t root = sides_.crossings[i].root, bend = nextBend(i);
    const Vec3 &first = mesh_.vertices[mesh_.triangles[triangle][side]],
               &second = mesh_.vertices[mesh_.triangles[triangle][(side + 1) % 3]];
    const Vec3 &l = isTurned ? second : first, &r = isTurned ? first : second;
    for (const std::uint32_t corner : {root, bend})
      if (corner != kNoElement && (corner == left || corner == right)) return corner == left ? l : r;
    const Vec3& from = root == kNoElement ? result_.start->position : point(root);
    const Vec3& to = bend == kNoElement ? result_.end->position : point(bend);
    return pointBetween(l, r, crossingParameter(from, to, l, r));
  }

  void add(const Vec3& p, std::uint32_t triangle, bool isBend) {
    if (!(p == result_.points.back())) {
      result_.points.push_back(p);
      result_.triangles.push_back(triangle);
    }
    if (isBend && result_.points.size() > 1 &&
        (result_.bends.empty() || result_.bends.back() + 1 < result_.points.size()))
      result_.bends.push_back(result_.points.size() - 1);
  }

  void addStep(const Vec3& p, std::uint32_t triangle, bool isBend) {
    result_.steps.push_back(result_.points.size() - 1);
    result_.points.push_back(p);
    result_.triangles.push_back(triangle);
    if (isBend && !result_.bends.empty()) result_.bends.back() = result_.points.size() - 1;
  }

  const NavigationMesh& mesh_;
  const SurfaceTopology& topology_;
  const SidePath& sides_;
  PathResult& result_;
};

/// Three digits after the point are enough for a distance.
std::string shortNumber(double x) {
  std::string text;
  appendNumber(text, std::fabs(x) < 1e12 ? std::round(x * 1000) / 1000 : x);
  return text;
}

void addPath(const PathGround& ground, PathResult& result, Poll poll) {
  const NavigationMesh &mesh = *ground.mesh, &surface = *ground.surface;
  const SidePath sides = searchPath(surface, ground.topology, result.start->position, result.start->triangle,
                                    result.end->position, result.end->triangle, poll);
  result.expanded = sides.expanded;
  if (!sides.found) return;
  Tracer(surface, ground.topology, sides, result).run();
  if (&mesh != &surface) joinGaps(static_cast<std::uint32_t>(mesh.triangles.size()), result);
  addFigures(mesh, result);
}

RouteEnd routeEnd(const SurfacePlace& place) { return {place.position, place.triangle}; }

/// The path for one leg of the search over drops.
RouteLeg legBetween(const PathGround& ground, const RouteEnd& from, const RouteEnd& to, Poll poll) {
  PathResult leg;
  leg.start = ground.places.nearestInside(from.place, from.triangle);
  leg.end = ground.places.nearestInside(to.place, to.triangle);
  addPath(ground, leg, poll);
  if (leg.bends.empty()) return {leg.planLength, to.place, from.place, true, leg.expanded};
  return {leg.planLength, leg.points[leg.bends.front()], leg.points[leg.bends.back()], false, leg.expanded};
}

/// Puts the pieces of a path over drops together, one after the other.
class RouteTracer {
 public:
  RouteTracer(const PathGround& ground, PathResult& result, Poll poll)
      : ground_(ground), result_(result), poll_(poll), at_(*result.start) {
    result_.points = {at_.position};
  }

  void dropAt(const DropStop& stop) {
    const DropLink& drop = ground_.mesh->drops[stop.drop];
    walkTo(ground_.places.nearestInside(stop.start, drop.fromTriangle));
    const SurfacePlace landing = ground_.places.nearestInside(stop.landing, drop.toTriangle);
    const double plan = planDistance(at_.position, landing.position), depth = at_.position.z - landing.position.z;
    result_.drops.push_back(result_.triangles.size());
    result_.points.push_back(landing.position);
    result_.triangles.push_back(landing.triangle);
    result_.planLength += plan;
    result_.length += std::hypot(plan, depth);
    result_.descent += std::max(depth, 0.0);
    result_.deepestDrop = std::max(result_.deepestDrop, depth);
    at_ = landing;
  }

  void walkTo(const SurfacePlace& place) {
    PathResult leg;
    leg.start = at_;
    leg.end = place;
    addPath(ground_, leg, poll_);
    const std::size_t before = result_.triangles.size();
    if (leg.hasPath()) result_.points.insert(result_.points.end(), leg.points.begin() + 1, leg.points.end());
    result_.triangles.insert(result_.triangles.end(), leg.triangles.begin(), leg.triangles.end());
    for (const std::size_t bend : leg.bends) result_.bends.push_back(before + bend);
    for (const std::size_t step : leg.steps) result_.steps.push_back(before + step);
    for (const std::size_t gap : leg.gaps) result_.gaps.push_back(before + gap);
    for (const std::uint32_t layer : leg.layers)
      if (result_.layers.empty() || result_.layers.back() != layer) result_.layers.push_back(layer);
    result_.connections = result_.layers.empty() ? 0 : result_.layers.size() - 1;
    result_.planLength += leg.planLength;
    result_.length += leg.length;
    result_.climb += leg.climb;
    result_.descent += leg.descent;
    result_.maxSlopeDegrees = std::max(result_.maxSlopeDegrees, leg.maxSlopeDegrees);
    result_.maxInclineDegrees = std::max(result_.maxInclineDegrees, leg.maxInclineDegrees);
    result_.expanded += leg.expanded;
    at_ = place;
  }

 private:
  const PathGround& ground_;
  PathResult& result_;
  Poll poll_;
  SurfacePlace at_;
};

void checkPlace(const Vec3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    throw InputError(FOOTFALL_TEXT("the place has a coordinate that is not finite; give three numbers"));
}

}  // namespace

std::string describeFailure(const PathResult& result) {
  switch (result.status) {
    case PathStatus::Found:
      return {};
    case PathStatus::NothingWalkable:
      return "nothing is walkable here";
    case PathStatus::StartNotWalkable:
      return "the start is not walkable; the nearest place that is lies " + shortNumber(result.start->distance) +
             " away";
    case PathStatus::TargetNotWalkable:
      return "the target is not walkable; the nearest place that can be reached lies " +
             shortNumber(result.end->distance) + " from it";
    case PathStatus::NotConnected:
      if (result.leadsBack)
        return "drops lead from the target to the start, but no way leads back up; the nearest place that can be "
               "reached lies " +
               shortNumber(result.end->distance) + " from it";
      return "no way leads from the start to the target; the nearest place that can be reached lies " +
             shortNumber(result.end->distance) + " from it";
  }
  return {};
}

PathFinder::PathFinder(std::shared_ptr<const NavigationMesh> mesh, const RunContext* context)
    : inside_(std::make_shared<const PathGround>(std::move(mesh), context)) {}

PathFinder::PathFinder(std::shared_ptr<const NavigationMesh> mesh, const PathFinder& before, const RunContext* context)
    : inside_(std::make_shared<const PathGround>(std::move(mesh), *before.inside_, context)) {}

PathFinder::~PathFinder() = default;

const NavigationMesh& PathFinder::mesh() const { return *inside_->mesh; }

std::optional<SurfacePlace> PathFinder::locate(const Vec3& p, double reach) const {
  checkPlace(p);
  return inside_->places.locate(p, reach);
}

PathResult PathFinder::findEnds(const Vec3& from, const Vec3& to, double reach) const {
  checkPlace(from);
  checkPlace(to);
  const SurfaceTopology& topology = inside_->topology;
  const PlaceIndex& places = inside_->places;
  PathResult result;
  result.from = from;
  result.to = to;
  if (topology.componentCount == 0) return result;
  result.start = places.locate(from, reach);
  result.end = result.target = places.locate(to, reach);
  if (!result.start) {
    result.status = PathStatus::StartNotWalkable;
    result.start = places.nearest(from);
    return result;
  }
  const std::uint32_t component = topology.components[result.start->triangle];
  if (!result.end) {
    result.status = PathStatus::TargetNotWalkable;
  } else if (topology.components[result.end->triangle] != component) {
    result.status = PathStatus::NotConnected;
  } else {
    result.status = PathStatus::Found;
  }
  if (!result.reached()) {
    const std::vector<char> reached = partsOverDrops(*inside_->mesh, topology, component);
    if (result.status == PathStatus::NotConnected) {
      const std::uint32_t other = topology.components[result.end->triangle];
      if (reached[other] != 0) {
        result.status = PathStatus::Found;
      } else {
        result.leadsBack = partsOverDrops(*inside_->mesh, topology, other)[component] != 0;
      }
    }
    if (!result.reached()) result.end = places.nearest(to, &reached);
  }
  return result;
}

PathResult PathFinder::find(const Vec3& from, const Vec3& to, double reach, const RunContext* context) const {
  const Poll poll(context);
  poll();
  const SurfaceTopology& topology = inside_->topology;
  PathResult result = findEnds(from, to, reach);
  if (result.status == PathStatus::NothingWalkable || result.status == PathStatus::StartNotWalkable) return result;
  const LegFinder finder = [&](const RouteEnd& a, const RouteEnd& b) { return legBetween(*inside_, a, b, poll); };
  if (const auto route =
          findDropRoute(*inside_->mesh, topology, routeEnd(*result.start), routeEnd(*result.end), finder, poll)) {
    RouteTracer tracer(*inside_, result, poll);
    for (const DropStop& stop : route->stops) tracer.dropAt(stop);
    tracer.walkTo(*result.end);
    result.leastPlanLength = std::min(route->leastPlanLength, result.planLength);
    return result;
  }
  addPath(*inside_, result, poll);
  result.leastPlanLength = result.planLength;
  return result;
}

}  // namespace footfall
