// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/face_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace footfall::ui {

using detail::FieldEdge;
using detail::FieldFeature;
using detail::FieldVector;

namespace {

// Shares of the square of the largest distance: smaller areas are invisible.
constexpr double kLeastArea = 1e-12, kLeastShare = 1e-7;

FieldVector inPlan(const Vec3& p) { return {p.x, p.y}; }

double areaInPlan(const ConvexPolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(inPlan(polygon[i]) - inPlan(polygon[0]), inPlan(polygon[i + 1]) - inPlan(polygon[0]));
  return twice / 2;
}

}  // namespace

const std::vector<FacePart>& FaceDivider::divide(std::uint32_t face, const ConvexPolygon& corners) {
  const detail::FieldSurface& surface = field_.surface();
  whole_.clear();
  for (int side = 0; side < 3; ++side) {
    const std::uint32_t half = surface.halves[face][side], edge = half >> 1;
    const std::uint32_t own = field_.featureOfEdge(edge);
    const std::uint32_t corner = field_.featureOfFan(surface.topology.fans[face][side]);
    if (own != FieldEdge::kNone) {
      const FieldFeature& feature = field_.features()[own];
      addWindow(corners, feature, feature.place, feature.place + feature.along * feature.length);
    }
    if (corner != FieldEdge::kNone) addCone(corners, {face, side}, field_.features()[corner]);
    const FieldEdge& line = surface.edges[edge];
    for (const detail::FieldWindow& window : field_.windowsOf(edge))
      if (window.into == (half & 1))
        addWindow(corners, field_.features()[window.feature], line.at(window.lo), line.at(window.hi));
  }
  parts_.clear();
  if (hasTooMany()) return parts_;
  // All parts are compared with whole ones: the part of the nearest piece never loses a place.
  parts_ = whole_;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    poll_();
    for (std::size_t k = 0; k < whole_.size(); ++k)
      if (i != k) takeOut(parts_[i], whole_[k]);
  }
  std::erase_if(parts_,
                [this](const FacePart& part) { return areaInPlan(part.polygon) <= kLeastArea * bound_ * bound_; });
  for (FacePart& part : parts_) {
    poll_();
    for (const FacePart& other : parts_)
      if (&other != &part) addShare(part, other);
  }
  return parts_;
}

const FaceDivider::Fan& FaceDivider::fanAt(const FieldFeature& feature) {
  const auto [found, isNew] = fans_.try_emplace(&feature);
  Fan& fan = found->second;
  if (!isNew) return fan;
  const detail::FieldSurface& surface = field_.surface();
  for (const detail::FieldCorner& c : detail::fanFrom(surface, feature.face, feature.side)) {
    const FieldVector first = surface.corner(c.face, c.corner + 1) - feature.place;
    fan.last = surface.corner(c.face, c.corner + 2) - feature.place;
    const double turn = std::atan2(cross(first, fan.last), dot(first, fan.last));
    fan.turns[{c.face, static_cast<std::uint32_t>(c.corner)}] = {fan.whole, turn};
    fan.whole += turn;
  }
  return fan;
}

void FaceDivider::addCone(const ConvexPolygon& corners, const detail::FieldCorner& at, const FieldFeature& feature) {
  const detail::FieldSurface& surface = field_.surface();
  const Fan& fan = fanAt(feature);
  const auto found = fan.turns.find({at.face, static_cast<std::uint32_t>(at.corner)});
  if (found == fan.turns.end()) return;
  const auto [before, own] = found->second;
  const double behind = fan.whole - before - own;
  cutter_.polygon() = corners;
  const auto cutBefore = [&](FieldVector side) {
    cutter_.cut([&](const Vec3& p) { return -dot(inPlan(p) - feature.place, side); });
  };
  constexpr double kQuarter = std::numbers::pi / 2;
  if (before + own <= kQuarter || behind + own <= kQuarter) return;
  if (before < kQuarter) cutBefore(surface.corner(feature.face, feature.side + 1) - feature.place);
  if (behind < kQuarter) cutBefore(fan.last);
  add(cutter_.polygon(), feature);
}

void FaceDivider::addWindow(const ConvexPolygon& corners, const FieldFeature& feature, FieldVector lo, FieldVector hi) {
  cutter_.polygon() = corners;
  if (feature.isCorner()) {
    const FieldVector first = lo - feature.place, last = hi - feature.place;
    const double sign = cross(first, last) > 0 ? 1 : -1;
    cutter_.cut([&](const Vec3& p) { return sign * cross(first, inPlan(p) - feature.place); });
    cutter_.cut([&](const Vec3& p) { return sign * cross(inPlan(p) - feature.place, last); });
  } else {
    const double a = dot(lo - feature.place, feature.along), b = dot(hi - feature.place, feature.along);
    const double from = std::max(0.0, std::min(a, b)), to = std::min(feature.length, std::max(a, b));
    cutter_.cut([&](const Vec3& p) { return dot(inPlan(p) - feature.place, feature.along) - from; });
    cutter_.cut([&](const Vec3& p) { return to - dot(inPlan(p) - feature.place, feature.along); });
  }
  add(cutter_.polygon(), feature);
}

