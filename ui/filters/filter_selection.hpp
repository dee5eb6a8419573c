// Which rows of the filter list are selected.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>
#include <vector>

namespace footfall::ui {

/// Selects rows as lists of files do: one current row, a range from an anchor to it with Shift, single rows with Ctrl.
/// Rows are known by the ids of their filters.
class FilterSelection {
 public:
  /// In their new order; what is gone is no longer selected. A current row that is gone hands over to the row that now
  /// stands there.
  void setRows(const std::vector<int>& ids);
  /// A row is clicked, or gets the focus without a modifier.
  void choose(int id, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  /// Up or down by rows, stopping at the ends; with `extend` from the anchor.
  void step(int rows, bool extend);
  void chooseAll();
  void choose(const std::vector<int>& ids);

  [[nodiscard]] bool contains(int id) const;
  /// In the order of the list.
  [[nodiscard]] std::vector<int> ids() const;
  /// -1: none.
  [[nodiscard]] int current() const { return current_; }

 private:
  [[nodiscard]] int indexOf(int id) const;
  void chooseRange(int from, int to);

  std::vector<int> rows_, chosen_;
  int current_ = -1, anchor_ = -1;
};

}  // namespace footfall::ui
