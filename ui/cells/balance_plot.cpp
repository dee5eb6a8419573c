// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/balance_plot.hpp"

#include <QToolTip>
#include <algorithm>
#include <numeric>

#include "ui/base/look/core_colours.hpp"
#include "ui/base/look/plot_theme.hpp"
#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {
namespace {

void calm(QCustomPlot& plot) {
  QFont small = plot.font();
  small.setPixelSize(11);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
    axis->setSubTicks(false);
  }
  new PlotTheme(&plot);
  plot.yAxis->grid()->setVisible(false);
  plot.setInteractions(QCP::iNone);
}

}  // namespace

LoadFigures figuresOf(const CellBlock& block) {
  LoadFigures figures;
  const int threads = block.threads();
  figures.busyMs = block.report.busyMs(threads);
  figures.workMs = std::accumulate(figures.busyMs.begin(), figures.busyMs.end(), 0.0);
  figures.imbalance = block.report.imbalance(threads);
  if (!block.ranks.empty()) {
    figures.busyMs = block.busyMsOfRanks();
    const double mean =
        std::accumulate(figures.busyMs.begin(), figures.busyMs.end(), 0.0) / static_cast<double>(figures.busyMs.size());
    figures.imbalance = mean > 0 ? std::ranges::max(figures.busyMs) / mean : 1;
  }
  if (block.report.parallelMs > 0) figures.speedUp = figures.workMs / block.report.parallelMs;
  return figures;
}

std::array<PhaseTime, 6> phasesOf(const RunTimes& times) {
  return {{{BusyPlot::tr("pre-processing"), times.preprocessing, {150, 160, 173}},
           {BusyPlot::tr("partitioning"), times.partitioning, toColour(kOrange)},
           {BusyPlot::tr("cells"), times.parallel, toColour(kBlue)},
           {BusyPlot::tr("merging"), times.merging, toColour(kReddishPurple)},
           {BusyPlot::tr("post-processing"), times.postprocessing, {92, 103, 118}},
           {BusyPlot::tr("overhead"), times.overhead, {214, 219, 226}}}};
}

std::array<PhaseTime, 5> timesOf(const TimeUse& use) {
  return {{{BusyPlot::tr("cells"), use.cells, toColour(kBlue)},
           {BusyPlot::tr("other steps"), use.steps, {128, 140, 156}},
           {BusyPlot::tr("waiting for work"), use.waitingForWork, {226, 170, 150}},
           {BusyPlot::tr("waiting for a serial step"), use.waitingForStep, {200, 206, 213}},
           {BusyPlot::tr("other programs"), use.otherPrograms, toColour(kVermilion)}}};
}

BusyPlot::BusyPlot(QWidget* parent) : QCustomPlot(parent) {
  setFocusPolicy(Qt::NoFocus);  // the plot has no keyboard actions
  setObjectName(QStringLiteral("busyPlot"));
  setAccessibleName(tr("Time that each thread was busy"));
  setMinimumHeight(70);
  calm(*this);
  yAxis->setRangeReversed(true);
  yAxis->setTickLength(0);
  xAxis->setLabelPadding(1);
  xAxis->ticker()->setTickCount(4);
  bars_ = new QCPBars(yAxis, xAxis);  // the plot owns it
  bars_->setWidth(0.72);
  bars_->setPen(Qt::NoPen);
  bars_->setBrush(toColour(kBlue));
  bars_->setAntialiased(false);
  mean_ = new QCPItemStraightLine(this);
  mean_->setPen(QPen(toColour(kVermilion), 1.5, Qt::DashLine));
  mean_->setClipToAxisRect(true);
}

void BusyPlot::show(const CellBlock& block) {
  planned_ = false;
  hasRanks_ = !block.ranks.empty();
  xAxis->setLabel(tr("busy with cells (ms); line: mean"));
  showLoads(figuresOf(block).busyMs);
}

void BusyPlot::showPlan(const std::vector<double>& loads) {
  planned_ = true;
  hasRanks_ = false;
  xAxis->setLabel(tr("estimated work (units); line: mean"));
  showLoads(loads);
}

void BusyPlot::showLoads(const std::vector<double>& loads) {
  loads_ = loads;
  const auto threads = static_cast<int>(loads.size());
  QVector<double> keys(threads);
  std::iota(keys.begin(), keys.end(), 0.0);
  bars_->setData(keys, QVector<double>(loads.begin(), loads.end()), true);
  bars_->setBrush(planned_ ? QColor(150, 160, 173) : toColour(kBlue));
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (int i = 0; i < threads; i += std::max(1, threads / 12))
    ticker->addTick(i, (hasRanks_ ? tr("Rank %1") : tr("Thread %1")).arg(i));
  yAxis->setTicker(ticker);
  yAxis->setRange(-0.5, std::max(1, threads) - 0.5);
  const double largest = loads.empty() ? 0 : std::ranges::max(loads);
  xAxis->setRange(0, largest > 0 ? 1.05 * largest : 1);
  const double mean = threads > 0 ? std::accumulate(loads.begin(), loads.end(), 0.0) / threads : 0;
  mean_->setVisible(mean > 0);
  mean_->point1->setCoords(mean, 0);
  mean_->point2->setCoords(mean, 1);
  replot(QCustomPlot::rpQueuedReplot);
}

void BusyPlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  const int thread = static_cast<int>(std::lround(yAxis->pixelToCoord(event->position().y())));
  QString text;
  if (thread >= 0 && thread < static_cast<int>(loads_.size())) {
    const double load = loads_[static_cast<std::size_t>(thread)];
    text = planned_ ? tr("Thread %1 would have %2").arg(thread).arg(valueText(CellColouring::Cost, load))
                    : (hasRanks_ ? tr("Rank %1 was busy for %2") : tr("Thread %1 was busy for %2"))
                          .arg(thread)
                          .arg(durationText(load));
  }
  QToolTip::showText(event->globalPosition().toPoint(), text, this);
}

PhasePlot::PhasePlot(QWidget* parent) : QCustomPlot(parent) {
  setFocusPolicy(Qt::NoFocus);  // the plot has no keyboard actions
  setObjectName(QStringLiteral("phasePlot"));
  setAccessibleName(tr("How the time of the run was used"));
  setFixedHeight(22);
  calm(*this);
  for (QCPAxis* axis : {xAxis, yAxis}) axis->setVisible(false);
  axisRect()->setAutoMargins(QCP::msNone);
  axisRect()->setMargins({0, 1, 0, 1});
  QCPBars* below = nullptr;
  for (QCPBars*& bar : bars_) {
    bar = new QCPBars(yAxis, xAxis);  // the plot owns it
    bar->setWidth(1);
    bar->setPen(QPen(plotLineColour(), 0));
    bar->setAntialiased(false);
    if (below) bar->moveAbove(below);
    below = bar;
  }
  yAxis->setRange(-0.5, 0.5);
}

void PhasePlot::show(const RunTimes& times) { showTimes(phasesOf(times)); }

void PhasePlot::show(const TimeUse& use) { showTimes(timesOf(use)); }

void PhasePlot::showTimes(std::span<const PhaseTime> phases) {
  double sum = 0;
  for (std::size_t i = 0; i < bars_.size(); ++i) {
    const double time = i < phases.size() ? std::max(0.0, phases[i].milliseconds) : 0;
    bars_[i]->setData({0.0}, {time});
    if (i < phases.size()) bars_[i]->setBrush(phases[i].colour);
    sum += time;
  }
  xAxis->setRange(0, sum > 0 ? sum : 1);
  replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace footfall::ui
