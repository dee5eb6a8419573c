// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/fitted_labels.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace footfall::ui {
namespace {

constexpr int kLeastLetters = 6;  // in an elided text

int leastWidth(const QWidget& widget) { return kLeastLetters * widget.fontMetrics().averageCharWidth(); }

// Calls visit(layout) for each paragraph of the text, laid out in lines of `width`; returns the total height.
template <typename Visit>
double layOut(const QString& text, const QFont& font, int width, Visit visit) {
  double height = 0;
  for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
    QTextLayout layout(paragraph, font);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(std::max(1, width));
      line.setPosition({0, height});
      height += line.height();
    }
    layout.endLayout();
    visit(layout);
  }
  return height;
}

}  // namespace

QSize ElidedLabel::minimumSizeHint() const {
  const QSize whole = QLabel::minimumSizeHint();
  const QMargins margins = contentsMargins();
  return {std::min(whole.width(), leastWidth(*this) + margins.left() + margins.right()), whole.height()};
}

bool ElidedLabel::event(QEvent* event) {
  const bool cut = fontMetrics().horizontalAdvance(text()) > contentsRect().width();
  if (event->type() == QEvent::ToolTip && toolTip().isEmpty() && cut) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
    return true;
  }
  return QLabel::event(event);
}

void ElidedLabel::paintEvent(QPaintEvent* event) {
  Q_UNUSED(event);
  QPainter painter(this);
  drawFrame(&painter);
  const QRect box = contentsRect();
  const QString shown = fontMetrics().elidedText(text(), Qt::ElideMiddle, box.width());
  style()->drawItemText(&painter, box, static_cast<int>(alignment() | Qt::TextSingleLine), palette(), isEnabled(),
                        shown, foregroundRole());
}

WrappedLabel::WrappedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
}

QSize WrappedLabel::minimumSizeHint() const {
  const QMargins margins = contentsMargins();
  return {leastWidth(*this) + margins.left() + margins.right(), fontMetrics().height()};
}

int WrappedLabel::heightForWidth(int width) const {
  const QMargins margins = contentsMargins();
  const int inner = width - margins.left() - margins.right();
  const double height = layOut(text(), font(), inner, [](const QTextLayout&) {});
  return static_cast<int>(std::ceil(height)) + margins.top() + margins.bottom();
}

void WrappedLabel::paintEvent(QPaintEvent* event) {
  Q_UNUSED(event);
  QPainter painter(this);
  drawFrame(&painter);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, foregroundRole()));
  const QRect box = contentsRect();
  QPointF top = box.topLeft();
  if ((alignment() & Qt::AlignVCenter) != 0)
    top.ry() += std::max(0.0, (box.height() - layOut(text(), font(), box.width(), [](const QTextLayout&) {})) / 2);
  layOut(text(), font(), box.width(), [&](const QTextLayout& layout) { layout.draw(&painter, top); });
}

}  // namespace footfall::ui
