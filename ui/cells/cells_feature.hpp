// The cells of parallel blocks: in the view with a legend, in the dock "Load", and their commands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QDockWidget>
#include <QObject>

#include "ui/cells/cell_legend.hpp"
#include "ui/cells/cell_model.hpp"
#include "ui/cells/cell_watch.hpp"
#include "ui/cells/cells_shown.hpp"
#include "ui/cells/load_measurement.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/document/document.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/run/run_places.hpp"
#include "ui/run/run_threads.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/widgets/view_layout.hpp"

namespace footfall::ui {

/// A child of its window, which deletes it before document, runs and view.
class CellsFeature : public QObject {
  Q_OBJECT

 public:
  CellsFeature(const FeatureHost& host, LevelView& view, ViewLayout& layout, Document& document, LevelFile& file,
               RunController& controller, FilterList& filters);
  ~CellsFeature() override;

  void setShown(const CellsShown& shown);
  [[nodiscard]] CellsShown shown() const;
  /// The actions of the tool bar: cells in the view, and the dock.
  [[nodiscard]] QList<QAction*> actions() const { return {cells_, load_}; }

  [[nodiscard]] CellModel& model() { return model_; }
  [[nodiscard]] CellWatch& watch() { return *watch_; }
  [[nodiscard]] CellLegend& legend() { return *legend_; }
  [[nodiscard]] LoadPanel& panel() { return *panel_; }
  [[nodiscard]] LoadMeasurement& measurement() { return measurement_; }
  [[nodiscard]] RunThreads& threads() { return threads_; }
  [[nodiscard]] RunPlaces& places() { return places_; }

 private:
  void addCommands(CommandRegistry& commands);
  void connectParts(const FeatureHost& host, FilterList& filters);
  void preview(int strategy);
  void chooseLegend();
  void askForPlace(RunPlace::Kind kind);
  void describeEmptyState();
  void connectMeasurement(MessageBar& messages);
  void measureAgain(int count);
  void describeObstacle();

  Panels& panels_;
  ViewLayout& layout_;
  Document& document_;
  LevelFile& file_;
  RunController& controller_;
  SessionSections& sections_;
  CellModel model_;
  LoadMeasurement measurement_;
  RunThreads threads_;
  RunPlaces places_;
  CellLegend* legend_;
  LoadPanel* panel_;
  QDockWidget* dock_;
  CellWatch* watch_;
  QAction* cells_ = nullptr;
  QAction* load_ = nullptr;
};

}  // namespace footfall::ui
