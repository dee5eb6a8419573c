// Gives plots the colours of the theme.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <QObject>

namespace footfall::ui {

/// Sets the colours of a plot's background, axes, labels and grids from its palette, and again when that changes. The
/// plot owns it; make it once the plot has its axes.
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

/// The colour of lines and areas of a plot that carries no meaning.
QColor plotLineColour();
QColor plotAreaColour();

}  // namespace footfall::ui
