// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_list.hpp"

#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "footfall/filter.hpp"
#include "ui/base/widgets/flow_layout.hpp"
#include "ui/document/edit_text.hpp"
#include "ui/filters/filter_places.hpp"
#include "ui/filters/seed_edits.hpp"

namespace footfall::ui {

FilterList::FilterList(Document& document, RunController& controller, QWidget* parent)
    : QWidget(parent), document_(document), controller_(controller) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 4, 4);
  createHead(layout);

  content_ = new QWidget;
  content_->setObjectName(QStringLiteral("filterListContent"));
  layout_ = new QVBoxLayout(content_);
  layout_->setContentsMargins(0, 2, 2, 2);
  layout_->setSpacing(5);
  empty_ = new QLabel(tr("No filters: everything that faces up is walkable. Add one above."), content_);
  empty_->setWordWrap(true);
  layout_->addWidget(empty_);
  layout_->addStretch(1);
  dropLine_ = new QFrame(content_);
  dropLine_->setObjectName(QStringLiteral("dropLine"));
  dropLine_->hide();

  scroll_ = new QScrollArea(this);
  scroll_->setWidget(content_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  layout->addWidget(scroll_, 1);

  connect(&document_, &Document::filtersChanged, this, &FilterList::showFilters);
  connect(&controller_, &RunController::statusChanged, this, &FilterList::showStatuses);
  connect(actions_, &FilterActions::chosen, this, &FilterList::choose);
  connect(actions_, &FilterActions::failed, this, &FilterList::failed);
  connect(presets_, &PresetsMenu::failed, this, &FilterList::failed);
  showFilters();
}

void FilterList::createHead(QVBoxLayout* layout) {
  actions_ = new FilterActions(document_, selection_, this);
  const auto button = [this](const QString& name, const QString& text, const QString& help, QMenu* menu) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(help);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setMenu(menu);
    return button;
  };
  auto* menu = new QMenu(this);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillAddMenu(*menu); });
  add_ = button(QStringLiteral("addFilter"), tr("+ Add filter"),
                tr("Add a filter behind the selected one, or at the end of the list"), menu);
  presets_ = new PresetsMenu(document_, PresetStore::ofUser(), this);
  auto* presets =
      button(QStringLiteral("presets"), tr("Presets"), tr("Load a saved pipeline, or save this one"), presets_);
  automatic_ = new QCheckBox(tr("Run automatically"), this);
  automatic_->setObjectName(QStringLiteral("runAutomatically"));
  automatic_->setToolTip(
      tr("On: every edit starts a run; if runs take long, the run starts when you pause. Off: press F5 to run."));
  automatic_->setChecked(controller_.automatic());
  connect(automatic_, &QCheckBox::toggled, &controller_, &RunController::setAutomatic);
  connect(&controller_, &RunController::automaticChanged, automatic_, &QCheckBox::setChecked);
  times_ = new TimeStrip(this);
  auto* buttons = new FlowLayout(6);
  for (QWidget* each : {static_cast<QWidget*>(add_), static_cast<QWidget*>(presets), static_cast<QWidget*>(automatic_)})
    buttons->addWidget(each);
  layout->addLayout(buttons);
  layout->addWidget(times_);
}

void FilterList::fillAddMenu(QMenu& menu) {
  menu.clear();
  const std::size_t index = actions_->placeBehind();
  const auto& filters = document_.filters();
  menu.addSection(index < filters.size() ? tr("Behind %1").arg(labelOf(filters[index - 1].step))
                                         : tr("At the end of the list"));
  actions_->fillFilterMenu(menu, index, [this, index](const FilterDescriptor& filter) {
    choose(addFilterAt(document_, index, filter, units_.metresPerUnit, tr("Add %1")));
  });
}

void FilterList::setUnits(const LevelUnits& units) {
  units_ = units;
  actions_->setMetresPerUnit(units.metresPerUnit);
  presets_->setMetresPerUnit(units.metresPerUnit);
  for (FilterRow* row : rows_) row->setUnits(units);
}

FilterRow* FilterList::makeRow(const FilterEntry& entry) {
  auto* row = new FilterRow(entry, content_);
  row->setUnits(units_);
  connect(row, &FilterRow::enabledEdited, &document_, &Document::setEnabled);
  connect(row, &FilterRow::valueEdited, &document_, &Document::setValue);
  connect(row, &FilterRow::previewRequested, this, &FilterList::previewRequested);
  connect(row, &FilterRow::placingRequested, this, &FilterList::placingRequested);
  connect(row, &FilterRow::parameterPointed, this, &FilterList::parameterPointed);
  connect(
      row, &FilterRow::clearanceRequested, this,
      [this](int id) { provideClearance(document_, id, units_.metresPerUnit); }, Qt::QueuedConnection);
  connect(
      row, &FilterRow::groupRemoved, this, [this](int id, std::size_t seed) { removeSeed(document_, id, seed); },
      Qt::QueuedConnection);
  if (row->placeButton()) row->placeButton()->setChecked(placing_ == entry.id);
  connect(row, &FilterRow::draggingChanged, &controller_, &RunController::setDragging);
  // The row is removed later, because it is the sender.
  connect(row, &FilterRow::removeRequested, &document_, &Document::removeFilter, Qt::QueuedConnection);
  row->installEventFilter(this);
  for (QWidget* child : row->findChildren<QWidget*>()) child->installEventFilter(this);
  row->show();
  return row;
}

