// Tables of things in the level; choosing a row shows its place in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>
#include <functional>
#include <utility>

namespace footfall::ui {

/// One row is selected at a time and none is edited; Tab leaves the table. All rows have one height, so that only
/// visible rows are measured.
void prepareList(QTableView& table);

/// Sets the widths of columns in digits: {column, digits}.
void setColumnWidths(QTableView& table, std::initializer_list<std::pair<int, int>> digits);

/// Calls `use` with a row when it is clicked or Return is pressed on it.
void onRowChosen(QTableView& table, const std::function<void(int)>& use);

}  // namespace footfall::ui
