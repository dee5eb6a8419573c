// The selected rows of the filter list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>
#include <vector>

namespace footfall::ui {

/// Selects rows as file lists do: one current row, a range from an anchor to it with Shift, single rows with Ctrl. Rows
/// are identified by the ids of their filters.
class FilterSelection {
 public:
  /// Sets the rows in their new order; removed rows are no longer selected. When the current row was removed, the row
  /// in its place becomes current.
  void setRows(const std::vector<int>& ids);
  /// Called when a row is clicked, or gets the focus without a modifier.
  void choose(int id, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  /// Moves up or down by rows, stopping at the ends; with `extend`, selects from the anchor.
  void step(int rows, bool extend);
  void choose(const std::vector<int>& ids);

  [[nodiscard]] bool contains(int id) const;
  /// The selected rows in the order of the list.
  [[nodiscard]] std::vector<int> ids() const;
  /// The current row; -1: none.
  [[nodiscard]] int current() const { return current_; }

 private:
  [[nodiscard]] int indexOf(int id) const;
  void chooseRange(int from, int to);

  std::vector<int> rows_, chosen_;
  int current_ = -1, anchor_ = -1;
};

}  // namespace footfall::ui
