// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/timeline_plot.hpp"

#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/base/look/plot_theme.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/cells/balance_plot.hpp"
#include "ui/cells/timeline_lanes.hpp"

namespace footfall::ui {
namespace {

constexpr double kHead = 0.42;          // share of a lane's height, for the names of the phases
constexpr double kClosest = 1.0 / 2e4;  // the least share of the whole time that zooming shows

}  // namespace

TimelinePlot::TimelinePlot(CellModel& model, QWidget* parent) : QCustomPlot(parent), model_(model) {
  setFocusPolicy(Qt::NoFocus);  // the plot has no keyboard actions
  setObjectName(QStringLiteral("timeline"));
  setMinimumHeight(90);
  setMouseTracking(true);
  setAccessibleName(tr("Timeline"));
  setAccessibleDescription(tr("A lane for each thread, with a bar for each cell that it worked on"));
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  axisRect()->setRangeDrag(Qt::Horizontal);
  axisRect()->setRangeZoom(Qt::Horizontal);
  axisRect()->setRangeZoomFactor(0.8);
  yAxis->setRangeReversed(true);
  yAxis->grid()->setVisible(false);
  yAxis->setTicker(QSharedPointer<QCPAxisTickerText>::create());
  yAxis->setTickLength(0);
  yAxis->setSubTicks(false);
  QFont small = font();
  small.setPixelSize(11);
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
  }
  new PlotTheme(this);
  xAxis->setLabelPadding(1);
  lanes_ = new TimelineLanes(xAxis, yAxis, model_, timeline_);  // the plot owns it
  connect(xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &TimelinePlot::limitRange);
  connect(&model_, &CellModel::figuresChanged, this, &TimelinePlot::rebuild);
  const auto repaint = [this] { replot(QCustomPlot::rpQueuedReplot); };
  connect(&model_, &CellModel::hoveredChanged, this, repaint);
  connect(&model_, &CellModel::selectedChanged, this, repaint);
  rebuild();
}

void TimelinePlot::rebuild() {
  timeline_ = {};
  if (const CellBlock* block = model_.shownBlock()) {
    timeline_ = block->begun() ? makeTimeline(model_.blocks(), model_.shownIndex())
                               : planTimeline(*block, model_.shownIndex(), model_.threads());
  }
  xAxis->setLabel(timeline_.planned ? tr("estimated work (units), the largest cells first")
                                    : tr("time since the run began (ms)"));
  lanes_->takeColours();
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const int step = std::max(1, timeline_.lanes / 16);
  const CellRanks ranks = model_.empty() ? CellRanks() : model_.shownBlock()->ranks;
  for (int lane = 0; lane < timeline_.lanes; lane += step) ticker->addTick(lane, threadName(ranks, lane));
  const bool hasOthers = timeline_.processors.known();
  if (hasOthers) ticker->addTick(timeline_.lanes, tr("Others"));
  yAxis->setTicker(ticker);
  yAxis->setRange(-0.5 - kHead * std::max(1.0, timeline_.lanes / 4.0),
                  std::max(1, timeline_.lanes) - 0.5 + (hasOthers ? 1 : 0));
  // The whole of a running run stays visible; a zoomed part of a finished run stays as well.
  const auto& blocks = model_.blocks();
  const auto run = blocks.empty() ? nullptr : blocks[model_.shownIndex()].run;
  if (!run || run != shownRun_ || timeline_.end != shownEnd_) showAll();
  shownRun_ = run;
  shownEnd_ = timeline_.end;
  replot(QCustomPlot::rpQueuedReplot);
}

void TimelinePlot::showAll() {
  const double length = timeline_.end - timeline_.start;
  const double margin = length > 0 ? 0.01 * length : 1;
  xAxis->setRange(timeline_.start - margin, timeline_.end + margin);
  replot(QCustomPlot::rpQueuedReplot);
}

// Limits the range to the run, and to the resolution of the clock.
void TimelinePlot::limitRange(const QCPRange& range) {
  const double length = timeline_.end - timeline_.start;
  if (length <= 0) return;
  const double size = std::clamp(range.size(), length * kClosest, 1.02 * length);
  const double first = timeline_.start - 0.01 * length;
  const double last = timeline_.end + 0.01 * length;
  const double middle = std::clamp(range.center(), first + size / 2, std::max(first + size / 2, last - size / 2));
  const QCPRange limited(middle - size / 2, middle + size / 2);
  const double tolerance = 1e-9 * length;
  if (std::abs(limited.lower - range.lower) > tolerance || std::abs(limited.upper - range.upper) > tolerance)
    xAxis->setRange(limited);
}

const Timeline::Bar* TimelinePlot::barAt(const QPointF& place) const {
  if (!axisRect()->rect().contains(place.toPoint())) return nullptr;
  const double row = yAxis->pixelToCoord(place.y());
  const int lane = static_cast<int>(std::lround(row));
  if (std::abs(row - lane) > TimelineLanes::kHalfLane) return nullptr;
  const double time = xAxis->pixelToCoord(place.x());
  if (const Timeline::Bar* bar = timeline_.at(lane, time)) return bar;
  // Bars narrower than a pixel can be hovered as well.
  const double pixel = xAxis->pixelToCoord(place.x() + 1.5) - time;
  for (const double near : {time - pixel, time + pixel}) {
    if (const Timeline::Bar* bar = timeline_.at(lane, near)) return bar;
  }
  return nullptr;
}