void FaceDivider::add(const ConvexPolygon& polygon, const FieldFeature& feature) {
  if (areaInPlan(polygon) > kLeastArea * bound_ * bound_) whole_.push_back({polygon, &feature});
}

void FaceDivider::takeOut(FacePart& part, const FacePart& other) {
  Linear farther;
  if (part.polygon.size() == 0 || !findFarther(part, other, farther)) return;
  cutter_.polygon() = part.polygon;
  cutter_.cut([&](const Vec3& p) { return farther.at(p) - slack(); });
  const ConvexPolygon& gone = cutter_.polygon();
  if (gone.size() == 0) return;
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (!contains(other.polygon, gone[i])) return;
  cutter_.polygon() = part.polygon;
  cutter_.cut([&](const Vec3& p) { return slack() - farther.at(p); });
  part.polygon = cutter_.polygon();
}

bool FaceDivider::findFarther(const FacePart& part, const FacePart& other, Linear& farther) const {
  const FieldFeature &own = *part.feature, &near = *other.feature;
  const FieldVector between = own.place - near.place;
  if (!own.isCorner() && !near.isCorner()) {
    farther = {own.inward - near.inward, dot(near.place, near.inward) - dot(own.place, own.inward)};
    return true;
  }
  if (own.isCorner() && near.isCorner()) {
    // The sign of the difference is that of the difference of squares.
    const double apart = lengthOf(between);
    if (!(apart > 0)) return false;
    farther = {between * (-1 / apart), dot(own.place + near.place, between) / (2 * apart)};
    return true;
  }
  if (near.isCorner()) {
    // The difference is convex: it is known over all of the part only.
    for (std::size_t i = 0; i < part.polygon.size(); ++i) {
      const FieldVector p = inPlan(part.polygon[i]);
      if (dot(p - own.place, own.inward) - lengthOf(p - near.place) <= slack()) return false;
    }
    farther = {{0, 0}, 2 * slack()};
    return true;
  }
  const double along = dot(between, near.along);
  const bool isBegin = along <= slack(), isEnd = along >= near.length - slack();
  if ((isBegin || isEnd) && std::fabs(dot(between, near.inward)) <= slack()) {
    // An end of the edge is nowhere nearer than the edge, but before the edge the same by a line at a right angle.
    const FieldVector over = near.along * (isBegin ? 1 : -1);
    farther = {over, -dot(own.place, over)};
    return true;
  }
  FieldVector towards;
  for (std::size_t i = 0; i < part.polygon.size(); ++i) towards = towards + (inPlan(part.polygon[i]) - own.place);
  const double length = lengthOf(towards);
  if (!(length > 0)) return false;
  towards = towards * (1 / length);  // the way along it is at most the distance
  farther = {towards - near.inward, dot(near.place, near.inward) - dot(own.place, towards)};
  return true;
}

bool FaceDivider::contains(const ConvexPolygon& polygon, const Vec3& p) const {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FieldVector a = inPlan(polygon[i]), side = inPlan(polygon.behind(i)) - a;
    if (cross(side, inPlan(p) - a) < -slack() * lengthOf(side)) return false;
  }
  return true;
}

void FaceDivider::addShare(FacePart& part, const FacePart& other) {
  cutter_.polygon() = part.polygon;
  const ConvexPolygon& b = other.polygon;
  for (std::size_t i = 0; i < b.size() && cutter_.polygon().size() > 0; ++i) {
    const FieldVector from = inPlan(b[i]), side = inPlan(b.behind(i)) - from;
    cutter_.cut([&](const Vec3& p) { return cross(side, inPlan(p) - from); });
  }
  if (areaInPlan(cutter_.polygon()) <= kLeastShare * bound_ * bound_) return;
  const std::array<double, 2> own = distancesOf(cutter_.polygon(), *part.feature);
  const std::array<double, 2> others = distancesOf(cutter_.polygon(), *other.feature);
  if (others[1] <= own[0]) return;  // the other piece is nowhere farther
  const bool isFirst = part.sharedFrom > part.sharedTo;
  part.sharedFrom = isFirst ? own[0] : std::min(part.sharedFrom, own[0]);
  part.sharedTo = isFirst ? others[1] : std::max(part.sharedTo, others[1]);
}

std::array<double, 2> distancesOf(const ConvexPolygon& polygon, const FieldFeature& feature) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FieldVector p = inPlan(polygon[i]);
    double distance = dot(p - feature.place, feature.inward);
    if (feature.isCorner()) distance = lengthOf(p - feature.place);
    farthest = std::max(farthest, distance);
    if (feature.isCorner()) {  // the nearest place may be inside of a side
      const FieldVector side = inPlan(polygon.behind(i)) - p;
      const double square = dot(side, side);
      const double t = square > 0 ? std::clamp(dot(feature.place - p, side) / square, 0.0, 1.0) : 0;
      distance = lengthOf(p + side * t - feature.place);
    }
    nearest = std::min(nearest, distance);
  }
  return {std::max(nearest, 0.0), farthest};
}

}  // namespace footfall::ui
