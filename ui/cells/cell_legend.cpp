// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/cell_legend.hpp"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr int kWidth = 196;  // width of the swatches, and minimum width of the texts
constexpr int kThreadsInRow = 8;
constexpr int kSwatchHeight = 18;
constexpr int kThreadsListed = 8;

// Numbered squares, one for each thread.
QPixmap threadSwatches(int threads, const QFont& font, qreal ratio) {
  constexpr int kRows = 4;  // the first threads of a machine with many stand for the rest
  const int shown = std::min(threads, kThreadsInRow * kRows);
  const int rows = (shown + kThreadsInRow - 1) / kThreadsInRow;
  const int side = kWidth / kThreadsInRow;
  QPixmap pixmap(QSize(kWidth, rows * (kSwatchHeight + 2)) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  QFont small = font;
  small.setPixelSize(11);
  painter.setFont(small);
  for (int i = 0; i < shown; ++i) {
    const QColor colour = threadColour(i);
    const QRect box(i % kThreadsInRow * side, i / kThreadsInRow * (kSwatchHeight + 2), side - 2, kSwatchHeight);
    painter.fillRect(box, colour);
    painter.setPen(colour.lightnessF() > 0.45F ? Qt::black : Qt::white);
    painter.drawText(box, Qt::AlignCenter, QString::number(i));
  }
  return pixmap;
}

QPixmap scaleSwatch(qreal ratio) {
  QPixmap pixmap(QSize(kWidth, 14) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  QPainter painter(&pixmap);
  for (int x = 0; x < kWidth; ++x) {
    painter.fillRect(QRectF(x, 0, 1, 14), scaleColour(static_cast<double>(x) / (kWidth - 1)));
  }
  return pixmap;
}

QPixmap unfinishedSwatch(qreal ratio) {
  return paintSwatch({unfinishedColour(), FillPattern::RisingStripes}, QSize(30, 14), ratio);
}

}  // namespace

CellLegend::CellLegend(CellModel& model, QWidget* parent)
    : OverlayFrame(tr("Cells"), QStringLiteral("cellLegend"), parent), model_(model) {
  setObjectName(QStringLiteral("legend"));
  title_ = new QLabel(this);
  title_->setStyleSheet(QStringLiteral("font-weight: 600"));
  title_->setWordWrap(true);
  colouring_ = new QComboBox(this);
  colouring_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus in the view
  colouring_->setAccessibleName(tr("Colour cells by"));
  colouring_->setToolTip(tr("What the colours of the cells show"));
  for (const CellColouring colouring : kCellColourings) colouring_->addItem(tr("Colours: %1").arg(labelOf(colouring)));
  colours_ = new QLabel(this);
  text_ = new QLabel(this);
  text_->setWordWrap(true);
  auto* rest = new QWidget(this);
  auto* restLayout = new QHBoxLayout(rest);
  restLayout->setContentsMargins(0, 0, 0, 0);
  auto* swatch = new QLabel(rest);
  swatch->setPixmap(unfinishedSwatch(devicePixelRatioF()));
  unfinished_ = new QLabel(tr("not finished yet"), rest);
  restLayout->addWidget(swatch);
  restLayout->addWidget(unfinished_, 1);
  body().setSpacing(5);
  for (QWidget* widget : std::initializer_list<QWidget*>{title_, colouring_, colours_, text_, rest})
    body().addWidget(widget);
  connect(colouring_, &QComboBox::activated, this,
          [this](int index) { model_.setColouring(kCellColourings[static_cast<std::size_t>(index)]); });
  connect(&model_, &CellModel::figuresChanged, this, &CellLegend::describe);
  describe();
}

void CellLegend::describe() {
  colouring_->setCurrentIndex(static_cast<int>(model_.colouring()));
  const CellBlock* block = model_.shownBlock();
  const bool hasRanks = block && !block->ranks.empty();
  colouring_->setItemText(0, tr("Colours: %1").arg(hasRanks ? tr("Rank") : labelOf(kCellColourings[0])));
  if (!block) {
    title_->setText(tr("No cells"));
    colours_->hide();
    text_->setText(tr("The pipeline has no parallel block, or it has not run yet."));
    unfinished_->parentWidget()->hide();
  } else {
    const std::size_t cells = block->report.cells.size();
    const QString count = cells == 1 ? tr("1 cell") : tr("%1 cells").arg(cells);
    title_->setText(model_.previewing() ? tr("%1, before a run").arg(count) : count);
    const CellScale scale = model_.scaleOf(model_.shownIndex());
    if (scale.shown() == CellColouring::Thread) {
      describeThreads(scale);
    } else {
      describeScale(scale);
    }
    colours_->show();
    unfinished_->parentWidget()->setVisible(!scale.allKnown());
  }
  // The text is as wide as the box, because a layout that may give it more width counts too few lines.
  for (QLabel* text : {title_, text_}) text->setFixedWidth(std::max(kWidth, colouring_->sizeHint().width()));
  body().activate();
  layout()->activate();
  adjustSize();
  emit changed();
}

void CellLegend::describeThreads(const CellScale& scale) {
  colours_->setPixmap(threadSwatches(scale.threads(), font(), devicePixelRatioF()));
  const std::vector<ThreadShare> shares = threadShares(*model_.shownBlock());
  double all = 0;
  for (const ThreadShare& share : shares) all += share.ms;
  const bool hasRanks = !model_.shownBlock()->ranks.empty();
  QStringList lines{hasRanks ? tr("Rank that ran the cell; its share of the work:")
                             : tr("Thread that began the cell; its share of the work:")};
  for (const ThreadShare& share : shares) {
    if (lines.size() > kThreadsListed) {
      lines << tr("%n more", nullptr, static_cast<int>(shares.size()) - kThreadsListed);
      break;
    }
    const auto cells = static_cast<int>(share.cells);
    lines << (hasRanks ? tr("Rank %1: %2 %, %3, %n cell(s)", nullptr, cells)
                       : tr("Thread %1: %2 %, %3, %n cell(s)", nullptr, cells))
                 .arg(share.thread)
                 .arg(all > 0 ? std::round(100 * share.ms / all) : 0)
                 .arg(durationText(share.ms));
  }
  text_->setText(lines.join(QLatin1Char('\n')));
}

void CellLegend::describeScale(const CellScale& scale) {
  colours_->setPixmap(scaleSwatch(devicePixelRatioF()));
  QString text = tr("0 to %1").arg(valueText(scale.shown(), scale.darkest()));
  switch (scale.shown()) {
    case CellColouring::Time:
      text += tr(" of work");
      break;
    case CellColouring::Triangles:
      text += tr(" that go in");
      break;
    case CellColouring::Cost:
      text += tr(", estimated");
      break;
    case CellColouring::Thread:
      break;
  }
  if (scale.darkest() < scale.maximum())
    text += QLatin1Char('\n') + tr("More: darkest; at most %1").arg(valueText(scale.shown(), scale.maximum()));
  const CellBlock* block = model_.shownBlock();
  if (!block->begun() && model_.colouring() != CellColouring::Cost)
    text += QLatin1Char('\n') + tr("Nothing has run yet: an estimate stands in");
  text_->setText(text);
}

}  // namespace footfall::ui
