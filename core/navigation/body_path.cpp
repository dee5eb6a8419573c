// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/body_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/navigation/admissible_place.hpp"
#include "core/navigation/body_search.hpp"
#include "core/navigation/field_walk.hpp"
#include "core/navigation/path_figures.hpp"
#include "core/navigation/path_ground.hpp"
#include "footfall/errors.hpp"

namespace footfall {

struct detail::BodyPathGround {
  BodyPathGround(std::shared_ptr<const NavigationMesh> given, const RunContext* context)
      : mesh(std::move(given)), finder(mesh, context), network(*mesh, Poll(context)) {}
  std::shared_ptr<const NavigationMesh> mesh;
  PathFinder finder;
  CorridorNetwork network;
};

using namespace detail;
namespace {

/// Puts a way of straight pieces on the surface: a point wherever it crosses a side of a triangle.
class WayTracer {
 public:
  WayTracer(const BodyPathGround& ground, PathResult& path)
      : surface_(ground.network.field().surface()), network_(ground.network), path_(path) {}

  void run(const std::vector<FieldVector>& corners) {
    path_.points = {path_.start->position};
    std::uint32_t face = path_.start->triangle;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      FieldWalk walk(surface_, face, corners[i - 1], corners[i]);
      for (std::size_t steps = 0; steps < 2 * surface_.faces.size(); ++steps) {
        const auto exit = walk.exit();
        if (!exit) break;
        const Vec3 before = network_.places().onFace(walk.face(), exit->place);
        add(before, walk.face());
        if (!walk.leave(*exit)) break;
        const Vec3 behind = network_.places().onFace(walk.face(), exit->place);
        if (before.z != behind.z && isStep(walk.face(), exit->place, before.z)) addStep(behind, walk.face());
      }
      face = walk.face();
      const bool isLast = i + 1 == corners.size();
      add(isLast ? path_.end->position : network_.places().onFace(face, corners[i]), face);
      if (!isLast && path_.points.size() > 1) path_.bends.push_back(path_.points.size() - 1);
    }
    path_.bends.erase(std::unique(path_.bends.begin(), path_.bends.end()), path_.bends.end());
  }

 private:
  /// Heights on both sides of an edge differ by rounding, too.
  [[nodiscard]] bool isStep(std::uint32_t face, FieldVector p, double z) const {
    return std::fabs(network_.places().onFace(face, p).z - z) > 1e-9 * (1 + surface_.scale + std::fabs(z));
  }
  void add(const Vec3& p, std::uint32_t face) {
    if (p == path_.points.back()) return;
    path_.points.push_back(p);
    path_.triangles.push_back(face);
  }
  void addStep(const Vec3& p, std::uint32_t face) {
    path_.steps.push_back(path_.triangles.size());
    path_.points.push_back(p);
    path_.triangles.push_back(face);
  }

  const FieldSurface& surface_;
  const CorridorNetwork& network_;
  PathResult& path_;
};

class PathMaker {
 public:
  PathMaker(const BodyPathGround& ground, const BodyPathOptions& options, Poll poll)
      : ground_(ground), network_(ground.network), options_(options), poll_(poll) {}

  BodyPath make(const Vec3& from, const Vec3& to, double reach, const RunContext* context) {
    BodyPath result;
    const auto start = ground_.finder.locate(from, reach), target = ground_.finder.locate(to, reach);
    const auto& components = network_.field().surface().topology.components;
    if (!start || !target || components[start->triangle] != components[target->triangle]) {
      result.path = ground_.finder.findEnds(from, to, reach);
      if (result.path.reached()) {
        result.path = ground_.finder.find(from, to, reach, context);
        result.path.status = PathStatus::NotConnected;  // drops alone lead there
      }
      return result;
    }
    result.path.from = from;
    result.path.to = to;
    result.path.start = start;
    result.path.end = result.path.target = target;
    const Standing first = standingAt(*start), last = standingAt(*target);
    result.startDistance = first.nearest.distance;
    result.targetDistance = last.nearest.distance;
    const double least = options_.radius - 4 * network_.field().margin();
    for (const Standing* standing : {&first, &last}) {
      if (standing->nearest.distance >= least && standing->end.foot.way != CorridorFoot::kNone) continue;
      result.status = standing == &first ? BodyPathStatus::StartTooNear : BodyPathStatus::TargetTooNear;
      result.lacking = std::max(0.0, options_.radius - standing->nearest.distance);
      result.admissible = admissiblePlace(network_, *standing, options_.radius);
      return result;
    }
    findWay(first, last, result);
    return result;
  }

