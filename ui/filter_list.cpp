// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filter_list.hpp"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <algorithm>

namespace footfall {
namespace {

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size())); }

}  // namespace

FilterList::FilterList(Document& document, const RunController& controller, QWidget* parent)
    : QWidget(parent), document_(document), controller_(controller) {
  add_ = new QToolButton(this);
  add_->setObjectName(QStringLiteral("addFilter"));
  add_->setText(tr("+ Add filter"));
  add_->setToolTip(tr("Add a filter at the end of the list"));
  add_->setPopupMode(QToolButton::InstantPopup);
  add_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  fillAddMenu();

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
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 4, 4);
  layout->addWidget(add_);
  layout->addWidget(scroll_, 1);

  connect(&document_, &Document::filtersChanged, this, &FilterList::showFilters);
  connect(&controller_, &RunController::statusChanged, this, &FilterList::showStatuses);
  showFilters();
}

void FilterList::fillAddMenu() {
  auto* menu = new QMenu(add_);
  menu->setToolTipsVisible(true);
  FilterKind kind = FilterKind::Filter;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    if (kind == FilterKind::Filter && filter.kind != kind) menu->addSection(tr("Parallel blocks"));
    kind = filter.kind;
    QAction* action = menu->addAction(text(filter.label));
    action->setToolTip(text(filter.help));
    action->setData(text(filter.name));
    connect(action, &QAction::triggered, this, [this, &filter] {
      document_.addFilter(filter, metresPerUnit_);
      QMetaObject::invokeMethod(
          this, [this] { scroll_->verticalScrollBar()->setValue(scroll_->verticalScrollBar()->maximum()); },
          Qt::QueuedConnection);
    });
  }
  add_->setMenu(menu);
}

FilterRow* FilterList::makeRow(const FilterEntry& entry) {
  auto* row = new FilterRow(entry, content_);
  connect(row, &FilterRow::enabledEdited, &document_, &Document::setEnabled);
  connect(row, &FilterRow::valueEdited, &document_, &Document::setValue);
  connect(row, &FilterRow::previewRequested, this, &FilterList::previewRequested);
  // Later: the row that sends this goes with it.
  connect(row, &FilterRow::removeRequested, &document_, &Document::removeFilter, Qt::QueuedConnection);
  row->handle()->installEventFilter(this);
  row->installEventFilter(this);
  for (QWidget* child : row->findChildren<QWidget*>()) child->installEventFilter(this);
  row->show();
  return row;
}

void FilterList::showFilters() {
  if (dragged_) endDrag(false);
  std::vector<FilterRow*> next;
  for (const FilterEntry& entry : document_.filters()) {
    const auto known =
        std::find_if(rows_.begin(), rows_.end(), [&](const FilterRow* row) { return row->entryId() == entry.id; });
    if (known == rows_.end()) {
      next.push_back(makeRow(entry));
    } else {
      (*known)->setEntry(entry);
      next.push_back(*known);
    }
  }
  for (FilterRow* row : rows_) {
    if (std::find(next.begin(), next.end(), row) != next.end()) continue;
    row->hide();
    row->deleteLater();
  }
  if (next != rows_) {
    for (FilterRow* row : rows_) layout_->removeWidget(row);
    rows_ = std::move(next);
    for (std::size_t i = 0; i < rows_.size(); ++i) layout_->insertWidget(static_cast<int>(i), rows_[i]);
    QWidget* before = add_;
    for (FilterRow* row : rows_) {
      for (QWidget* field : row->findChildren<QWidget*>()) {
        if (field->focusPolicy() == Qt::NoFocus) continue;
        setTabOrder(before, field);
        before = field;
      }
    }
  }
  bool inBlock = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const PipelineStep& step = document_.filters()[i].step;
    const FilterKind kind = step.enabled ? step.filter->kind : FilterKind::Filter;
    inBlock = inBlock || kind == FilterKind::Strategy;
    rows_[i]->setInBlock(inBlock);
    if (kind == FilterKind::Collapse) inBlock = false;
  }
  empty_->setVisible(rows_.empty());
  showStatuses();
}

void FilterList::showStatuses() {
  for (FilterRow* row : rows_) row->setStatus(controller_.status(row->entryId()));
  giveRowsTheirHeight();
}

