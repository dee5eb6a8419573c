// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/timeline_lanes.hpp"

#include <algorithm>
#include <tuple>

#include "footfall/filter.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/base/look/plot_theme.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr double kText = 26;  // least width in pixels of a bar with a number
// The filters take the lower part of a bar.
constexpr double kSplit = 0.5;

QColor textOn(const QColor& colour) { return colour.lightnessF() > 0.5F ? QColor(20, 26, 32) : QColor(Qt::white); }

}  // namespace

QString labelOf(Timeline::Phase phase) {
  switch (phase) {
    case Timeline::Phase::Partitioning:
      return TimelineLanes::tr("partitioning");
    case Timeline::Phase::Parallel:
      return TimelineLanes::tr("cells");
    case Timeline::Phase::Merging:
      return TimelineLanes::tr("merging");
  }
  return {};
}

QString labelOf(const Timeline::Serial& part) {
  using Kind = Timeline::Serial::Kind;
  switch (part.kind) {
    case Kind::Start:
      return TimelineLanes::tr("first state");
    case Kind::Step:
      if (const FilterDescriptor* filter = findFilter(part.filter)) return filterText(filter->label);
      break;
    case Kind::Between:
      return TimelineLanes::tr("between the steps");
    case Kind::Partitioning:
      return labelOf(Timeline::Phase::Partitioning);
    case Kind::Merging:
      return labelOf(Timeline::Phase::Merging);
    case Kind::Finish:
      return TimelineLanes::tr("navigation mesh");
  }
  return QString::fromStdString(part.filter);
}

namespace {

QColor serialColour(Timeline::Serial::Kind kind) {
  switch (kind) {
    case Timeline::Serial::Kind::Partitioning:
      return toColour(kOrange);
    case Timeline::Serial::Kind::Merging:
      return toColour(kReddishPurple);
    case Timeline::Serial::Kind::Between:
      return {184, 190, 198};
    default:
      break;
  }
  return {128, 140, 156};
}

}  // namespace

TimelineLanes::TimelineLanes(QCPAxis* time, QCPAxis* lanes, const CellModel& model, const Timeline& timeline)
    : QCPAbstractPlottable(time, lanes), model_(model), timeline_(timeline) {
  setSelectable(QCP::stNone);
}

void TimelineLanes::takeColours() {
  scales_.clear();
  for (std::size_t i = 0; i < model_.blocks().size(); ++i) scales_.push_back(model_.scaleOf(i));
}

double TimelineLanes::selectTest(const QPointF& /*pos*/, bool /*onlySelectable*/, QVariant* /*details*/) const {
  return -1;  // the plot finds bars itself
}

QCPRange TimelineLanes::getKeyRange(bool& found, QCP::SignDomain /*domain*/) const {
  found = timeline_.end > timeline_.start;
  return {timeline_.start, timeline_.end};
}

QCPRange TimelineLanes::getValueRange(bool& found, QCP::SignDomain /*domain*/, const QCPRange& /*keys*/) const {
  found = timeline_.lanes > 0;
  return {-0.5, timeline_.lanes - 0.5};
}

// A rectangle from `from` to `to` of the lane's height; 0 is its upper side.
QRectF TimelineLanes::place(int lane, double start, double end, double from, double to) const {
  const double left = mKeyAxis->coordToPixel(start);
  const double right = mKeyAxis->coordToPixel(end);
  const double top = mValueAxis->coordToPixel(lane - kHalfLane);
  const double bottom = mValueAxis->coordToPixel(lane + kHalfLane);
  return {QPointF(left, top + from * (bottom - top)), QPointF(right, top + to * (bottom - top))};
}

QColor TimelineLanes::colourOf(const Timeline::Bar& bar) const {
  if (!bar.cell || bar.cell->block >= scales_.size()) return {196, 202, 209};
  return scales_[bar.cell->block].colourOf(bar.cell->cell).value_or(unfinishedColour());
}

void TimelineLanes::draw(QCPPainter* painter) {
  painter->setAntialiasing(false);
  drawBands(painter);
  drawIdle(painter);
  drawSerial(painter);
  drawOthers(painter);
  const QCPRange seen = mKeyAxis->range();
  for (const Timeline::Bar& bar : timeline_.bars) {
    if (bar.end >= seen.lower && bar.start <= seen.upper) drawBar(painter, bar);
  }
  drawMark(painter, model_.selected(), selectedCellColour());
  drawMark(painter, model_.hovered(), QColor(Qt::white));
}

void TimelineLanes::drawBands(QCPPainter* painter) const {
  const QRect area = clipRect();
  for (const Timeline::Band& band : timeline_.bands) {
    if (band.end <= band.start) continue;
    const double left = mKeyAxis->coordToPixel(band.start);
    const double right = mKeyAxis->coordToPixel(band.end);
    const QRectF strip(left, area.top(), std::max(1.0, right - left), area.height());
    if (band.phase != Timeline::Phase::Parallel) painter->fillRect(strip, plotAreaColour());
    painter->setPen(plotLineColour());
    painter->drawLine(strip.topLeft(), strip.bottomLeft());
    painter->drawLine(strip.topRight(), strip.bottomRight());
    const QString text = labelOf(band.phase);
    painter->setPen(fainterTextColour());
    const QRectF head(left + 3, area.top() + 1, strip.width() - 6, 15);
    if (QFontMetricsF(painter->font()).horizontalAdvance(text) <= head.width())
      painter->drawText(head, Qt::AlignHCenter | Qt::AlignVCenter, text);
  }
}

