// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/layer_panel.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/text/core_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

enum Column { kEye, kNumber, kArea, kTriangles, kColumns };
constexpr QSize kRowSwatch(22, 14);
constexpr int kLayerRole = Qt::UserRole;
constexpr int kSortRole = Qt::UserRole + 1;

/// Sorts by numbers instead of by texts.
class Row : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget() ? treeWidget()->sortColumn() : kNumber;
    return data(column, kSortRole).toDouble() < other.data(column, kSortRole).toDouble();
  }
};

// An eye, open or closed, in the palette's colours, so that it suits both themes.
QIcon eyeIcon(bool open, const QPalette& palette, qreal ratio) {
  constexpr int kSide = 18;
  QPixmap pixmap(QSize(kSide, kSide) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor ink = palette.color(open ? QPalette::Active : QPalette::Disabled, QPalette::Text);
  painter.setPen(QPen(ink, 1.6));
  QPainterPath lower(QPointF(2, 9));
  lower.quadTo(9, 16, 16, 9);
  if (open) {
    QPainterPath upper(QPointF(2, 9));
    upper.quadTo(9, 2, 16, 9);
    painter.drawPath(upper);
    painter.setBrush(ink);
    painter.drawEllipse(QPointF(9, 9), 2.4, 2.4);
    painter.setBrush(Qt::NoBrush);
  } else {
    painter.drawLine(QPointF(9, 12.5), QPointF(9, 15.5));
    painter.drawLine(QPointF(4.5, 11), QPointF(3, 13.5));
    painter.drawLine(QPointF(13.5, 11), QPointF(15, 13.5));
  }
  painter.drawPath(lower);
  return QIcon(pixmap);
}

}  // namespace

LayerPanel::LayerPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("layerPanel"));
  summary_ = new QLabel(tr("No result yet"), this);
  summary_->setObjectName(QStringLiteral("layerSummary"));
  summary_->setWordWrap(true);
  all_ = new QPushButton(tr("Show all"), this);
  all_->setObjectName(QStringLiteral("showAllLayers"));
  all_->setToolTip(tr("Show all layers again"));
  connect(all_, &QPushButton::clicked, this, &LayerPanel::showAll);
  list_ = new QTreeWidget(this);
  list_->setObjectName(QStringLiteral("layerList"));
  list_->setAccessibleName(tr("Layers"));
  list_->setToolTip(tr(
      "The eye (or Space) hides and shows a layer. A click on a row (or Enter) shows it alone, another one shows all "
      "again; a double click brings it into sight. Walls stay: see the view mode Walkable only, or the heights."));
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setAllColumnsShowFocus(true);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->setHeaderLabels({QString(), tr("Layer"), QString(), tr("Triangles")});
  list_->headerItem()->setToolTip(kArea, tr("Of the surface"));
  list_->headerItem()->setToolTip(kTriangles, tr("Walkable triangles"));
  list_->headerItem()->setToolTip(kEye, tr("Whether the view shows it"));
  for (const int column : {kArea, kTriangles}) list_->headerItem()->setTextAlignment(column, Qt::AlignRight);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(kNumber, QHeaderView::Stretch);
  list_->setIconSize({22, 18});
  list_->setSortingEnabled(true);
  list_->sortByColumn(kNumber, Qt::AscendingOrder);
  list_->installEventFilter(this);
  connect(list_, &QTreeWidget::itemClicked, this, &LayerPanel::act);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
    const std::uint32_t layer = item->data(0, kLayerRole).toUInt();
    if (column == kEye || !result_ || layer >= result_->figures.size()) return;
    // Its first click may have ended showing the layer alone.
    if (layers() > 1) showOnly(layer);
    emit frameRequested(result_->figures[layer]);
  });
  auto* top = new QHBoxLayout;
  top->addWidget(summary_, 1);
  top->addWidget(all_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addWidget(list_, 1);
  setTabOrder(all_, list_);
  fill();
}

void LayerPanel::setResult(std::shared_ptr<const NavigationMeshGeometry> result) {
  if (result == result_) return;
  const std::set<std::uint32_t> before = hiddenHere();
  result_ = std::move(result);
  counts_.reset();
  // The only shown layer may no longer exist; an empty view would be confusing.
  if (layers() > 0 && hiddenHere().size() == layers()) hidden_.clear();
  fill();
  if (hiddenHere() != before) emit hiddenChanged(hiddenHere());
}

void LayerPanel::setCounts(const LayerCounts& counts) {
  counts_ = counts;
  showStates();
}

void LayerPanel::setUnits(const LevelUnits& units) {
  units_ = units;
  fill();
}

void LayerPanel::setHidden(const std::set<std::uint32_t>& hidden) {
  const std::set<std::uint32_t> before = hiddenHere();
  hidden_ = hidden;
  showStates();
  if (hiddenHere() != before) emit hiddenChanged(hiddenHere());
}

std::set<std::uint32_t> LayerPanel::hiddenHere() const { return {hidden_.begin(), hidden_.lower_bound(layers())}; }

std::optional<std::uint32_t> LayerPanel::soloLayer() const {
  if (layers() < 2 || hiddenHere().size() + 1 != layers()) return std::nullopt;
  for (std::uint32_t layer = 0; layer < layers(); ++layer) {
    if (!hidden_.contains(layer)) return layer;
  }
  return std::nullopt;
}

