// A histogram of the cells' times.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <vector>

#include "ui/view/cells/cell_block.hpp"

namespace footfall::ui {

/// Counts of values in bins whose bounds grow by a constant factor, because times of cells differ by orders of
/// magnitude.
struct Histogram {
  std::vector<double> bounds;  ///< one entry more than counts, ascending; empty without values
  std::vector<int> counts;
};
/// At most `bins` bins from the smallest value to the largest. Values that are not above 0 count in the first bin.
Histogram histogramOf(const std::vector<double>& values, int bins);

class HistogramPlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit HistogramPlot(QWidget* parent = nullptr);
  void show(const CellBlock& block);
  [[nodiscard]] const Histogram& histogram() const { return histogram_; }
  /// A summary of the times: "24 cells: median 12 ms, longest 480 ms (cell 7)".
  [[nodiscard]] QString summary() const { return summary_; }

 protected:
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QCPBars* bars_;
  Histogram histogram_;
  QString summary_;
};

}  // namespace footfall::ui
