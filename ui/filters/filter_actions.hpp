// The actions on the selected rows of the filter list: by keys, from the context menu and from the window's menu.
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

/// The keys of these actions work in the list only: FilterList passes them to handleKey() while it has the focus, so
/// that other panels may use the same keys.
class FilterActions : public QObject {
  Q_OBJECT

 public:
  FilterActions(Document& document, FilterSelection& selection, QWidget* list);

  struct Entry {
    QString id;  ///< such as "filters.copy"
    QString help;
    QAction* action;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// The action with this id; null when there is none.
  [[nodiscard]] QAction* find(const QString& id) const;
  /// Returns whether the key belongs to an enabled action; with `perform`, triggers it.
  bool handleKey(const QKeyEvent& key, bool perform);
  /// Selects the row under the mouse and makes its menu. The caller deletes the menu.
  QMenu* makeMenu(QWidget* parent);
  /// Fills `menu` with all filters, strategies last; `use` receives the chosen one. Filters that cannot run at the
  /// place `index` of the list are disabled, with the reason.
  void fillFilterMenu(QMenu& menu, std::size_t index, const std::function<void(const FilterDescriptor&)>& use) const;
  /// The place in the list behind the last selected row; the end of the list where none is selected.
  [[nodiscard]] std::size_t placeBehind() const;
  /// Called after the selection or the filters have changed.
  void update();
  void setMetresPerUnit(double metresPerUnit) { metresPerUnit_ = metresPerUnit; }

 signals:
  /// Emitted with rows that should be selected and made visible.
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
