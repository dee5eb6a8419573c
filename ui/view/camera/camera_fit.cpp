// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/camera_fit.hpp"

#include <QGLViewer/camera.h>
#include <QGLViewer/manipulatedCameraFrame.h>

#include <QMarginsF>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/overlays/overlay_renderer.hpp"

namespace footfall::ui {
namespace {

using qglviewer::Camera;
using qglviewer::Vec;

constexpr double kMargin = 1.08;  // factor around a scene that is shown whole

// The convex hull of points in a plane, counter-clockwise (Andrew 1979).
QPolygonF hullOf(std::vector<QPointF> points) {
  std::ranges::sort(points,
                    [](const QPointF& a, const QPointF& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  const auto turns = [](const QPointF& a, const QPointF& b, const QPointF& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  QPolygonF hull;
  for (int side = 0; side < 2; ++side) {
    const qsizetype first = hull.size();
    for (const QPointF& p : points) {
      while (hull.size() >= first + 2 && turns(hull[hull.size() - 2], hull.back(), p) <= 0) hull.removeLast();
      hull << p;
    }
    if (!hull.isEmpty()) hull.removeLast();
    std::ranges::reverse(points);
  }
  return hull;
}

// The ways to exclude everything in `covered` by one margin of the view for each rectangle; those that leave most of
// the view come first.
std::vector<QMarginsF> marginsAround(const std::vector<QRect>& covered, const QSize& view) {
  std::vector<QMarginsF> ways{{}};
  for (const QRect& rect : covered) {
    const std::vector<QMarginsF> before = ways;
    for (const QMarginsF& way : before) {
      const double right = view.width() - rect.left();
      const double bottom = view.height() - rect.top();
      ways.push_back(way | QMarginsF(rect.right() + 1, 0, 0, 0));
      ways.push_back(way | QMarginsF(0, rect.bottom() + 1, 0, 0));
      ways.push_back(way | QMarginsF(0, 0, right, 0));
      ways.push_back(way | QMarginsF(0, 0, 0, bottom));
    }
  }
  const auto left = [&](const QMarginsF& m) {
    return std::max(0.0, view.width() - m.left() - m.right()) * std::max(0.0, view.height() - m.top() - m.bottom());
  };
  constexpr double kLeast = 0.25;  // least share of the view: with less, little would be visible
  std::erase_if(ways, [&](const QMarginsF& way) { return left(way) < kLeast * view.width() * view.height(); });
  std::ranges::stable_sort(ways, [&](const QMarginsF& a, const QMarginsF& b) { return left(a) > left(b); });
  return ways;
}

bool anyCovered(const Camera& camera, const std::vector<Vec3>& points, const QSize& view,
                const std::vector<QRect>& covered) {
  std::vector<QPointF> places;
  const OverlayRenderer::Look look{modelViewProjection(camera), view, 1, {}};
  for (const Vec3& p : points) {
    if (const auto place = OverlayRenderer::project(p, look)) places.push_back(*place);
  }
  const QPolygonF hull = hullOf(std::move(places));
  return std::ranges::any_of(covered, [&](const QRect& rect) { return hull.intersects(QPolygonF(QRectF(rect))); });
}

void standBefore(Camera& camera, const std::vector<Vec3>& points, const QSize& view, const QMarginsF& free) {
  if (points.empty()) return;
  const Vec right = camera.rightVector();
  const Vec up = camera.upVector();
  const Vec ahead = camera.viewDirection();
  const bool parallel = camera.type() == Camera::ORTHOGRAPHIC;
  // libQGLViewer derives the scale of a parallel projection from the shorter side.
  const double shorter = parallel ? std::min(1.0, view.width() / std::max(1.0, static_cast<double>(view.height()))) : 1;
  const double tanVertical = std::tan(camera.fieldOfView() / 2) / kMargin / std::max(0.1, shorter);
  const double tanHorizontal =
      tanVertical * std::max(0.1, view.width() / std::max(1.0, static_cast<double>(view.height())));
  // The shares of the remaining view from its middle: to the right and up, and to the left and down.
  const auto part = [](double margin, int all) { return 1 - 2 * margin / std::max(1, all); };
  const std::array<double, 2> tanAbove{tanHorizontal * part(free.right(), view.width()),
                                       tanVertical * part(free.top(), view.height())};
  const std::array<double, 2> tanBelow{tanHorizontal * part(free.left(), view.width()),
                                       tanVertical * part(free.bottom(), view.height())};

  // Each side of the view's pyramid (or prism) touches the scene's outermost point: along each of the two axes, p is in
  // view of the eye e when |p - e| <= tan * (depth of p - depth of e).
  constexpr double kLowest = std::numeric_limits<double>::lowest();
  std::array<double, 2> above{kLowest, kLowest};
  std::array<double, 2> below{kLowest, kLowest};
  double nearest = -kLowest;
  double farthest = kLowest;
  for (const Vec3& point : points) {
    const Vec p = toVec(point);
    const double depth = p * ahead;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
    for (const auto& [axis, offset] : {std::pair{0, p * right}, std::pair{1, p * up}}) {
      above[axis] = std::max(above[axis], offset - (parallel ? 0 : tanAbove[axis] * depth));
      below[axis] = std::max(below[axis], -offset - (parallel ? 0 : tanBelow[axis] * depth));
    }
  }
  const auto reachOf = [&](std::size_t axis) {
    return (above[axis] + below[axis]) / std::max(1e-3, tanAbove[axis] + tanBelow[axis]);
  };
  const double reach = std::max(reachOf(0), reachOf(1));
  const double middle = (nearest + farthest) / 2;
  // The distance from the pivot only sets the scale of a parallel projection.
  const double scale = std::max(reach, camera.sceneRadius() * 1e-3);
  const double eyeDepth = parallel ? middle - scale : std::min(-reach, nearest);
  const auto sidewaysAt = [&](double away) {
    const auto along = [&](std::size_t axis) {
      return (above[axis] - below[axis] - (tanAbove[axis] - tanBelow[axis]) * away) / 2;
    };
    return right * along(0) + up * along(1);
  };
  const Vec sideways = sidewaysAt(parallel ? scale : -eyeDepth);
  // The pivot is in the middle of the remaining view.
  const double away = parallel ? scale : middle - eyeDepth;
  const Vec aside = right * ((tanAbove[0] - tanBelow[0]) / 2 * away) + up * ((tanAbove[1] - tanBelow[1]) / 2 * away);
  camera.frame()->setPivotPoint(sideways + aside + ahead * middle);
  camera.setPosition(sideways + ahead * eyeDepth);
}

}  // namespace

void fitCamera(Camera& camera, const std::vector<Vec3>& points, const QSize& view, const std::vector<QRect>& covered) {
  for (const QMarginsF& free : marginsAround(covered, view)) {
    standBefore(camera, points, view, free);
    if (covered.empty() || !anyCovered(camera, points, view, covered)) return;
  }
  standBefore(camera, points, view, {});
}

}  // namespace footfall::ui