 private:
  [[nodiscard]] Standing standingAt(const SurfacePlace& place) const {
    const FieldVector p = FieldVector{place.position.x, place.position.y} - network_.field().surface().origin;
    const CorridorFoot foot = network_.footOf(place.triangle, p).value_or(CorridorFoot{});
    return {place.triangle, network_.field().at(place.triangle, p), p, {awayFromCorner(p, place.triangle, foot), foot}};
  }

  /// A start within the polygon around a corner of the border goes straight away from the corner first: from there, the
  /// way round the polygon is free.
  [[nodiscard]] FieldVector awayFromCorner(FieldVector p, std::uint32_t face, const CorridorFoot& foot) const {
    const ClearanceField::Nearest nearest = network_.field().at(face, p);
    if (foot.way == CorridorFoot::kNone || !network_.field().features()[nearest.feature].isCorner()) return p;
    const double distance = std::min(options_.radius * polygonFactor(), foot.distance);
    if (nearest.distance >= distance) return p;
    return nearest.border + (p - nearest.border) * (distance / nearest.distance);
  }

  void findWay(const Standing& start, const Standing& target, BodyPath& result) const {
    const BodyEnd &first = start.end, &last = target.end;
    double distance = options_.radius;
    std::optional<CorridorNeck> widest;
    if (options_.preferredWidth > 2 * distance) {
      widest = widestNeck(network_, first, last);
      if (widest) distance = std::max(distance, std::min(options_.preferredWidth / 2, widest->distance));
    }
    auto way = findBodyWay(network_, first, last, options_.radius, distance, poll_);
    if (!way) {
      if (!widest) widest = widestNeck(network_, first, last);
      result.status = BodyPathStatus::TooNarrow;
      if (!widest) return;
      result.narrowest = passageAt(*widest);
      result.lacking = std::max(0.0, 2 * options_.radius - result.narrowest->width);
      return;
    }
    result.status = BodyPathStatus::Found;
    result.narrowest = passageAt(way->neck);
    PathResult& path = result.path;
    path.status = PathStatus::Found;
    path.expanded = way->expanded;
    if (lengthOf(start.place - first.place) > 0) way->corners.insert(way->corners.begin(), start.place);
    if (lengthOf(target.place - last.place) > 0) way->corners.push_back(target.place);
    if (lengthOf(target.place - start.place) == 0) way->corners = {start.place, target.place};
    WayTracer(ground_, path).run(way->corners);
    const NavigationMesh& mesh = *ground_.mesh;
    if (network_.bridged().triangles.size() > mesh.triangles.size())
      joinGaps(static_cast<std::uint32_t>(mesh.triangles.size()), path);
    addFigures(mesh, path);
    path.leastPlanLength = path.planLength;
  }

  [[nodiscard]] Passage passageAt(const CorridorNeck& neck) const {
    const CorridorWay& way = network_.ways()[neck.way];
    const FieldPlaces& places = network_.places();
    return {places.onFace(places.faceAt(way.faces, neck.place), neck.place),
            places.onBorder(way.features[0], neck.place), places.onBorder(way.features[1], neck.place),
            2 * neck.distance};
  }

  const BodyPathGround& ground_;
  const CorridorNetwork& network_;
  BodyPathOptions options_;
  Poll poll_;
};

}  // namespace

BodyPathFinder::BodyPathFinder(std::shared_ptr<const NavigationMesh> mesh, const RunContext* context)
    : inside_(std::make_unique<const BodyPathGround>(std::move(mesh), context)) {}

BodyPathFinder::~BodyPathFinder() = default;

const PathFinder& BodyPathFinder::pointFinder() const { return inside_->finder; }

BodyPath BodyPathFinder::find(const Vec3& from, const Vec3& to, const BodyPathOptions& options, double reach,
                              const RunContext* context) const {
  if (!(std::isfinite(options.radius) && options.radius > 0))
    throw InputError(FOOTFALL_TEXT("the radius must be a number above 0; leave it out for an agent without a body"));
  if (!(options.preferredWidth >= 0))
    throw InputError(FOOTFALL_TEXT("the width of passages must be a number of at least 0"));
  const Poll poll(context);
  poll();
  return PathMaker(*inside_, options, poll).make(from, to, reach, context);
}

}  // namespace footfall
