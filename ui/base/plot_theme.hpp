// Plots in the colours of the theme.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <QObject>

namespace footfall::ui {

/// Gives a plot's background, axes, labels and grids the colours of its palette, and again when that changes. Belongs
/// to the plot; make it once the plot has its axes.
class PlotTheme : public QObject {
  Q_OBJECT

 public:
  explicit PlotTheme(QCustomPlot* plot);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void apply();

  QCustomPlot* plot_;
};

/// Lines and areas of a plot that say nothing by their colour.
QColor plotLineColour();
QColor plotAreaColour();

}  // namespace footfall::ui