void LayerPanel::showOnly(std::uint32_t layer) {
  std::set<std::uint32_t> hidden;
  for (std::uint32_t other = 0; other < layers(); ++other) {
    if (other != layer) hidden.insert(other);
  }
  setHidden(hidden);
}

void LayerPanel::stepSolo(int direction) {
  if (layers() < 2) return;
  const std::optional<std::uint32_t> now = soloLayer();
  const std::uint32_t next = now             ? (*now + layers() + static_cast<std::uint32_t>(direction)) % layers()
                             : direction > 0 ? 0
                                             : layers() - 1;
  showOnly(next);
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* item = list_->topLevelItem(row);
    if (item->data(0, kLayerRole).toUInt() == next) list_->setCurrentItem(item);
  }
}

void LayerPanel::toggle(std::uint32_t layer) {
  std::set<std::uint32_t> hidden = hidden_;
  if (!hidden.erase(layer)) hidden.insert(layer);
  setHidden(hidden);
}

void LayerPanel::solo(std::uint32_t layer) {
  if (soloLayer() == layer) {
    showAll();
  } else {
    showOnly(layer);
  }
}

void LayerPanel::act(QTreeWidgetItem* item, int column) {
  if (!item || layers() == 0) return;
  const std::uint32_t layer = item->data(0, kLayerRole).toUInt();
  if (column == kEye) {
    toggle(layer);
  } else if (layers() > 1) {
    solo(layer);
  }
}

bool LayerPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Space) {
      act(list_->currentItem(), kEye);
      return true;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      act(list_->currentItem(), kNumber);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void LayerPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showStates();
  QWidget::changeEvent(event);
}

void LayerPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit appeared();
}

void LayerPanel::fill() {
  const QTreeWidgetItem* const before = list_->currentItem();
  const int current = before ? before->data(0, kLayerRole).toInt() : -1;
  list_->setSortingEnabled(false);
  list_->clear();
  list_->headerItem()->setText(kArea, tr("Area (%1)").arg(units_.areaName()));
  for (std::size_t i = 0; result_ && i < result_->figures.size(); ++i) {
    const LayerFigures& figures = result_->figures[i];
    auto* row = new Row(list_);
    row->setData(0, kLayerRole, static_cast<uint>(i));
    const QString number = QString::number(i);
    row->setText(kNumber, layers() == 0             ? tr("Walkable area")
                          : figures.storeys.empty() ? number
                                                    : number + QStringLiteral(" · ") + coreText(Text(figures.storeys)));
    row->setText(kArea, units_.areaNumber(figures.area));
    row->setText(kTriangles, countText(figures.triangles));
    row->setData(kNumber, kSortRole, static_cast<double>(i));
    row->setData(kArea, kSortRole, figures.area);
    row->setData(kTriangles, kSortRole, figures.triangles);
    for (const int column : {kArea, kTriangles}) row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    const Paint paint = layers() == 0 ? walkablePaint() : layerPaint(static_cast<std::uint32_t>(i));
    row->setIcon(kNumber, QIcon(paintSwatch(paint, kRowSwatch, devicePixelRatioF())));
    if (current == static_cast<int>(i)) list_->setCurrentItem(row);
  }
  list_->setSortingEnabled(true);
  showStates();
}

// Updates the eyes, greyed rows and the text above.
void LayerPanel::showStates() {
  const qreal ratio = devicePixelRatioF();
  const QIcon open = eyeIcon(true, palette(), ratio);
  const QIcon closed = eyeIcon(false, palette(), ratio);
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = list_->topLevelItem(i);
    const bool hidden = layers() > 0 && hidden_.contains(row->data(0, kLayerRole).toUInt());
    row->setIcon(kEye, hidden ? closed : open);
    row->setData(kEye, Qt::AccessibleTextRole, hidden ? tr("hidden") : tr("shown"));
    row->setData(kEye, kSortRole, hidden ? 1.0 : 0.0);
    const QBrush ink = palette().brush(hidden ? QPalette::Disabled : QPalette::Active, QPalette::Text);
    for (int column = 0; column < kColumns; ++column) row->setForeground(column, ink);
  }
  const auto hidden = hiddenHere().size();
  all_->setEnabled(hidden > 0);
  if (!result_) {
    summary_->setText(tr("No result yet"));
  } else if (layers() == 0) {
    summary_->setText(tr("Not divided into layers; add a layer filter to tell floors apart"));
  } else if (hidden > 0) {
    summary_->setText(tr("%1 of %2 layers shown").arg(layers() - hidden).arg(layers()));
  } else {
    summary_->setText(countsText());
  }
}

// The counts, each with its bound once that is known.
QString LayerPanel::countsText() const {
  const QString layersText = layers() == 1 ? tr("1 layer") : tr("%1 layers").arg(countText(layers()));
  if (!counts_) return layersText;
  const auto withBound = [](const QString& text, std::size_t count, std::size_t least) {
    if (count <= 1 || least == 0) return text;
    if (count == least) return tr("%1 (as few as possible)").arg(text);
    return least == 1 ? tr("%1 (at least 1 is needed)").arg(text)
                      : tr("%1 (at least %2 are needed)").arg(text, countText(least));
  };
  const QString connections =
      counts_->connections == 1 ? tr("1 connection") : tr("%1 connections").arg(countText(counts_->connections));
  return withBound(layersText, layers(), counts_->leastLayers) + QLatin1Char('\n') +
         withBound(connections, counts_->connections, counts_->leastConnections);
}

}  // namespace footfall::ui
