// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/obstacle_gizmo.hpp"

#include <QLineF>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/vector.hpp"
#include "ui/view/camera/sight_lines.hpp"
#include "ui/view/overlays/handle_colours.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

using Handle = ObstacleHandle;

constexpr double kArrow = 90;  // pixels from the middle
constexpr double kHead = 16;   // length of an arrow's head
constexpr double kSquareFrom = 24, kSquareTo = 46;
constexpr double kCube = 6;      // half of its edge
constexpr double kCubeGap = 16;  // between a side and its cube
constexpr double kRingGap = 34;
constexpr double kReach = 8;
constexpr double kArrowFrom = 20;  // arrows can be taken from here on: nearer to the middle, the mouse takes the body
constexpr double kFromItsEnd = 0.25;  // share of its length: axes that look shorter have no handle
constexpr int kRingSides = 64;

Vec3 middleOf(const PlacedObstacle& o) { return placeOn(o, {0, 0, o.size.z / 2}); }

/// The direction away from the obstacle for a handle that moves along a line.
std::optional<Vec3> axisOf(const PlacedObstacle& o, Handle handle) {
  const auto [c, s] = directionOf(o.turn);
  switch (handle) {
    case Handle::MoveX:
      return Vec3{1, 0, 0};
    case Handle::MoveY:
      return Vec3{0, 1, 0};
    case Handle::MoveZ:
    case Handle::Top:
      return Vec3{0, 0, 1};
    case Handle::LowerX:
      return Vec3{-c, -s, 0};
    case Handle::UpperX:
      return Vec3{c, s, 0};
    case Handle::LowerY:
      return Vec3{s, -c, 0};
    case Handle::UpperY:
      return Vec3{-s, c, 0};
    case Handle::MovePlan:
    case Handle::Turn:
      break;
  }
  return std::nullopt;
}

constexpr std::array kArrows{Handle::MoveX, Handle::MoveY, Handle::MoveZ};
constexpr std::array kCubes{Handle::LowerX, Handle::UpperX, Handle::LowerY, Handle::UpperY, Handle::Top};

QColor colourOf(Handle handle) {
  switch (handle) {
    case Handle::MoveX:
      return axisColour(0);
    case Handle::MoveY:
      return axisColour(1);
    case Handle::MoveZ:
      return axisColour(2);
    case Handle::MovePlan:
    case Handle::Turn:
    default:
      return handleColour();
  }
}

