// The dock "Load": how a run's work was distributed over cells and threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>

#include "ui/cells/balance_plot.hpp"
#include "ui/cells/cell_model.hpp"
#include "ui/cells/histogram_plot.hpp"
#include "ui/cells/measure_page.hpp"
#include "ui/cells/timeline_plot.hpp"
#include "ui/run/run_places.hpp"

namespace footfall::ui {

class LoadPanel : public QWidget {
  Q_OBJECT

 public:
  LoadPanel(CellModel& model, RunThreads& threads, RunPlaces& places, LoadMeasurement& measurement,
            QWidget* parent = nullptr);

  /// Sets the text that is shown without cells, and whether a button offers to add a block.
  void setPipeline(bool hasEnvironment, bool hasBlock);

  [[nodiscard]] TimelinePlot& timeline() const { return *timeline_; }
  [[nodiscard]] BusyPlot& busyPlot() const { return *busy_; }
  [[nodiscard]] PhasePlot& phasePlot() const { return *phases_; }
  [[nodiscard]] PhasePlot& usePlot() const { return *use_; }
  [[nodiscard]] HistogramPlot& histogram() const { return *histogram_; }
  [[nodiscard]] MeasurePage& measurePage() const { return *measure_; }
  /// The pages Threads, Cells, Phases and Measure.
  [[nodiscard]] QTabWidget& pages() const { return *pages_; }
  /// The button that adds a block; null where none is offered.
  [[nodiscard]] QPushButton* parallelButton() const { return parallel_; }
  [[nodiscard]] bool showsEmptyState() const { return stack_->currentIndex() == 0; }
  [[nodiscard]] QString emptyText() const { return emptyText_->text(); }
  [[nodiscard]] QString strategyText() const { return strategy_->text(); }
  [[nodiscard]] QString figuresText() const { return figures_->text(); }

 signals:
  void parallelBlockRequested();
  /// Emitted when the user has chosen a place to run; a dialog then requests its other settings.
  void placeRequested(footfall::detail::RunPlace::Kind kind);
  /// Emitted to leave a preview and show the cells of the run again.
  void runRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// A text, and its form where there is little room.
  struct Words {
    QString whole, brief;
  };
  void makeThreadBox(RunThreads& threads);
  void makePlaceBox(RunPlaces& places);
  QWidget* makeEmptyPage();
  QWidget* makeContentPage();
  QWidget* makeFigures();
  void refresh();
  void showPage(int page);
  void showFigures(const CellBlock& block);
  void showPhases(const CellBlock& block);
  void showTimeUse(const CellBlock& block);
  void showFilters();
  void fitTexts();

  CellModel& model_;
  QStackedWidget* stack_;
  QLabel* emptyText_;
  QPushButton* parallel_;
  QLabel* strategy_;
  Words head_, key_;  ///< texts of strategy_ and filters_
  QPushButton* back_;
  QComboBox* threadBox_;
  QComboBox* placeBox_;
  QComboBox* block_;
  TimelinePlot* timeline_;
  QLabel* filters_;
  QLabel* figures_;
  BusyPlot* busy_;
  PhasePlot* phases_;
  QLabel* phaseTexts_;
  QTabWidget* pages_;
  PhasePlot* use_;
  QLabel* useTexts_;
  HistogramPlot* histogram_;
  QLabel* histogramText_;
  MeasurePage* measure_;
};

}  // namespace footfall::ui
