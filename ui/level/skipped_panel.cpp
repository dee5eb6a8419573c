// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/skipped_panel.hpp"

#include <QHeaderView>
#include <QVBoxLayout>

#include "core/environment/skipped_polygons.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/widgets/list_table.hpp"

namespace footfall::ui {
namespace {

enum Column { Source, Reason, Place, kColumns };

void setCell(QTableWidget* table, int row, Column column, const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(text);
  table->setItem(row, column, item);
}

}  // namespace

SkippedPanel::SkippedPanel(QWidget* parent)
    : QWidget(parent), summary_(new QLabel(this)), table_(new QTableWidget(this)) {
  setObjectName(QStringLiteral("skippedPanel"));
  summary_->setObjectName(QStringLiteral("skippedSummary"));
  summary_->setWordWrap(true);
  table_->setObjectName(QStringLiteral("skippedTable"));
  table_->setAccessibleName(tr("Polygons of the file that were left out"));
  table_->setToolTip(tr("Click a polygon, or press Return on it, to bring its corners into sight"));
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels({tr("In the file"), tr("Why"), tr("Place")});
  prepareList(*table_);
  table_->horizontalHeader()->setStretchLastSection(true);
  setColumnWidths(*table_, {{Source, 12}});
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(summary_);
  layout->addWidget(table_, 1);
  onRowChosen(*table_, [this](int row) { emit frameRequested(row); });
  show({}, {});
}

void SkippedPanel::show(const SkippedElements& skipped, const std::function<QString(const Vec3&)>& place) {
  table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(skipped.listed.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const SkippedPolygon& polygon = skipped.listed[static_cast<std::size_t>(row)];
    setCell(table_, row, Source, coreText(skippedSource(polygon)));
    setCell(table_, row, Reason, coreText(skippedReason(polygon)));
    setCell(table_, row, Place, polygon.corners.empty() ? tr("nowhere") : place(polygon.corners.front()));
  }
  // The reason gets the width, because a click on the row shows its place.
  table_->resizeColumnToContents(Reason);
  QStringList lines{skipped.polygons == 0
                        ? tr("No polygon of the file was left out.")
                        : tr("%n polygons of the file were left out:", "", static_cast<int>(skipped.polygons))};
  if (skipped.polygons > skipped.listed.size())
    lines << tr("The first %n are listed.", "", static_cast<int>(skipped.listed.size()));
  summary_->setText(lines.join(QLatin1Char(' ')));
  table_->setEnabled(table_->rowCount() > 0);
}

}  // namespace footfall::ui