QPointF TimelinePlot::placeOf(const Timeline::Bar& bar) const {
  return {xAxis->coordToPixel((bar.start + bar.end) / 2), yAxis->coordToPixel(bar.lane)};
}

QString TimelinePlot::describe(const Timeline::Bar& bar, const QPointF& place) const {
  const double time = xAxis->pixelToCoord(place.x());
  QString text = bar.cell ? model_.describe(*bar.cell) : QStringLiteral("<b>%1</b><br>").arg(tr("Whole environment"));
  for (const Timeline::Segment& segment : bar.segments) {
    if (time < segment.start || time > segment.end) continue;
    text += tr("Here %1<br>on thread %2, %3 to %4 ms")
                .arg(filterName(timeline_.filters[segment.filter]))
                .arg(bar.lane)
                .arg(fixedText(segment.start, 2))
                .arg(fixedText(segment.end, 2));
  }
  return text;
}

// Describes the length of a pause and its reason.
QString TimelinePlot::describeIdle(const QPointF& place) const {
  if (timeline_.planned) return {};
  const double time = xAxis->pixelToCoord(place.x());
  const int lane = static_cast<int>(std::lround(yAxis->pixelToCoord(place.y())));
  if (lane == timeline_.lanes) return describeOthers(time);
  if (lane < 0 || lane >= timeline_.lanes) return {};
  for (const Timeline::Serial& part : timeline_.serial)
    if (time >= part.start && time <= part.end) return describeSerial(part);
  for (const Timeline::Band& band : timeline_.bands) {
    if (time < band.start || time > band.end) continue;
    if (band.phase != Timeline::Phase::Parallel)
      return tr("%1: %2").arg(labelOf(band.phase), durationText(band.end - band.start));
    double from = band.start;
    double to = band.end;
    for (const Timeline::Bar& bar : timeline_.bars) {
      if (bar.lane != lane) continue;
      if (bar.end <= time) from = std::max(from, bar.end);
      if (bar.start >= time) to = std::min(to, bar.start);
    }
    return tr("Thread %1 was idle for %2").arg(lane).arg(durationText(to - from)) + QStringLiteral("<br>") +
           tr("It waited for work: other threads had the last cells.");
  }
  return {};
}

QString TimelinePlot::describeSerial(const Timeline::Serial& part) const {
  const double length = part.end - part.start;
  QString text = QStringLiteral("<b>%1</b>: %2").arg(labelOf(part).toHtmlEscaped(), durationText(length));
  text += QStringLiteral("<br>") + tr("Busy threads: %1 of %2").arg(fixedText(part.threads, 1)).arg(timeline_.lanes);
  const double waiting = (timeline_.lanes - part.threads) * length;
  if (waiting > 0.05 * length)
    text += QStringLiteral("<br>") + tr("The others waited for it: %1 of thread time").arg(durationText(waiting));
  return text;
}

QString TimelinePlot::describeOthers(double time) const {
  const std::vector<ProcessorSample>& samples = timeline_.processors.samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (time < samples[i - 1].atMs || time > samples[i].atMs) continue;
    return tr("Other programs had the processors for %1 of the thread time that this part could have used")
        .arg(durationText(samples[i].waitedMs - samples[i - 1].waitedMs));
  }
  return {};
}

void TimelinePlot::mousePressEvent(QMouseEvent* event) {
  pressed_ = event->button() == Qt::LeftButton ? std::optional(event->position()) : std::nullopt;
  QCustomPlot::mousePressEvent(event);
}

void TimelinePlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  if (event->buttons() != Qt::NoButton) {
    const bool dragged =
        pressed_ && (event->position() - *pressed_).manhattanLength() >= QApplication::startDragDistance();
    if (dragged) pressed_.reset();
    return;
  }
  const Timeline::Bar* bar = barAt(event->position());
  model_.setHovered(bar ? bar->cell : std::nullopt);
  const bool inside = axisRect()->rect().contains(event->position().toPoint());
  const QString text = bar ? describe(*bar, event->position()) : inside ? describeIdle(event->position()) : QString();
  QToolTip::showText(event->globalPosition().toPoint(), text, this);
}

void TimelinePlot::mouseReleaseEvent(QMouseEvent* event) {
  QCustomPlot::mouseReleaseEvent(event);
  if (!std::exchange(pressed_, std::nullopt)) return;
  const Timeline::Bar* bar = barAt(event->position());
  model_.select(bar ? bar->cell : std::nullopt, true);
}

void TimelinePlot::mouseDoubleClickEvent(QMouseEvent* event) {
  QCustomPlot::mouseDoubleClickEvent(event);
  showAll();
}

void TimelinePlot::leaveEvent(QEvent* event) {
  model_.setHovered({});
  QCustomPlot::leaveEvent(event);
}

}  // namespace footfall::ui
