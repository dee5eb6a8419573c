// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/measure_tool.hpp"

#include <QApplication>
#include <QClipboard>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/vector.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

const QString kMeasureOverlay = QStringLiteral("measure");
constexpr double kSnapPixels = 8;
constexpr double kDegrees = 180 / 3.14159265358979323846;

QColor lineColour() { return {20, 20, 20}; }
QColor placeColour() { return toColour(kYellow); }
QColor vertexColour() { return toColour(kVermilion); }

QString signedText(double value, const LevelUnits& units) {
  const QString text = units.lengthNumber(value);
  return (value > 0 && text != QLatin1String("0") ? QLatin1Char('+') + text : text) + QLatin1Char(' ') + units.name();
}

QString slopeText(const Measure& measure) {
  const QString degrees = fixedText(measure.degrees, 1) + QStringLiteral("°");
  return std::isfinite(measure.percent) ? QStringLiteral("%1 (%2 %)").arg(degrees, fixedText(measure.percent, 1))
                                        : degrees;
}

}  // namespace

Measure measureBetween(const Vec3& from, const Vec3& to) {
  Measure measure;
  measure.plan = std::hypot(to.x - from.x, to.y - from.y);
  measure.height = to.z - from.z;
  measure.distance = std::hypot(measure.plan, measure.height);
  // Clicked places are rounded, so lengths below this are zero.
  constexpr double kRounding = 1e-6;
  if (std::abs(measure.height) < kRounding * measure.distance) measure.height = 0;
  if (measure.plan < kRounding * measure.distance) measure.plan = 0;
  measure.degrees = measure.distance > 0 ? std::atan2(measure.height, measure.plan) * kDegrees : 0;
  measure.percent = measure.plan > 0      ? 100 * measure.height / measure.plan
                    : measure.height == 0 ? 0
                                          : std::copysign(std::numeric_limits<double>::infinity(), measure.height);
  return measure;
}

QString measureSummary(const Measure& measure, const LevelUnits& units) {
  return MeasureTool::tr("%1 (%2 in the plan), height %3, %4")
      .arg(units.length(measure.distance), units.length(measure.plan), signedText(measure.height, units),
           slopeText(measure));
}

MeasureTool::MeasureTool(LevelView& view, std::function<std::shared_ptr<const Environment>()> level)
    : view_(view), level_(std::move(level)) {}

void MeasureTool::setShown(bool shown) {
  shown_ = shown;
  draw();
}

void MeasureTool::setUnits(const LevelUnits& units) {
  units_ = units;
  draw();
  emit unitsChanged();
}

void MeasureTool::setPlaces(std::vector<Vec3> places) {
  places_ = std::move(places);
  isEnded_ = false;
  draw();
  emit placesChanged();
}

void MeasureTool::removeLast() {
  if (places_.empty()) return;
  places_.pop_back();
  isEnded_ = false;
  draw();
  emit placesChanged();
}

QString MeasureTool::hint() const {
  return tr(
      "Measure: click two or more places. Enter ends the line, Backspace takes a place back, Ctrl+C copies, Esc "
      "ends.");
}

QString MeasureTool::text() const {
  QString text = tr("x\ty\tz\tdistance\tin the plan\theight\tdegrees\tpercent") + QLatin1Char('\n');
  const auto length = [this](double value) { return numberText(units_.shown(value)); };
  Measure sum;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Vec3 p = units_.shownPlace(places_[i]);
    QStringList fields{numberText(p.x), numberText(p.y), numberText(p.z)};
    if (i > 0) {
      const Measure m = measureBetween(places_[i - 1], places_[i]);
      fields << length(m.distance) << length(m.plan) << length(m.height) << numberText(m.degrees)
             << (std::isfinite(m.percent) ? numberText(m.percent) : QString());
      sum.distance += m.distance;
      sum.plan += m.plan;
      sum.height += m.height;
    }
    text += fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  if (places_.size() > 2)
    text += tr("sum") + QStringLiteral("\t\t\t") +
            QStringList{length(sum.distance), length(sum.plan), length(sum.height)}.join(QLatin1Char('\t')) +
            QLatin1Char('\n');
  return text + units_.frameText() + QLatin1Char('\n');
}

