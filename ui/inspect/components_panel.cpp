// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/components_panel.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "ui/base/commands/keys_back.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/list_table.hpp"

namespace footfall::ui {

ComponentsPanel::ComponentsPanel(QWidget* parent)
    : QWidget(parent),
      smallerThan_(new QLineEdit(this)),
      error_(new QLabel(this)),
      table_(new QTableView(this)),
      total_(new QLabel(this)),
      frame_(new QLabel(this)),
      copy_(new QPushButton(tr("Copy as text"), this)) {
  setObjectName(QStringLiteral("componentsPanel"));
  smallerThan_->setObjectName(QStringLiteral("componentsSmallerThan"));
  smallerThan_->setPlaceholderText(tr("any area"));
  smallerThan_->setClearButtonEnabled(true);
  giveKeysBackAfterTyping(*smallerThan_);
  selectNumberByDoubleClick(*smallerThan_);
  auto* label = new QLabel(tr("&Smaller than"), this);
  label->setBuddy(smallerThan_);
  error_->setObjectName(QStringLiteral("rowError"));
  error_->setWordWrap(true);
  error_->hide();

  table_->setObjectName(QStringLiteral("componentsTable"));
  table_->setAccessibleName(tr("Components, largest first"));
  table_->setToolTip(tr("Click a component, or press Return on it, to bring it into sight"));
  table_->setModel(&model_);
  prepareList(*table_);
  table_->horizontalHeader()->setStretchLastSection(true);
  setColumnWidths(*table_, {{0, 6}, {1, 11}, {2, 10}, {3, 8}});

  total_->setObjectName(QStringLiteral("componentsTotal"));
  total_->setWordWrap(true);
  total_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  total_->setAccessibleName(tr("Number and area of the components that are shown"));
  setUnits({});
  copy_->setObjectName(QStringLiteral("componentsCopy"));
  copy_->setToolTip(tr("Copy all rows that are shown to the clipboard, with tabs for a spreadsheet"));

  auto* head = new QHBoxLayout;
  head->addWidget(label);
  head->addWidget(smallerThan_, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(total_, 1);
  foot->addWidget(copy_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(head);
  layout->addWidget(error_);
  layout->addWidget(table_, 1);
  layout->addLayout(foot);
  frame_->setObjectName(QStringLiteral("componentsFrame"));
  frame_->setWordWrap(true);
  frame_->setEnabled(false);
  layout->addWidget(frame_);

  connect(smallerThan_, &QLineEdit::textChanged, this, &ComponentsPanel::filter);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (current.isValid()) emit chosen(model_.componentOf(current.row()));
  });
  onRowChosen(*table_, [this](int row) { emit frameRequested(model_.componentOf(row)); });
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(model_.toText()); });
  describe();
}

QSize ComponentsPanel::sizeHint() const {
  return {52 * table_->fontMetrics().horizontalAdvance(QLatin1Char('0')), QWidget::sizeHint().height()};
}

void ComponentsPanel::setInspector(std::shared_ptr<const Inspector> inspector) {
  const QModelIndex current = table_->currentIndex();
  const std::uint32_t rank = current.isValid() ? model_.componentOf(current.row()) : 0;
  model_.setInspector(std::move(inspector));
  if (current.isValid()) choose(rank);
  describe();
}

void ComponentsPanel::setUnits(const LevelUnits& units) {
  units_ = units;
  model_.setUnits(units);
  smallerThan_->setToolTip(tr("Show only components with less area than this, in %1").arg(units.areaName()));
  frame_->setText(units.frameText());
  filter();
}

void ComponentsPanel::choose(std::uint32_t component) {
  const int row = model_.rowOf(component);
  if (row >= 0) table_->setCurrentIndex(model_.index(row, 0));
}

void ComponentsPanel::filter() {
  const QString text = smallerThan_->text().trimmed();
  const std::optional<double> area = parseNumber(text);
  const bool valid = text.isEmpty() || (area && std::isfinite(*area) && *area > 0);
  error_->setVisible(!valid);
  error_->setText(valid ? QString()
                        : tr("\"%1\" is no area; give a number above 0, such as %2").arg(text, numberText(2.5)));
  if (smallerThan_->property("invalid").toBool() == valid) {
    smallerThan_->setProperty("invalid", !valid);
    smallerThan_->style()->unpolish(smallerThan_);
    smallerThan_->style()->polish(smallerThan_);
  }
  if (!valid) return;  // the last valid number applies
  model_.setSmallerThan(area ? std::optional(units_.stored(*area, Unit::Area)) : std::nullopt);
  describe();
}

void ComponentsPanel::describe() {
  const auto& inspector = model_.inspector();
  copy_->setEnabled(model_.rowCount() > 0);
  if (!inspector) {
    total_->setText(tr("No result yet"));
    return;
  }
  const std::uint64_t all = inspector->components().list.size();
  const auto shown = static_cast<std::uint64_t>(model_.rowCount());
  const QString area = units_.area(model_.shownArea());
  total_->setText(shown != all ? (all == 1 ? tr("%1 of 1 component, %2").arg(countText(shown), area)
                                           : tr("%1 of %2 components, %3").arg(countText(shown), countText(all), area))
                  : all == 1   ? tr("1 component, %1").arg(area)
                               : tr("%1 components, %2").arg(countText(all), area));
}

}  // namespace footfall::ui
