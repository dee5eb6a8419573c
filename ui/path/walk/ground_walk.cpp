// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/ground_walk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/vector.hpp"

namespace footfall::ui {
namespace {

constexpr int kBorders = 3;           // that a way slides along: two in a corner, and one more
constexpr double kLeastSlope = 0.05;  // sine of the angle to a border below which the margin is not kept along the ray
constexpr double kRounding = 1e-3;    // of a fall, by which a landing may be beside its place
constexpr double kPush = 0.25;        // of a slide, towards the inside, where the border is nearer than the margin

}  // namespace

GroundWalk::GroundWalk(std::shared_ptr<const PathFinder> finder, double margin, double gap)
    : finder_(std::move(finder)), margin_(margin), gap_(gap) {}

bool GroundWalk::standAt(const Vec3& place, double reach) {
  place_ = finder_->locate(place, reach);
  if (!place_) place_ = nearestPlace(*finder_, place);
  return place_.has_value();
}

void GroundWalk::goTo(double x, double y) { place_ = castRayFrom(*finder_, *place_, {x, y, 0}).end; }

std::optional<GroundWalk::Fall> GroundWalk::go(double x, double y) {
  for (int i = 0; i < kBorders && place_ && (x != 0 || y != 0); ++i) {
    const std::optional<Stop> stop = goStraight(x, y);
    if (!stop) break;
    if (stop->fall) {
      // The landing is rounded: it is in its triangle, or a little beside its border.
      const double reach = kRounding * std::fabs(stop->fall->from.z - stop->fall->to.z);
      auto landed = finder_->locate(stop->fall->to, reach);
      if (!landed) landed = nearestPlace(*finder_, stop->fall->to);
      if (landed && landed->distance <= reach) {
        place_ = landed;
        return stop->fall;
      }
    }
    x = stop->x;
    y = stop->y;
  }
  return std::nullopt;
}

// Nothing: all of the way was gone.
std::optional<GroundWalk::Stop> GroundWalk::goStraight(double x, double y) {
  const Vec3 from = place_->position;
  const double wanted = std::hypot(x, y);
  const Vec3 along{x / wanted, y / wanted, 0};
  const GroundRay ray = castRayFrom(*finder_, *place_, {from.x + x, from.y + y, 0});
  if (ray.reached) {
    place_ = ray.end;
    return std::nullopt;
  }
  if (!ray.border) {
    // At a gap, the other side is out of reach of a small step. (At a corner it gets no farther either way.)
    const double over = ray.planLength + gap_ + margin_;
    const GroundRay longer = castRayFrom(*finder_, *place_, {from.x + over * along.x, from.y + over * along.y, 0});
    if (longer.planLength > ray.planLength) {
      place_ = longer.end;
    } else {
      const double left = std::max(0.0, ray.planLength - margin_);
      goTo(from.x + left * along.x, from.y + left * along.y);
    }
    return std::nullopt;
  }
  Stop stop;
  stop.fall = fallFrom(ray);
  if (stop.fall) return stop;
  const auto& vertices = finder_->mesh().vertices;
  const Vec3 &a = vertices[(*ray.border)[0]], &b = vertices[(*ray.border)[1]];
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0)) return std::nullopt;
  const Vec3 border{(b.x - a.x) / length, (b.y - a.y) / length, 0};
  const double slope = std::fabs(along.x * border.y - along.y * border.x);
  const double left = ray.planLength - margin_ / std::max(slope, kLeastSlope);
  if (left > 0) goTo(from.x + left * along.x, from.y + left * along.y);
  // The rest goes along the border, with the area on its left, and away from it where it is too near.
  const double slide = (wanted - std::max(left, 0.0)) * dot(along, border);
  const Vec3& now = place_->position;
  const double distance = (now.y - a.y) * border.x - (now.x - a.x) * border.y;
  const double push = std::clamp(margin_ - distance, 0.0, kPush * std::fabs(slide));
  stop.x = slide * border.x - push * border.y;
  stop.y = slide * border.y + push * border.x;
  return stop;
}

std::optional<GroundWalk::Fall> GroundWalk::fallFrom(const GroundRay& ray) const {
  const Vec3& at = ray.end.position;
  for (const DropLink& drop : finder_->mesh().drops) {
    if (drop.fromTriangle != ray.end.triangle || drop.from != *ray.border) continue;
    const Vec3 stretch = drop.start[1] - drop.start[0];
    const double square = stretch.x * stretch.x + stretch.y * stretch.y;
    if (!(square > 0)) continue;
    const double part = ((at.x - drop.start[0].x) * stretch.x + (at.y - drop.start[0].y) * stretch.y) / square;
    if (part < 0 || part > 1) continue;
    return Fall{at, drop.landing[0] + part * (drop.landing[1] - drop.landing[0])};
  }
  return std::nullopt;
}

}  // namespace footfall::ui