/// The vertex nearest to the line of sight on the screen, where it is near enough and not hidden.
std::optional<Vec3> MeasureTool::vertexNear(const QPoint& place) const {
  const std::shared_ptr<const Environment> level = level_();
  const std::shared_ptr<const EnvironmentGeometry> geometry = view_.environmentGeometry();
  if (!level || !geometry) return std::nullopt;
  // The distance in space of two lines of sight that are one pixel apart; it grows with the distance in perspective.
  const Ray ray = view_.rayAt(place), next = view_.rayAt(place + QPoint(1, 0));
  const double length = std::sqrt(dot(ray.direction, ray.direction)),
               nextLength = std::sqrt(dot(next.direction, next.direction));
  const Vec3 along{ray.direction.x / length, ray.direction.y / length, ray.direction.z / length};
  const Vec3 turn =
      Vec3{next.direction.x / nextLength, next.direction.y / nextLength, next.direction.z / nextLength} - along;
  const Vec3 shift = next.origin - ray.origin;
  const double perDistance = std::sqrt(dot(turn, turn)), atEye = std::sqrt(dot(shift, shift));
  double best = kSnapPixels;
  std::optional<Vec3> nearest;
  for (const Vec3& vertex : level->vertices) {
    const Vec3 offset = vertex - ray.origin;
    const double depth = dot(offset, along);
    if (depth <= 0) continue;
    const double apart = std::sqrt(std::max(0.0, dot(offset, offset) - depth * depth));
    const double pixels = apart / (atEye + perDistance * depth);
    if (pixels >= best) continue;
    best = pixels;
    nearest = vertex;
  }
  if (!nearest) return std::nullopt;
  const auto at = view_.project(*nearest);
  if (!at || std::hypot(at->x() - place.x(), at->y() - place.y()) > kSnapPixels) return std::nullopt;
  // The coordinates are those of the view.
  const Vec3 fromCentre = *nearest - geometry->centre;
  const std::array<float, 3> shown{static_cast<float>(fromCentre.x), static_cast<float>(fromCentre.y),
                                   static_cast<float>(fromCentre.z)};
  // A vertex is visible when a surface with this corner is visible there, or right beside it, because a corner of an
  // outline lies between pixels.
  const QPoint pixel = at->toPoint();
  for (const QPoint& probe :
       {pixel, place, pixel + QPoint(2, 2), pixel + QPoint(-2, 2), pixel + QPoint(2, -2), pixel + QPoint(-2, -2)}) {
    const auto hit = view_.pick(probe);
    if (!hit || 3 * std::size_t{hit->triangle} + 2 >= geometry->surface.size()) continue;
    for (std::size_t i = 0; i < 3; ++i)
      if (geometry->surface[3 * std::size_t{hit->triangle} + i].position == shown) return nearest;
  }
  return std::nullopt;
}

std::optional<MeasureTool::Target> MeasureTool::targetAt(const QPoint& place) const {
  if (const auto vertex = vertexNear(place)) return Target{*vertex, true};
  if (const auto hit = view_.pick(place)) return Target{hit->point, false};
  return std::nullopt;
}

void MeasureTool::mouseMoved(const ViewMouse& mouse) {
  hovered_ = targetAt(mouse.place);
  draw();
}

void MeasureTool::clicked(const ViewMouse& mouse) {
  const auto target = targetAt(mouse.place);
  if (!target) return;
  // This is the second half of a double click.
  if (!places_.empty() && !isEnded_ && places_.back() == target->place) {
    isEnded_ = places_.size() > 1;
    draw();
    return;
  }
  if (std::exchange(isEnded_, false)) places_.clear();
  places_.push_back(target->place);
  hovered_.reset();
  draw();
  emit placesChanged();
}

bool MeasureTool::keyPressed(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      removeLast();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      isEnded_ = places_.size() > 1;
      if (!isEnded_) places_.clear();
      draw();
      return true;
    default:
      if (!event.matches(QKeySequence::Copy) || places_.empty()) return false;
      QApplication::clipboard()->setText(text());
      return true;
  }
}

void MeasureTool::mouseLeft() {
  hovered_.reset();
  draw();
}

void MeasureTool::ended() {
  hovered_.reset();
  isEnded_ = places_.size() > 1;
}

void MeasureTool::draw() {
  if (!shown_ || (places_.empty() && !hovered_)) {
    view_.removeOverlay(kMeasureOverlay);
    return;
  }
  ViewOverlay overlay;
  overlay.throughWalls = true;
  ViewOverlay::Lines lines{{}, lineColour(), 2, QColor(Qt::white)};
  const auto add = [&](const Vec3& from, const Vec3& to) {
    lines.segments.push_back({from, to});
    const Measure m = measureBetween(from, to);
    overlay.labels.push_back(
        {{(from.x + to.x) / 2, (from.y + to.y) / 2, (from.z + to.z) / 2},
         tr("%1\nplan %2, height %3\n%4")
             .arg(units_.length(m.distance), units_.length(m.plan), signedText(m.height, units_), slopeText(m))});
  };
  for (std::size_t i = 0; i + 1 < places_.size(); ++i) add(places_[i], places_[i + 1]);
  if (hovered_ && !places_.empty() && !isEnded_ && !(hovered_->place == places_.back()))
    add(places_.back(), hovered_->place);
  for (const Vec3& place : places_) overlay.marks.push_back({place, placeColour(), 9});
  if (hovered_) {
    overlay.marks.push_back(
        {hovered_->place, hovered_->isVertex ? vertexColour() : placeColour(), hovered_->isVertex ? 13.0F : 7.0F});
    if (hovered_->isVertex && (places_.empty() || isEnded_)) overlay.labels.push_back({hovered_->place, tr("vertex")});
  }
  overlay.lines.push_back(std::move(lines));
  view_.setOverlay(kMeasureOverlay, std::move(overlay));
}

}  // namespace footfall::ui
