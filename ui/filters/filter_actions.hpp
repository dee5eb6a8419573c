// What can be done to the selected rows of the filter list: by keys, from the context menu and from the window's menu.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QObject>
#include <functional>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/filters/filter_edits.hpp"
#include "ui/filters/filter_selection.hpp"

namespace footfall::ui {

/// The keys of these actions belong to the list: FilterList hands them to handleKey() while it has the focus, so that
/// other panels may have the same ones.
class FilterActions : public QObject {
  Q_OBJECT

 public:
  FilterActions(Document& document, FilterSelection& selection, QWidget* list);

  struct Entry {
    QString id;  ///< "filters.copy"
    QString help;
    QAction* action;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// Null when there is none.
  [[nodiscard]] QAction* find(const QString& id) const;
  /// Whether the key is one of an action that can be done now; `perform` does it.
  bool handleKey(const QKeyEvent& key, bool perform);
  /// A menu for the row under the mouse, which is selected. The caller deletes it.
  QMenu* makeMenu(QWidget* parent);
  /// Fills `menu` with all filters, strategies behind the others; `use` gets the chosen one. Those that cannot run at
  /// the place `index` of the list are grey and say why.
  void fillFilterMenu(QMenu& menu, std::size_t index, const std::function<void(const FilterDescriptor&)>& use) const;
  /// The place in the list behind the last selected row; the end of the list where none is selected.
  [[nodiscard]] std::size_t placeBehind() const;
  /// After the selection or the filters have changed.
  void update();
  void setMetresPerUnit(double metresPerUnit) { metresPerUnit_ = metresPerUnit; }

 signals:
  /// These rows are to be selected and seen.
  void chosen(const footfall::ui::FilterIds& ids);
  void failed(const QString& message);

 private:
  QAction* add(const char* id, const QString& text, const QString& help, const QKeySequence& keys, const QString& icon,
               void (FilterActions::*perform)());
  void cut();
  void copy();
  void paste();
  void duplicate();
  void remove();
  void selectAll();
  void moveUp() { moveFilters(document_, selection_.ids(), -1); }
  void moveDown() { moveFilters(document_, selection_.ids(), 1); }
  void switchOver();
  void runUpTo();
  void othersOff() { switchOthersOff(document_, selection_.ids()); }
  void allOn() { switchAllOn(document_); }
  void resetValues();
  [[nodiscard]] std::size_t placeOf(int id) const;

  Document& document_;
  FilterSelection& selection_;
  QWidget* list_;
  double metresPerUnit_ = 1;
  std::vector<Entry> entries_;
};

}  // namespace footfall::ui
