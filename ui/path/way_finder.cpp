// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/way_finder.hpp"

#include <limits>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "core/navigation/path_ground.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/without_radius.hpp"

namespace footfall::ui {
namespace {

double preferredWidth(const WalkingBody& body) {
  switch (body.way) {
    case BodyWay::Shortest:
      return 0;
    case BodyWay::PrefersWide:
      return kPreferredWidth * 2 * body.radius;
    case BodyWay::Widest:
      return std::numeric_limits<double>::infinity();
  }
  return 0;
}

}  // namespace

void WayFinder::prepare(const WayGround& wanted, bool forBody, RunContext& context) {
  if (ground_ == wanted && (forBody ? bodies_ != nullptr : points_ != nullptr)) return;
  separations_.reset();
  last_.reset();
  if (points_) earlier_ = std::move(points_);
  bodies_.reset();
  ground_ = wanted;
  if (!forBody) {
    points_ = earlier_ ? std::make_unique<PathFinder>(wanted.mesh, *earlier_, &context)
                       : std::make_unique<PathFinder>(wanted.mesh, &context);
    earlier_.reset();
    return;
  }
  bodies_ = onThreads(0, [&](int) {
    const auto mesh = wanted.run ? meshWithoutRadius(*wanted.run, wanted.cache.get(), context) : wanted.mesh;
    return std::make_unique<BodyPathFinder>(mesh, &context);
  });
  earlier_.reset();
}

FoundWay WayFinder::find(const Vec3& start, const Vec3& target, const WalkingBody& body,
                         const RunContext& context) const {
  FoundWay way;
  if (!bodies_) {
    way.path = points_->find(start, target, ground_.reach, &context);
  } else {
    way.body = bodies_->find(start, target, {body.radius, preferredWidth(body)}, ground_.reach, &context);
    const bool isOverDrops = way.body->status == BodyPathStatus::NoPath && !way.body->path.drops.empty();
    if (way.body->reached() || (way.body->status == BodyPathStatus::NoPath && !isOverDrops)) way.path = way.body->path;
  }
  if (way.path && way.path->status == PathStatus::NotConnected && last_ && last_->parts == partsOf(*way.path))
    way.path->separation = last_->separation;
  return way;
}

void WayFinder::separate(PathResult& result, const RunContext& context) {
  if (!ground_.environment) return;
  if (!separations_)
    separations_ = std::make_unique<SeparationFinder>(finder(), ground_.environment, ground_.agentHeight,
                                                      ground_.agentStep, &context, ground_.agentGap);
  addSeparation(result, *separations_, &context);
  last_ = {partsOf(result), result.separation};
}

std::array<std::uint32_t, 2> WayFinder::partsOf(const PathResult& result) const {
  const auto& components = finder().inside()->topology.components;
  return {components[result.start->triangle], components[result.target->triangle]};
}

}  // namespace footfall::ui
