// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/look/plot_theme.hpp"

#include <QEvent>

#include "ui/base/look/theme.hpp"

namespace footfall::ui {

QColor plotLineColour() { return isDarkTheme() ? QColor(108, 117, 127) : QColor(150, 158, 168); }
QColor plotAreaColour() { return isDarkTheme() ? QColor(52, 58, 65) : QColor(226, 231, 237); }

PlotTheme::PlotTheme(QCustomPlot* plot) : QObject(plot), plot_(plot) {
  plot->installEventFilter(this);
  apply();
}

bool PlotTheme::eventFilter(QObject* watched, QEvent* event) {
  if (watched == plot_ && event->type() == QEvent::PaletteChange) apply();
  return QObject::eventFilter(watched, event);
}

void PlotTheme::apply() {
  const QPalette& palette = plot_->palette();
  plot_->setBackground(QBrush(palette.color(QPalette::Base)));
  const QPen line(plotLineColour());
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setBasePen(line);
    axis->setTickPen(line);
    axis->setSubTickPen(line);
    axis->setTickLabelColor(palette.color(QPalette::Text));
    axis->setLabelColor(palette.color(QPalette::Text));
    axis->grid()->setPen(QPen(plotAreaColour()));
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace footfall::ui
