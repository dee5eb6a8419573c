// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/list_table.hpp"

#include <QHeaderView>

namespace footfall::ui {

void prepareList(QTableView& table) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
  table.setWordWrap(false);
  table.setAlternatingRowColors(true);
  table.verticalHeader()->hide();
  table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 8);
  table.horizontalHeader()->setHighlightSections(false);
}

void setColumnWidths(QTableView& table, std::initializer_list<std::pair<int, int>> digits) {
  const int unit = table.fontMetrics().horizontalAdvance(QLatin1Char('0'));
  for (const auto& [column, count] : digits) table.setColumnWidth(column, count * unit);
}

void onRowChosen(QTableView& table, const std::function<void(int)>& use) {
  const auto useRow = [use](const QModelIndex& index) { use(index.row()); };
  QObject::connect(&table, &QTableView::clicked, &table, useRow);
  QObject::connect(&table, &QTableView::activated, &table, useRow);
}

}  // namespace footfall::ui
