// How evenly the threads were busy, and where the time of the run went.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <array>
#include <span>

#include "ui/cells/cell_model.hpp"
#include "ui/cells/timeline.hpp"

namespace footfall::ui {

/// The figures of a block and its run, for people and tests.
struct LoadFigures {
  std::vector<double> busyMs;  ///< of each thread, on cells
  double workMs = 0;           ///< the sum of it
  double imbalance = 1;        ///< the largest over the mean
  double speedUp = 0;          ///< work over the time of the parallel phase; 0 while it is not known
};
LoadFigures figuresOf(const CellBlock& block);

/// t_preprocessing to t_overhead (thesis 5.4), in the order in which they are shown.
struct PhaseTime {
  QString name;
  double milliseconds = 0;
  QColor colour;
};
std::array<PhaseTime, 6> phasesOf(const RunTimes& times);

/// Where the time of all threads went (TimeUse), in the order in which it is shown.
std::array<PhaseTime, 5> timesOf(const TimeUse& use);

/// One bar a thread, or a rank where there are ranks: how long it was busy with cells; a line at the mean.
class BusyPlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit BusyPlot(QWidget* parent = nullptr);
  void show(const CellBlock& block);
  /// Before a run: what each thread would have to do.
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

/// One bar for the run, a piece for each phase, or for each use of the threads' time.
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
