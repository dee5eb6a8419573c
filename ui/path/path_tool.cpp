// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/path_tool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ui/base/look/core_colours.hpp"

namespace footfall::ui {
namespace {

const QString kPathOverlay = QStringLiteral("path");
constexpr double kGrabPixels = 10;
constexpr double kArrowEvery = 56;  // pixels along the path
constexpr double kArrowPixels = 9;

// Colours of Okabe and Ito that have no other meaning on a path.
QColor startColour() { return toColour(kBlue); }
QColor targetColour() { return toColour(kOrange); }
QColor failColour() { return toColour(kVermilion); }
QColor lineColour() { return {20, 20, 20}; }

Vec3 between(const Vec3& a, const Vec3& b, double s) {
  return {std::lerp(a.x, b.x, s), std::lerp(a.y, b.y, s), std::lerp(a.z, b.z, s)};
}

/// Arrow heads lie in the plan of the path and have a constant size on the screen.
void addArrows(const LevelView& view, const std::vector<Vec3>& points, std::vector<std::array<Vec3, 2>>& segments) {
  double left = kArrowEvery / 2;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 &a = points[i], &b = points[i + 1];
    const auto pa = view.project(a), pb = view.project(b);
    const double plan = std::hypot(b.x - a.x, b.y - a.y);
    if (!pa || !pb || plan <= 0) continue;
    const double pixels = std::hypot(pb->x() - pa->x(), pb->y() - pa->y());
    if (pixels > 1e5) continue;  // right in front of the eye
    for (; left < pixels; left += kArrowEvery) {
      const Vec3 tip = between(a, b, left / pixels);
      const double size = kArrowPixels * plan / pixels;
      const Vec3 along{(b.x - a.x) / plan * size, (b.y - a.y) / plan * size, (b.z - a.z) / plan * size};
      for (const double side : {-0.6, 0.6})
        segments.push_back(
            {Vec3{tip.x - along.x - side * along.y, tip.y - along.y + side * along.x, tip.z - along.z}, tip});
    }
    left -= pixels;
  }
}

/// Adds short strokes with gaps.
void addDashes(const LevelView& view, const Vec3& a, const Vec3& b, std::vector<std::array<Vec3, 2>>& segments) {
  const auto pa = view.project(a), pb = view.project(b);
  const double pixels = pa && pb ? std::hypot(pb->x() - pa->x(), pb->y() - pa->y()) : 100;
  const int count = std::clamp(static_cast<int>(pixels / 12), 1, 200);
  for (int i = 0; i < count; ++i)
    segments.push_back({between(a, b, double(i) / count), between(a, b, (i + 0.55) / count)});
}

}  // namespace

PathTool::PathTool(PathModel& model, LevelView& view, QObject* parent) : QObject(parent), model_(model), view_(view) {
  connect(&model_, &PathModel::placesChanged, this, [this] {
    draw();
    emit hintChanged(hint());
  });
  connect(&model_, &PathModel::resultChanged, this, &PathTool::draw);
  connect(&view_.cameraController(), &CameraController::moved, this, &PathTool::draw);
}

void PathTool::setShown(bool shown) {
  shown_ = shown;
  draw();
}

void PathTool::setUnits(const LevelUnits& units) {
  units_ = units;
  draw();
}

QString PathTool::hint() const {
  if (!model_.start()) return tr("Try it: click where the path starts. Esc ends.");
  if (!model_.target()) return tr("Try it: click where the path leads. Backspace takes the start back, Esc ends.");
  return tr("Try it: drag an end, click to begin another path, Space walks it. Esc ends.");
}

PathTool::End PathTool::endAt(const QPoint& place) const {
  const auto near = [&](const std::optional<Vec3>& end) {
    const auto at = end ? view_.project(*end) : std::nullopt;
    return at && std::hypot(at->x() - place.x(), at->y() - place.y()) <= kGrabPixels;
  };
  return near(model_.target()) ? End::Target : near(model_.start()) ? End::Start : End::None;
}

bool PathTool::mousePressed(const ViewMouse& mouse) {
  if (mouse.button != Qt::LeftButton || mouse.modifiers != Qt::NoModifier) return false;
  dragged_ = endAt(mouse.place);
  return dragged_ != End::None;
}

void PathTool::mouseMoved(const ViewMouse& mouse) {
  if (dragged_ == End::None) {
    const End now = endAt(mouse.place);
    if (now != hovered_) {
      hovered_ = now;
      view_.setCursor(now == End::None ? Qt::CrossCursor : Qt::OpenHandCursor);
      draw();
    }
    return;
  }
  const auto found = view_.pick(mouse.place);
  if (!found) return;
  if (dragged_ == End::Start) model_.setStart(found->point);
  if (dragged_ == End::Target) model_.setTarget(found->point);
}

void PathTool::mouseReleased(const ViewMouse& mouse) {
  mouseMoved(mouse);
  dragged_ = End::None;
}

void PathTool::clicked(const ViewMouse& mouse) {
  const auto found = view_.pick(mouse.place);
  if (!found) return;
  if (model_.start() && !model_.target()) {
    model_.setTarget(found->point);
  } else {
    model_.setPlaces(found->point, std::nullopt);
  }
}

bool PathTool::keyPressed(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Space) {
    emit playRequested();
    return true;
  }
  if (event.key() != Qt::Key_Backspace && event.key() != Qt::Key_Delete) return false;
  if (model_.target()) {
    model_.setTarget(std::nullopt);
  } else {
    model_.setStart(std::nullopt);
  }
  return true;
}

void PathTool::mouseLeft() {
  hovered_ = End::None;
  draw();
}

void PathTool::ended() { dragged_ = hovered_ = End::None; }

void PathTool::draw() {
  if (!shown_ || (!model_.start() && !model_.target())) {
    view_.removeOverlay(kPathOverlay);
    return;
  }
  ViewOverlay overlay;
  overlay.throughWalls = true;
  const auto mark = [&](const std::optional<Vec3>& at, End end, const QColor& colour, const QString& label) {
    if (!at) return;
    overlay.marks.push_back({*at, colour, end == hovered_ || end == dragged_ ? 16.0F : 12.0F});
    overlay.labels.push_back({*at, label});
  };
  const auto& result = model_.result();
  QString length;
  if (result && result->hasPath()) {
    std::vector<std::array<Vec3, 2>> segments;
    for (std::size_t i = 0; i + 1 < result->points.size(); ++i)
      segments.push_back({result->points[i], result->points[i + 1]});
    addArrows(view_, result->points, segments);
    overlay.lines.push_back({std::move(segments), lineColour(), 3, QColor(Qt::white)});
    length = units_.length(result->length);
  }
  mark(model_.start(), End::Start, startColour(), tr("Start"));
  mark(model_.target(), End::Target, targetColour(),
       result && result->reached() ? tr("Target: %1").arg(length) : tr("Target"));
  if (result && !result->reached()) {
    const bool atStart = result->status == PathStatus::StartNotWalkable;
    const auto& nearest = atStart ? result->start : result->end;
    if (nearest) {
      std::vector<std::array<Vec3, 2>> dashes;
      addDashes(view_, nearest->position, atStart ? result->from : result->to, dashes);
      overlay.lines.push_back({std::move(dashes), failColour(), 3, QColor(Qt::white)});
      overlay.marks.push_back({nearest->position, failColour(), 12});
      overlay.labels.push_back({nearest->position, atStart ? tr("Nearest walkable place") : tr("The way ends here")});
    }
  }
  view_.setOverlay(kPathOverlay, std::move(overlay));
}

}  // namespace footfall::ui
