// Tables that list things of the level: a row leads to its place in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>
#include <functional>
#include <utility>

namespace footfall::ui {

/// One row is selected at a time and none is edited; Tab leaves the table. Rows are of one height: nothing is measured
/// but what is seen.
void prepareList(QTableView& table);

/// Columns as wide as so many digits: {column, digits}.
void setColumnWidths(QTableView& table, std::initializer_list<std::pair<int, int>> digits);

/// Calls `use` with a row that is clicked, or that Return is pressed on.
void onRowChosen(QTableView& table, const std::function<void(int)>& use);

}  // namespace footfall::ui
