// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/histogram_plot.hpp"

#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/base/look/core_colours.hpp"
#include "ui/base/look/plot_theme.hpp"
#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {
namespace {

constexpr int kBins = 18;

}  // namespace

Histogram histogramOf(const std::vector<double>& values, int bins) {
  Histogram histogram;
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  if (sorted.empty() || sorted.back() <= 0) return histogram;
  const double least = *std::ranges::upper_bound(sorted, 0.0);
  const double most = sorted.back();
  const int count = most > least ? bins : 1;
  for (int i = 0; i <= count; ++i)
    histogram.bounds.push_back(least * std::pow(most / least, static_cast<double>(i) / count));
  histogram.bounds.back() = most;
  histogram.counts.assign(static_cast<std::size_t>(count), 0);
  for (const double value : sorted) {
    const auto after = std::upper_bound(histogram.bounds.begin() + 1, histogram.bounds.end() - 1, value);
    ++histogram.counts[static_cast<std::size_t>(after - histogram.bounds.begin()) - 1];
  }
  return histogram;
}

HistogramPlot::HistogramPlot(QWidget* parent) : QCustomPlot(parent) {
  setFocusPolicy(Qt::NoFocus);  // the plot has no keyboard actions
  setObjectName(QStringLiteral("histogramPlot"));
  setAccessibleName(tr("How many cells took how long"));
  setMinimumHeight(70);
  QFont small = font();
  small.setPixelSize(11);
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
    axis->setSubTicks(false);
  }
  new PlotTheme(this);
  setInteractions(QCP::iNone);
  xAxis->grid()->setVisible(false);
  xAxis->setLabelPadding(1);
  xAxis->setLabel(tr("time of a cell"));
  yAxis->setLabel(tr("cells"));
  yAxis->ticker()->setTickCount(3);
  bars_ = new QCPBars(xAxis, yAxis);  // the plot owns it
  bars_->setWidth(0.94);
  bars_->setPen(Qt::NoPen);
  bars_->setBrush(toColour(kBlue));
  bars_->setAntialiased(false);
}

void HistogramPlot::show(const CellBlock& block) {
  std::vector<double> times;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < block.report.cells.size(); ++i) {
    if (block.finished[i] == 0) continue;
    times.push_back(block.report.cells[i].workMs());
    if (times.back() >= block.report.cells[longest].workMs() || block.finished[longest] == 0) longest = i;
  }
  histogram_ = histogramOf(times, std::min(kBins, std::max(1, static_cast<int>(times.size()))));
  const auto count = static_cast<int>(histogram_.counts.size());
  QVector<double> keys(count);
  std::iota(keys.begin(), keys.end(), 0.0);
  bars_->setData(keys, QVector<double>(histogram_.counts.begin(), histogram_.counts.end()), true);
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const int step = std::max(1, (count + 2) / 3);
  for (int i = 0; i <= count && count > 0; i += step)
    ticker->addTick(i - 0.5, durationText(histogram_.bounds[static_cast<std::size_t>(i)]));
  xAxis->setTicker(ticker);
  xAxis->setRange(-0.7, std::max(1, count) - 0.3);
  yAxis->setRange(0, count > 0 ? 1.1 * std::ranges::max(histogram_.counts) : 1);
  summary_.clear();
  if (!times.empty()) {
    std::ranges::sort(times);
    summary_ = tr("%n cell(s): median %1, longest %2 (cell %3)", nullptr, static_cast<int>(times.size()))
                   .arg(durationText(times[times.size() / 2]), durationText(times.back()))
                   .arg(longest + 1);
  }
  replot(QCustomPlot::rpQueuedReplot);
}

void HistogramPlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  const auto bin = std::lround(xAxis->pixelToCoord(event->position().x()));
  QString text;
  if (bin >= 0 && bin < static_cast<long>(histogram_.counts.size())) {
    const auto i = static_cast<std::size_t>(bin);
    text = tr("%n cell(s) took %1 to %2", nullptr, histogram_.counts[i])
               .arg(durationText(histogram_.bounds[i]), durationText(histogram_.bounds[i + 1]));
  }
  QToolTip::showText(event->globalPosition().toPoint(), text, this);
}

}  // namespace footfall::ui
