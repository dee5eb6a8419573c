// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/flow_layout.hpp"

#include <QStyle>
#include <algorithm>
#include <utility>

namespace footfall::ui {

FlowLayout::FlowLayout(int spacing, QWidget* parent) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
  setSpacing(spacing);
}

FlowLayout::~FlowLayout() { qDeleteAll(std::exchange(items_, {})); }

void FlowLayout::addItem(QLayoutItem* item) {
  items_ << item;
  invalidate();
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

int FlowLayout::heightForWidth(int width) const { return arrange(QRect(0, 0, width, 0), false); }

QSize FlowLayout::sizeHint() const {
  QSize size;
  for (const QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const int before = size.width() > 0 ? size.width() + spacing() : 0;
    size = {before + item->sizeHint().width(), std::max(size.height(), item->sizeHint().height())};
  }
  return size.grownBy(contentsMargins());
}

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_) size = size.expandedTo(item->minimumSize());
  return size.grownBy(contentsMargins());
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  arrange(area, true);
}

int FlowLayout::arrange(const QRect& area, bool place) const {
  const QRect inner = area.marginsRemoved(contentsMargins());
  QList<QLayoutItem*> line;
  int y = inner.top(), width = 0, height = 0;
  const auto endLine = [&] {
    if (place) placeLine(line, QRect(inner.left(), y, inner.width(), height), height);
    y += height + spacing();
    line.clear();
    width = height = 0;
  };
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint();
    if (!line.isEmpty() && width + spacing() + size.width() > inner.width()) endLine();
    width += size.width() + (line.isEmpty() ? 0 : spacing());
    height = std::max(height, size.height());
    line << item;
  }
  if (!line.isEmpty()) endLine();
  const QMargins margins = contentsMargins();
  return std::max(0, y - spacing() - inner.top()) + margins.top() + margins.bottom();
}

void FlowLayout::placeLine(const QList<QLayoutItem*>& line, const QRect& area, int height) const {
  int used = static_cast<int>(line.size() - 1) * spacing(), growing = 0;
  for (const QLayoutItem* item : line) {
    used += item->sizeHint().width();
    growing += (item->expandingDirections() & Qt::Horizontal) != 0 ? 1 : 0;
  }
  int left = std::max(0, area.width() - used);
  const Qt::LayoutDirection direction = parentWidget() ? parentWidget()->layoutDirection() : Qt::LeftToRight;
  int x = area.left();
  for (QLayoutItem* item : line) {
    int width = std::min(item->sizeHint().width(), area.width());
    if ((item->expandingDirections() & Qt::Horizontal) != 0) {
      width += left / growing;
      left -= left / growing--;
    }
    const int itemHeight = std::min(height, item->sizeHint().height());
    const QRect box(x, area.top() + (height - itemHeight) / 2, width, itemHeight);
    item->setGeometry(QStyle::visualRect(direction, area, box));
    x += width + spacing();
  }
}

}  // namespace footfall::ui