void FilterList::giveRowsTheirHeight() {
  for (FilterRow* row : rows_) row->layout()->activate();
  layout_->invalidate();
  const int width = scroll_->viewport()->width();
  content_->setMinimumHeight(layout_->hasHeightForWidth() ? layout_->heightForWidth(width)
                                                          : layout_->sizeHint().height());
}

void FilterList::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  giveRowsTheirHeight();
}

bool FilterList::eventFilter(QObject* watched, QEvent* event) {
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const FilterRow* r) {
    return r == watched || r->isAncestorOf(qobject_cast<QWidget*>(watched));
  });
  if (row == rows_.end()) return QWidget::eventFilter(watched, event);
  const bool onHandle = watched == (*row)->handle();
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      if (onHandle && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
        beginDrag(*row);
        return true;
      }
      break;
    case QEvent::MouseMove:
      if (onHandle && dragged_) {
        moveDrag(static_cast<QMouseEvent*>(event)->globalPosition().toPoint());
        return true;
      }
      break;
    case QEvent::MouseButtonRelease:
      if (onHandle && dragged_) {
        endDrag(true);
        return true;
      }
      break;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: {
      auto* key = static_cast<QKeyEvent*>(event);
      if (dragged_ && key->key() == Qt::Key_Escape) {
        if (event->type() == QEvent::KeyPress) endDrag(false);
        event->accept();
        return true;
      }
      const int direction = key->key() == Qt::Key_Up ? -1 : key->key() == Qt::Key_Down ? 1 : 0;
      if (direction != 0 && key->modifiers() == Qt::AltModifier) {
        event->accept();
        return event->type() == QEvent::ShortcutOverride || moveByKey(*row, direction);
      }
      break;
    }
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

bool FilterList::moveByKey(FilterRow* row, int direction) {
  const auto index = std::find(rows_.begin(), rows_.end(), row) - rows_.begin();
  const auto target = index + direction;
  if (target >= 0 && target < static_cast<std::ptrdiff_t>(rows_.size())) {
    document_.moveFilter(row->entryId(), static_cast<std::size_t>(target));
  }
  return true;
}

void FilterList::beginDrag(FilterRow* row) {
  dragged_ = row;
  dropGap_ = static_cast<std::size_t>(std::find(rows_.begin(), rows_.end(), row) - rows_.begin());
  row->handle()->setCursor(Qt::ClosedHandCursor);
  row->setProperty("dragged", true);
  row->style()->unpolish(row);
  row->style()->polish(row);
}

std::size_t FilterList::gapAt(int y) const {
  std::size_t gap = 0;
  while (gap < rows_.size() && y > rows_[gap]->geometry().center().y()) ++gap;
  return gap;
}

void FilterList::moveDrag(const QPoint& globalPosition) {
  const QPoint inScroll = scroll_->viewport()->mapFromGlobal(globalPosition);
  QScrollBar* bar = scroll_->verticalScrollBar();
  if (inScroll.y() < 16) bar->setValue(bar->value() - 12);
  if (inScroll.y() > scroll_->viewport()->height() - 16) bar->setValue(bar->value() + 12);

  dropGap_ = gapAt(content_->mapFromGlobal(globalPosition).y());
  const int y = dropGap_ < rows_.size() ? rows_[dropGap_]->geometry().top() - 4 : rows_.back()->geometry().bottom() + 2;
  dropLine_->setGeometry(0, std::max(0, y), content_->width(), 3);
  dropLine_->raise();
  dropLine_->show();
}

void FilterList::endDrag(bool drop) {
  FilterRow* row = dragged_;
  dragged_ = nullptr;
  dropLine_->hide();
  row->handle()->setCursor(Qt::OpenHandCursor);
  row->setProperty("dragged", false);
  row->style()->unpolish(row);
  row->style()->polish(row);
  if (!drop) return;
  const auto from = static_cast<std::size_t>(std::find(rows_.begin(), rows_.end(), row) - rows_.begin());
  // Without the row itself, the gaps behind it are one less.
  const std::size_t to = dropGap_ > from ? dropGap_ - 1 : dropGap_;
  if (to != from) document_.moveFilter(row->entryId(), to);
}

}  // namespace footfall