// Draws waiting threads, where no bar is while cells run.
void TimelineLanes::drawIdle(QCPPainter* painter) const {
  for (const Timeline::Band& band : timeline_.bands) {
    if (band.phase != Timeline::Phase::Parallel || band.end <= band.start) continue;
    for (int lane = 0; lane < timeline_.lanes; ++lane) {
      const QRectF box = place(lane, band.start, band.end, 0, 1);
      painter->fillRect(box, isDarkTheme() ? QColor(58, 42, 38) : QColor(250, 238, 233));
      painter->fillRect(box, QBrush(isDarkTheme() ? QColor(132, 92, 78) : QColor(214, 160, 140), Qt::BDiagPattern));
    }
  }
}

// A part that keeps few threads busy fills the lanes' height by its share of the threads; the other threads wait.
void TimelineLanes::drawSerial(QCPPainter* painter) const {
  const QCPRange seen = mKeyAxis->range();
  const double lanes = timeline_.lanes;
  const QColor waiting = isDarkTheme() ? QColor(86, 94, 104) : QColor(190, 197, 205);
  for (const Timeline::Serial& part : timeline_.serial) {
    if (part.end < seen.lower || part.start > seen.upper) continue;
    const QRectF first = place(0, part.start, part.end, 0, 1);
    const QRectF last = place(timeline_.lanes - 1, part.start, part.end, 0, 1);
    QRectF whole(first.topLeft(), last.bottomRight());
    whole.setWidth(std::max(1.0, whole.width()));
    painter->fillRect(whole, QBrush(waiting, Qt::Dense6Pattern));
    QRectF busy = whole;
    busy.setHeight(std::clamp(part.threads / std::max(1.0, lanes), 0.0, 1.0) * whole.height());
    const QColor colour = serialColour(part.kind);
    painter->fillRect(busy, colour);
    painter->setPen(plotLineColour());
    painter->drawLine(whole.topLeft(), whole.bottomLeft());
    const QString text = labelOf(part);
    if (QFontMetricsF(painter->font()).horizontalAdvance(text) + 6 > whole.width()) continue;
    const bool fits = busy.height() >= 13;
    painter->setPen(fits ? textOn(colour) : fainterTextColour());
    painter->drawText(fits ? busy : QRectF(whole.left(), busy.bottom(), whole.width(), 15), Qt::AlignCenter, text);
  }
}

// The lane below those of the threads shows how many threads waited for a processor.
void TimelineLanes::drawOthers(QCPPainter* painter) const {
  const std::vector<ProcessorSample>& samples = timeline_.processors.samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double length = samples[i].atMs - samples[i - 1].atMs;
    if (length <= 0) continue;
    const double lanes = std::max(1, timeline_.lanes);
    const double free = std::max(0.0, lanes - (samples[i].cpuMs - samples[i - 1].cpuMs) / length);
    const double waiting = std::min(free, (samples[i].waitedMs - samples[i - 1].waitedMs) / length) / lanes;
    painter->fillRect(
        place(timeline_.lanes, samples[i - 1].atMs, samples[i].atMs, 1 - std::clamp(waiting, 0.0, 1.0), 1),
        toColour(kVermilion));
  }
}

void TimelineLanes::drawBar(QCPPainter* painter, const Timeline::Bar& bar) const {
  const QColor colour = colourOf(bar);
  QRectF whole = place(bar.lane, bar.start, bar.end, 0, 1);
  whole.setWidth(std::max(1.0, whole.width()));
  painter->fillRect(whole, colour);
  if (whole.width() >= 4) {
    for (const Timeline::Segment& segment : bar.segments) {
      const QRectF box = place(bar.lane, segment.start, segment.end, kSplit, 1);
      const QColor shade = filterColour(segment.filter);
      painter->fillRect(box, shade);
      const QString name = filterName(timeline_.filters[segment.filter]);
      if (QFontMetricsF(painter->font()).horizontalAdvance(name) + 6 > box.width() || box.height() < 12) continue;
      painter->setPen(textOn(shade));
      painter->drawText(box, Qt::AlignCenter, name);
    }
  }
  if (bar.cell && model_.isCached(*bar.cell)) {
    QColor cross = textOn(colour);
    cross.setAlphaF(0.45F);
    painter->fillRect(QRectF(whole.topLeft(), QSizeF(whole.width(), kSplit * whole.height())),
                      QBrush(cross, Qt::DiagCrossPattern));
  }
  if (bar.cell && whole.width() >= kText) {
    const QRectF head = place(bar.lane, bar.start, bar.end, 0, kSplit);
    painter->setPen(textOn(colour));
    if (head.height() >= 11) painter->drawText(head, Qt::AlignCenter, QString::number(bar.cell->cell + 1));
  }
  if (whole.width() < 3) return;
  painter->setPen(outlineColour());
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(whole);
}

// Marks all bars of a cell: helper threads have bars on other lanes.
void TimelineLanes::drawMark(QCPPainter* painter, const std::optional<CellId>& cell, const QColor& colour) const {
  if (!cell) return;
  for (const Timeline::Bar& bar : timeline_.bars) {
    if (bar.cell != cell) continue;
    QRectF box = place(bar.lane, bar.start, bar.end, 0, 1);
    box.setWidth(std::max(3.0, box.width()));
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(outlineColour(), 4));
    painter->drawRect(box);
    painter->setPen(QPen(colour, 2));
    painter->drawRect(box);
  }
}

void TimelineLanes::drawLegendIcon(QCPPainter* painter, const QRectF& rect) const {
  painter->fillRect(rect, unfinishedColour());
}

}  // namespace footfall::ui
