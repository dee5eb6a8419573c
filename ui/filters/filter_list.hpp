// The pipeline as a list of rows that users add, select, drag and edit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <vector>

#include "ui/filters/filter_actions.hpp"
#include "ui/filters/filter_row.hpp"
#include "ui/filters/filter_selection.hpp"
#include "ui/filters/presets_menu.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/run/time_strip.hpp"

namespace footfall::ui {

/// Shows a document's filters with the states of a controller's steps; edits go to the document. Up and Down move
/// between rows (Shift extends the selection), Home and End move to the ends; FilterActions has the other keys. A
/// focused field handles its own keys, except Alt with Up and Down.
class FilterList : public QWidget {
  Q_OBJECT

 public:
  FilterList(Document& document, RunController& controller, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<FilterRow*>& rows() const { return rows_; }
  [[nodiscard]] QToolButton* addButton() const { return add_; }
  [[nodiscard]] PresetsMenu* presets() const { return presets_; }
  [[nodiscard]] QCheckBox* automaticBox() const { return automatic_; }
  [[nodiscard]] const TimeStrip& timeStrip() const { return *times_; }
  [[nodiscard]] FilterActions& actions() const { return *actions_; }
  [[nodiscard]] const FilterSelection& selection() const { return selection_; }
  /// Selects rows, focuses the last of them and scrolls it into view.
  void choose(const FilterIds& ids);
  /// New filters get their defaults in this scale.
  void setUnits(const LevelUnits& units);
  /// Sets the row whose seeds are being placed in the view; -1: none.
  void setPlacing(int id);

 signals:
  void selectionChanged();
  /// Emitted when the user begins or ends placing the seeds of a row.
  void placingRequested(int id, bool on);
  /// Emitted when the mouse enters or leaves a value of a filter.
  void parameterPointed(int id, std::size_t parameter, bool on);
  /// Emitted when the user chooses to see the cells of a strategy.
  void previewRequested(int id);
  void failed(const QString& message);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void createHead(QVBoxLayout* layout);
  void showFilters();
  void placeRows(std::vector<FilterRow*> rows);
  void showStatuses();
  void showSelection();
  void openCurrent();
  void fillAddMenu(QMenu& menu);
  /// Gives rows the height of their wrapped notes, which is more than their minimum; the scroll area must not compress
  /// rows.
  void giveRowsTheirHeight();
  FilterRow* makeRow(const FilterEntry& entry);
  [[nodiscard]] FilterRow* rowOf(const QObject* widget) const;
  [[nodiscard]] FilterRow* rowOf(int id) const;
  bool handlePress(FilterRow* row, const QObject* watched, const QMouseEvent& event);
  bool handleKey(FilterRow* row, const QObject* watched, QKeyEvent& key, bool perform);
  [[nodiscard]] bool typing() const;
  void focusCurrent();
  bool handleMove(const QMouseEvent& event);
  bool handleRelease();
  void beginDrag(FilterRow* row);
  void moveDrag(const QPoint& globalPosition);
  void endDrag(bool drop);
  /// The gap between rows nearest to a height: 0 before the first row.
  [[nodiscard]] std::size_t gapAt(int y) const;

  Document& document_;
  RunController& controller_;
  LevelUnits units_;
  FilterSelection selection_;
  FilterActions* actions_;
  QToolButton* add_;
  PresetsMenu* presets_;
  QCheckBox* automatic_;
  TimeStrip* times_;
  QScrollArea* scroll_;
  QWidget* content_;
  QVBoxLayout* layout_;
  QFrame* dropLine_;
  QLabel* empty_;
  std::vector<FilterRow*> rows_;
  int placing_ = -1;
  FilterRow* pressed_ = nullptr;  ///< row pressed where it can be dragged
  QPoint pressedAt_;
  bool keepsSelection_ = false;  ///< the press may begin a drag of several rows
  FilterRow* dragged_ = nullptr;
  std::size_t dropGap_ = 0;
  bool choosing_ = false;  // the focus follows the selection and must not change it
};

}  // namespace footfall::ui
