// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/compare_panel.hpp"

#include <QFormLayout>
#include <QHeaderView>
#include <QIcon>
#include <QPixmap>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/widgets/list_table.hpp"

namespace footfall::ui {
namespace {

enum Column { What, Area, Place, kColumns };

constexpr int kLeastLetters = 12;  // width of the choice

QString partText(bool hasArea, double area, const CompareWriter& write) {
  return hasArea ? write.area(area) : ComparePanel::tr("nothing");
}

Vec3 middleOf(const DifferentRegion& region) {
  const Vec3 &a = region.lower, &b = region.upper;
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

QIcon swatchOf(const QColor& colour) {
  QPixmap pixmap(12, 12);
  pixmap.fill(colour);
  return pixmap;
}

}  // namespace

// Lighter and darker than any floor, so that everybody can distinguish them from the colours of layers.
QColor appearedColour() { return {205, 255, 40}; }
QColor wentColour() { return {120, 0, 70}; }

QString appearedText(const SurfaceDifference& difference, const CompareWriter& write) {
  return ComparePanel::tr("Appeared: %1").arg(partText(difference.hasArea[1], difference.areas[1].surface, write));
}

QString wentText(const SurfaceDifference& difference, const CompareWriter& write) {
  return ComparePanel::tr("Disappeared: %1").arg(partText(difference.hasArea[0], difference.areas[0].surface, write));
}

ComparePanel::ComparePanel(QWidget* parent)
    : QWidget(parent),
      choice_(new QComboBox(this)),
      distance_(new QCheckBox(tr("Colour by &distance"), this)),
      summary_(new QLabel(this)),
      table_(new QTableWidget(this)) {
  setObjectName(QStringLiteral("comparePanel"));
  choice_->setObjectName(QStringLiteral("compareChoice"));
  choice_->addItems({tr("Nothing"), tr("The result before the last edit"), tr("A saved result…")});
  // The longest entry, or the name of a file, must not make the panel wider than its dock.
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(kLeastLetters);
  choice_->setToolTip(tr("What the result is compared with, after each run"));
  auto* form = new QFormLayout;
  form->addRow(tr("Compare &with"), choice_);
  distance_->setObjectName(QStringLiteral("compareDistance"));
  distance_->setToolTip(
      tr("Colour the result by the distance of its vertices from the other one: red is zero, blue the largest"));
  summary_->setObjectName(QStringLiteral("compareSummary"));
  summary_->setTextFormat(Qt::PlainText);
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  table_->setObjectName(QStringLiteral("compareTable"));
  table_->setAccessibleName(tr("Regions that differ, largest first"));
  table_->setToolTip(tr("Click a region, or press Return on it, to bring it into sight"));
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels({tr("Region"), tr("Area"), tr("Middle")});
  prepareList(*table_);
  table_->horizontalHeader()->setStretchLastSection(true);
  setColumnWidths(*table_, {{What, 12}, {Area, 11}});
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(distance_);
  layout->addWidget(summary_);
  layout->addWidget(table_, 1);
  connect(choice_, &QComboBox::activated, this, &ComparePanel::chosen);
  connect(distance_, &QCheckBox::toggled, this, &ComparePanel::distanceToggled);
  onRowChosen(*table_, [this](int row) { emit frameRequested(row); });
}

void ComparePanel::setChoice(Choice choice, const QString& file) {
  const QSignalBlocker blocked(choice_);
  choice_->setItemText(SavedResult, file.isEmpty() ? tr("A saved result…") : tr("A saved result: %1").arg(file));
  choice_->setCurrentIndex(choice);
}

void ComparePanel::showNote(const QString& note) {
  summary_->setText(note);
  table_->setRowCount(0);
  setWaiting(false);
}

void ComparePanel::showDifference(const SurfaceDifference& difference, const CompareWriter& write) {
  QStringList lines{appearedText(difference, write), wentText(difference, write)};
  if (difference.empty()) lines = {tr("Both results cover the same area.")};
  const auto count = static_cast<int>(difference.regions.size());
  if (count > kMostRows) lines << tr("The largest %1 of %n regions are listed.", "", count).arg(kMostRows);
  summary_->setText(lines.join(QLatin1Char('\n')));
  table_->setRowCount(0);
  table_->setRowCount(std::min(count, kMostRows));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const DifferentRegion& region = difference.regions[static_cast<std::size_t>(row)];
    const bool appeared = region.mesh == 1;
    auto* what = new QTableWidgetItem(swatchOf(appeared ? appearedColour() : wentColour()),
                                      appeared ? tr("appeared") : tr("disappeared"));
    auto* area = new QTableWidgetItem(write.area(region.area));
    area->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(row, What, what);
    table_->setItem(row, Area, area);
    table_->setItem(row, Place, new QTableWidgetItem(write.place(middleOf(region))));
  }
  setWaiting(false);
}

void ComparePanel::addLine(const QString& line) { summary_->setText(summary() + QLatin1Char('\n') + line); }

void ComparePanel::setWaiting(bool waiting) {
  summary_->setEnabled(!waiting);
  table_->setEnabled(!waiting);
}

}  // namespace footfall::ui