void addSquareBox(ViewOverlay::Surface& surface, const Vec3& middle, double half) {
  const auto corner = [&](int i) {
    return middle + Vec3{(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half};
  };
  constexpr std::array<std::array<int, 4>, 6> kFaces{
      {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  for (const auto& f : kFaces) {
    surface.triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
    surface.triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
  }
}

void addArrowHead(ViewOverlay::Surface& surface, const Vec3& tip, const Vec3& axis, double length) {
  const Vec3 u = std::abs(axis.z) > 0.5 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 v = cross(axis, u);
  const Vec3 foot = tip - axis * length;
  constexpr int kSides = 12;
  const auto rim = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    return foot + u * (0.35 * length * std::cos(angle)) + v * (0.35 * length * std::sin(angle));
  };
  for (int i = 0; i < kSides; ++i) {
    surface.triangles.push_back({tip, rim(i), rim(i + 1)});
    surface.triangles.push_back({foot, rim(i), rim(i + 1)});
  }
}

}  // namespace

ObstacleGizmo::ObstacleGizmo(const PlacedObstacle& obstacle, const GizmoView& view)
    : obstacle_(obstacle), view_(view) {}

bool ObstacleGizmo::isThere(Handle handle) const {
  const std::optional<Vec3> axis = axisOf(obstacle_, handle);
  if (!axis) return true;
  const auto from = view_.project(middleOf(obstacle_));
  const auto to = view_.project(middleOf(obstacle_) + *axis * (kArrow * view_.unitsPerPixel));
  return from && to && QLineF(*from, *to).length() >= kFromItsEnd * kArrow;
}

Vec3 ObstacleGizmo::arrowTip(Handle handle) const {
  const double pixel = view_.unitsPerPixel;
  const Vec3& size = obstacle_.size;
  // The place is beyond the obstacle and its cube.
  const double half = handle == Handle::MoveZ ? size.z / 2 : std::hypot(size.x, size.y) / 2;
  const double length = std::max(kArrow * pixel, half + (kCubeGap + 3 * kHead) * pixel);
  return middleOf(obstacle_) + *axisOf(obstacle_, handle) * length;
}

double ObstacleGizmo::ringRadius() const {
  return std::hypot(obstacle_.size.x, obstacle_.size.y) / 2 + kRingGap * view_.unitsPerPixel;
}

std::vector<Vec3> ObstacleGizmo::ring() const {
  std::vector<Vec3> points;
  for (int i = 0; i <= kRingSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRingSides;
    points.push_back(obstacle_.base + Vec3{std::cos(angle), std::sin(angle), 0} * ringRadius());
  }
  return points;
}

Vec3 ObstacleGizmo::planCorner(int corner) const {
  const double pixel = view_.unitsPerPixel;
  const double x = corner == 1 || corner == 2 ? kSquareTo : kSquareFrom;
  const double y = corner >= 2 ? kSquareTo : kSquareFrom;
  // The handle is on top, where the obstacle does not hide it.
  return placeOn(obstacle_, {0, 0, obstacle_.size.z}) + Vec3{x * pixel, y * pixel, 0};
}

Vec3 ObstacleGizmo::placeOf(Handle handle) const {
  const double gap = kCubeGap * view_.unitsPerPixel;
  const Vec3& size = obstacle_.size;
  switch (handle) {
    case Handle::MoveX:
    case Handle::MoveY:
    case Handle::MoveZ:
      return arrowTip(handle) - *axisOf(obstacle_, handle) * (kHead / 2 * view_.unitsPerPixel);
    case Handle::MovePlan:
      return (planCorner(0) + planCorner(2)) * 0.5;
    case Handle::Turn: {
      // The handle is between the axes, where no other one is.
      const double d = ringRadius() * std::numbers::sqrt2 / 2;
      return obstacle_.base + Vec3{d, -d, 0};
    }
    case Handle::LowerX:
    case Handle::UpperX:
      return middleOf(obstacle_) + *axisOf(obstacle_, handle) * (size.x / 2 + gap);
    case Handle::LowerY:
    case Handle::UpperY:
      return middleOf(obstacle_) + *axisOf(obstacle_, handle) * (size.y / 2 + gap);
    case Handle::Top:
      return middleOf(obstacle_) + Vec3{0, 0, size.z / 2 + gap};
  }
  return obstacle_.base;
}

std::optional<double> ObstacleGizmo::distanceTo(const QPointF& place, const std::vector<Vec3>& line) const {
  std::optional<double> nearest;
  std::optional<QPointF> before;
  for (const Vec3& point : line) {
    const std::optional<QPointF> now = view_.project(point);
    if (now && before) {
      const QPointF d = *now - *before;
      const double square = QPointF::dotProduct(d, d);
      const double t = square > 0 ? std::clamp(QPointF::dotProduct(place - *before, d) / square, 0.0, 1.0) : 0;
      const double distance = QLineF(place, *before + d * t).length();
      nearest = std::min(nearest.value_or(distance), distance);
    }
    before = now;
  }
  return nearest;
}

std::optional<Handle> ObstacleGizmo::at(const QPointF& place) const {
  std::optional<Handle> found;
  double nearest = kReach + 2;
  for (const Handle cube : kCubes) {
    if (!isThere(cube)) continue;
    const std::optional<QPointF> shown = view_.project(placeOf(cube));
    if (!shown || QLineF(place, *shown).length() >= nearest) continue;
    nearest = QLineF(place, *shown).length();
    found = cube;
  }
  if (found) return found;
  QPolygonF square;
  for (int i = 0; i < 4; ++i) {
    if (const std::optional<QPointF> corner = view_.project(planCorner(i))) square << *corner;
  }
  if (square.size() == 4 && square.containsPoint(place, Qt::OddEvenFill)) return Handle::MovePlan;
  nearest = kReach;
  const auto consider = [&](Handle handle, const std::vector<Vec3>& line) {
    const std::optional<double> distance = distanceTo(place, line);
    if (!distance || *distance >= nearest) return;
    nearest = *distance;
    found = handle;
  };
  for (const Handle arrow : kArrows) {
    if (!isThere(arrow)) continue;
    const Vec3 from = middleOf(obstacle_) + *axisOf(obstacle_, arrow) * (kArrowFrom * view_.unitsPerPixel);
    consider(arrow, {from, arrowTip(arrow)});
  }
  if (!found) consider(Handle::Turn, ring());
  return found;
}

ViewOverlay ObstacleGizmo::overlay(std::optional<Handle> marked) const {
  ViewOverlay overlay;
  overlay.throughWalls = true;
  const double pixel = view_.unitsPerPixel;
  const auto colour = [&](Handle handle) { return handle == marked ? highlightColour() : colourOf(handle); };
  const QColor rim = outlineColour();
  const std::vector<Vec3> circle = ring();
  ViewOverlay::Lines turn{{}, colour(Handle::Turn), 3, rim};
  for (std::size_t i = 1; i < circle.size(); ++i) {
    // Segments overlap, because their ends are blurred.
    const Vec3 more = (circle[i] - circle[i - 1]) * 0.2;
    turn.segments.push_back({circle[i - 1] - more, circle[i] + more});
  }
  overlay.lines.push_back(std::move(turn));
  for (const Handle arrow : kArrows) {
    if (!isThere(arrow)) continue;
    const Vec3 axis = *axisOf(obstacle_, arrow);
    overlay.lines.push_back({{{middleOf(obstacle_), arrowTip(arrow) - axis * (kHead * pixel)}}, colour(arrow), 3, rim});
    ViewOverlay::Surface head{{}, colour(arrow)};
    addArrowHead(head, arrowTip(arrow), axis, kHead * pixel);
    overlay.surfaces.push_back(std::move(head));
  }
  ViewOverlay::Surface square{{}, colour(Handle::MovePlan)};
  square.colour.setAlphaF(0.75F);
  square.triangles = {{planCorner(0), planCorner(1), planCorner(2)}, {planCorner(0), planCorner(2), planCorner(3)}};
  overlay.surfaces.push_back(std::move(square));
  for (const Handle cube : kCubes) {
    if (!isThere(cube)) continue;
    ViewOverlay::Surface surface{{}, colour(cube)};
    addSquareBox(surface, placeOf(cube), kCube * pixel);
    overlay.surfaces.push_back(std::move(surface));
  }
  return overlay;
}

std::optional<PlacedObstacle> dragged(const PlacedObstacle& start, Handle handle, const Ray& from, const Ray& to,
                                      const DragSteps& steps) {
  PlacedObstacle next = start;
  // Moves one coordinate; `moved` is the distance of the mouse.
  const auto shifted = [&](double place, double moved) {
    if (steps.toGrid) return roundTo(place + moved, steps.length);
    return roundTo(moved, steps.length) == 0 ? place
                                             : roundTo(place + roundTo(moved, steps.length), steps.length / 100);
  };
  if (handle == Handle::Turn) {
    const auto angle = [&](const Ray& ray) -> std::optional<double> {
      const std::optional<Vec3> p = meetHeight(ray, start.base.z);
      if (!p) return std::nullopt;
      return std::atan2(p->y - start.base.y, p->x - start.base.x) * 180 / std::numbers::pi;
    };
    const auto before = angle(from), now = angle(to);
    if (!before || !now) return std::nullopt;
    const double turned = std::remainder(*now - *before, 360.0);
    next.turn = steps.toGrid ? roundTo(start.turn + turned, steps.degrees)
                             : roundTo(start.turn + roundTo(turned, steps.degrees), 0.01);
    next.turn = roundTo(std::remainder(next.turn, 360.0), 0.01);
    return next;
  }
  if (handle == Handle::MovePlan) {
    const auto before = meetHeight(from, start.base.z + start.size.z),
               now = meetHeight(to, start.base.z + start.size.z);
    if (!before || !now) return std::nullopt;
    next.base.x = shifted(start.base.x, now->x - before->x);
    next.base.y = shifted(start.base.y, now->y - before->y);
    return next;
  }
  const Vec3 axis = *axisOf(start, handle);
  const Vec3 middle = middleOf(start);
  const auto before = alongAxis(from, middle, axis), now = alongAxis(to, middle, axis);
  if (!before || !now) return std::nullopt;
  const double moved = *now - *before;
  switch (handle) {
    case Handle::MoveX:
      next.base.x = shifted(start.base.x, moved);
      return next;
    case Handle::MoveY:
      next.base.y = shifted(start.base.y, moved);
      return next;
    case Handle::MoveZ:
      next.base.z = shifted(start.base.z, moved);
      return next;
    default:
      break;
  }
  const bool alongX = handle == Handle::LowerX || handle == Handle::UpperX;
  const bool top = handle == Handle::Top;
  double& extent = top ? next.size.z : alongX ? next.size.x : next.size.y;
  const double was = extent;
  extent = std::max(shifted(was, moved), std::min(was, steps.length));
  if (!top) {
    // The opposite side stays.
    const Vec3 base = start.base + axis * ((extent - was) / 2);
    next.base.x = axis.x == 0 ? start.base.x : base.x;
    next.base.y = axis.y == 0 ? start.base.y : base.y;
  }
  return next;
}

}  // namespace footfall::ui
