// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/time_strip.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "ui/view/cells/cell_colours.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr int kBarHeight = 8;
constexpr int kGap = 3;  // between the text and the bar

QColor trough(const QPalette& palette) {
  QColor colour = palette.color(QPalette::WindowText);
  colour.setAlphaF(0.12F);
  return colour;
}

// The filters that take most, as many as fit: the tool tip lists all.
QString shownText(const QString& text, const QFontMetrics& metrics, int width) {
  QStringList parts = text.split(QLatin1String(", "));
  const QString more = QStringLiteral("…");
  while (parts.size() > 1 && metrics.horizontalAdvance(parts.join(QLatin1String(", "))) > width) {
    if (parts.last() == more) parts.removeLast();
    if (parts.size() > 1) parts.last() = more;
  }
  return metrics.elidedText(parts.join(QLatin1String(", ")), Qt::ElideRight, width);
}

}  // namespace

QColor timeColour(std::size_t index) { return layerPaint(static_cast<std::uint32_t>(index)).colour; }

ShareBar::ShareBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("shareBar"));
  setFixedHeight(4);
  hide();
}

void ShareBar::setShare(std::optional<double> share, const QColor& colour) {
  if (share == share_ && colour == colour_) return;
  share_ = share;
  colour_ = colour;
  setToolTip(share ? tr("%1 % of the time of all filters").arg(std::lround(*share * 100)) : QString());
  setVisible(share.has_value());
  update();
}

void ShareBar::paintEvent(QPaintEvent*) {
  if (!share_) return;
  QPainter painter(this);
  painter.fillRect(rect(), trough(palette()));
  // A step with any time has a visible bar.
  painter.fillRect(QRectF(0, 0, std::max(1.0, width() * *share_), height()), colour_);
}

TimeStrip::TimeStrip(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("timeStrip"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  hide();
}

void TimeStrip::setShares(const TimeShares& shares) {
  shares_ = shares;
  text_ = timeSummary(shares);
  setVisible(!text_.isEmpty());
  setAccessibleName(tr("Time of the filters"));
  setAccessibleDescription(text_);
  update();
}

QSize TimeStrip::sizeHint() const { return {200, fontMetrics().height() + kGap + kBarHeight}; }
QSize TimeStrip::minimumSizeHint() const { return {80, sizeHint().height()}; }

QRect TimeStrip::barRect() const { return {0, height() - kBarHeight, width(), kBarHeight}; }

bool TimeStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString tip = tr("<p>What a run without the cache takes: each filter when it was last computed.</p>");
  for (const TimeShare& step : shares_.steps) {
    tip += QStringLiteral("%1: %2 (%3 %)<br>")
               .arg(step.label.toHtmlEscaped(), durationText(step.ms))
               .arg(std::lround(step.share * 100));
  }
  QToolTip::showText(help->globalPos(), tip, this);
  return true;
}

void TimeStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRect words(0, 0, width(), fontMetrics().height());
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, shownText(text_, fontMetrics(), width()));
  const QRect bar = barRect();
  painter.fillRect(bar, trough(palette()));
  double x = 0;
  for (std::size_t i = 0; i < shares_.steps.size(); ++i) {
    const double wide = shares_.steps[i].share * bar.width();
    painter.fillRect(QRectF(x, bar.top(), std::max(0.0, wide - 1), bar.height()), timeColour(i));
    x += wide;
  }
}

}  // namespace footfall::ui