void FilterList::showFilters() {
  if (dragged_) endDrag(false);
  pressed_ = nullptr;
  std::vector<FilterRow*> next;
  std::vector<int> ids;
  for (const FilterEntry& entry : document_.filters()) {
    FilterRow* known = rowOf(entry.id);
    if (known && !known->fits(entry)) known = nullptr;
    if (known) known->setEntry(entry);
    next.push_back(known ? known : makeRow(entry));
    ids.push_back(entry.id);
  }
  const bool hadFocus = rowOf(focusWidget()) != nullptr;
  if (next != rows_) placeRows(std::move(next));
  bool inBlock = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const PipelineStep& step = document_.filters()[i].step;
    const FilterKind kind = step.enabled ? step.filter->kind : FilterKind::Filter;
    inBlock = inBlock || kind == FilterKind::Strategy;
    rows_[i]->setInBlock(inBlock);
    if (kind == FilterKind::Collapse) inBlock = false;
  }
  empty_->setVisible(rows_.empty());
  selection_.setRows(ids);
  showSelection();
  showStatuses();
  if (hadFocus && !rowOf(focusWidget())) focusCurrent();  // the focused row was removed
}

void FilterList::placeRows(std::vector<FilterRow*> rows) {
  for (FilterRow* row : rows_) {
    if (std::ranges::find(rows, row) != rows.end()) continue;
    row->hide();
    row->deleteLater();
  }
  for (FilterRow* row : rows_) layout_->removeWidget(row);
  rows_ = std::move(rows);
  for (std::size_t i = 0; i < rows_.size(); ++i) layout_->insertWidget(static_cast<int>(i), rows_[i]);
  QWidget* before = automatic_;
  const auto follow = [&before](QWidget* widget) {
    if (widget->focusPolicy() == Qt::NoFocus) return;
    setTabOrder(before, widget);
    before = widget;
  };
  for (FilterRow* row : rows_) {
    follow(row);
    for (QWidget* field : row->findChildren<QWidget*>()) follow(field);
  }
}

void FilterList::showStatuses() {
  const TimeShares shares = timeShares(document_.filters(), [this](int id) { return controller_.status(id); });
  times_->setShares(shares);
  for (FilterRow* row : rows_) {
    const StepStatus status = controller_.status(row->entryId());
    row->setStatus(status);
    if (status.state == StepState::Skipped) row->setClearanceOff(hasClearanceOff(document_, row->entryId()));
    const TimeShare* share = shareOf(shares, row->entryId());
    row->setShare(share ? std::optional(share->share) : std::nullopt,
                  share ? timeColour(static_cast<std::size_t>(share - shares.steps.data())) : QColor());
  }
  giveRowsTheirHeight();
}

void FilterList::showSelection() {
  for (FilterRow* row : rows_) row->setSelected(selection_.contains(row->entryId()));
  if (!pressed_) openCurrent();
  actions_->update();
  emit selectionChanged();
}

// Rows do not move while the mouse holds one.
void FilterList::openCurrent() {
  for (FilterRow* row : rows_) row->setOpen(row->entryId() == selection_.current());
  giveRowsTheirHeight();
}

void FilterList::setPlacing(int id) {
  placing_ = id;
  for (FilterRow* row : rows_)
    if (row->placeButton()) row->placeButton()->setChecked(row->entryId() == id);
}

void FilterList::giveRowsTheirHeight() {
  for (FilterRow* row : rows_) row->layout()->activate();
  layout_->invalidate();
  const int width = std::max(scroll_->viewport()->width(), layout_->minimumSize().width());
  content_->setMinimumHeight(layout_->hasHeightForWidth() ? layout_->heightForWidth(width)
                                                          : layout_->sizeHint().height());
}

void FilterList::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  giveRowsTheirHeight();
}

FilterRow* FilterList::rowOf(int id) const {
  const auto found = std::ranges::find(rows_, id, &FilterRow::entryId);
  return found == rows_.end() ? nullptr : *found;
}

FilterRow* FilterList::rowOf(const QObject* widget) const {
  for (const QObject* at = widget; at; at = at->parent()) {
    const auto found = std::ranges::find_if(rows_, [at](const FilterRow* row) { return row == at; });
    if (found != rows_.end()) return *found;
  }
  return nullptr;
}

}  // namespace footfall::ui
