// Plots of the work of each thread, and of the parts of a run's time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <array>
#include <span>

#include "ui/cells/cell_model.hpp"
#include "ui/cells/timeline.hpp"

namespace footfall::ui {

/// The figures of a block and its run, for display and tests.
struct LoadFigures {
  std::vector<double> busyMs;  ///< time of each thread on cells
  double workMs = 0;           ///< their sum
  double imbalance = 1;        ///< largest time over the mean
  double speedUp = 0;          ///< work over the time of the parallel phase; 0 while it is not known
};
LoadFigures figuresOf(const CellBlock& block);

/// The times t_preprocessing to t_overhead (thesis 5.4), in the order in which they are shown.
struct PhaseTime {
  QString name;
  double milliseconds = 0;
  QColor colour;
};
std::array<PhaseTime, 6> phasesOf(const RunTimes& times);

/// The uses of all threads' time (TimeUse), in the order in which they are shown.
std::array<PhaseTime, 5> timesOf(const TimeUse& use);

/// A bar for each thread, or each rank where there are ranks: its time on cells; a line marks the mean.
class BusyPlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit BusyPlot(QWidget* parent = nullptr);
  void show(const CellBlock& block);
  /// Shows the expected work of each thread before a run.
  void showPlan(const std::vector<double>& loads);
  [[nodiscard]] QCPBars* bars() const { return bars_; }

 protected:
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void showLoads(const std::vector<double>& loads);

  QCPBars* bars_;
  QCPItemStraightLine* mean_;
  std::vector<double> loads_;
  bool planned_ = false, hasRanks_ = false;
};

/// A bar for the run with a piece for each phase, or for each use of the threads' time.
class PhasePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit PhasePlot(QWidget* parent = nullptr);
  void show(const RunTimes& times);
  void show(const TimeUse& use);
  [[nodiscard]] const std::array<QCPBars*, 6>& bars() const { return bars_; }

 private:
  void showTimes(std::span<const PhaseTime> phases);

  std::array<QCPBars*, 6> bars_{};
};

}  // namespace footfall::ui
