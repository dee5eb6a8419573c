// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/legend.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace footfall {
namespace {

constexpr QSize kSwatch(30, 15);
constexpr std::uint32_t kSwatchesOfLayers = 12;

// Adjoining pieces, one a layer.
QPixmap layersSwatch(std::uint32_t layers, qreal ratio) {
  const auto shown = static_cast<int>(std::min(layers, kSwatchesOfLayers));
  const int piece = shown > 6 ? 12 : 18;
  QPixmap pixmap(QSize(shown * (piece + 2), kSwatch.height()) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  for (int i = 0; i < shown; ++i) {
    painter.drawPixmap(i * (piece + 2), 0,
                       paintSwatch(layerPaint(static_cast<std::uint32_t>(i)), {piece, kSwatch.height()}, ratio));
  }
  return pixmap;
}

void setSwatch(QCheckBox* box, const QPixmap& pixmap) {
  box->setIconSize((QSizeF(pixmap.size()) / pixmap.devicePixelRatio()).toSize());
  box->setIcon(QIcon(pixmap));
}

}  // namespace

Legend::Legend(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("legend"));
  setAttribute(Qt::WA_StyledBackground);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 12, 9);
  layout->setSpacing(4);

  walkable_ = addEntry(tr("Walkable"), &SceneParts::walkable, tr("Where an agent can stand and walk"));
  obstacleEdges_ = addEntry(tr("Obstacle edge: not to be crossed"), &SceneParts::obstacleEdges,
                            tr("Walkable on both sides, but an agent cannot cross: a wall stands on it"));
  connections_ = addEntry(tr("Connection of two layers"), &SceneParts::connections,
                          tr("An edge on which two layers meet: agents can cross"));
  removed_ = addEntry(tr("Not walkable because:"), &SceneParts::removed, tr("Floors that a filter removed"));
  reasons_ = new QWidget(this);
  layout->addWidget(reasons_);
  environment_ = addEntry(tr("Walls, ceilings and the rest"), &SceneParts::environment, tr("The loaded triangles"));

  const qreal ratio = devicePixelRatioF();
  setSwatch(obstacleEdges_, lineSwatch(obstacleEdgeColour(), 3, kSwatch, ratio));
  setSwatch(connections_, lineSwatch(connectionColour(), 3, kSwatch, ratio));
  setSwatch(environment_, paintSwatch(wallPaint(), kSwatch, ratio));
  describe({});
}

QCheckBox* Legend::addEntry(const QString& label, bool SceneParts::*part, const QString& help) {
  auto* box = new QCheckBox(label, this);
  box->setToolTip(help);
  box->setChecked(parts_.*part);
  box->setFocusPolicy(Qt::TabFocus);  // with the mouse, the keys stay with the view
  connect(box, &QCheckBox::clicked, this, [this, part](bool on) {
    parts_.*part = on;
    emit partsChanged(parts_);
  });
  layout()->addWidget(box);
  return box;
}

void Legend::showCells(bool on) {
  if (std::exchange(parts_.cells, on) != on) emit partsChanged(parts_);
}

void Legend::describe(const ViewContent& content) {
  std::uint32_t layers = 0;
  bool edges = false;
  bool connections = false;
  for (const auto& mesh : content.walkable) {
    layers = std::max(layers, mesh->layers);
    edges = edges || !mesh->obstacleEdges.empty();
    connections = connections || !mesh->connections.empty();
  }
  const qreal ratio = devicePixelRatioF();
  walkable_->setText(layers == 0   ? tr("Walkable")
                     : layers == 1 ? tr("Walkable, 1 layer")
                                   : tr("Walkable, %1 layers").arg(layers));
  setSwatch(walkable_, layers == 0 ? paintSwatch(walkablePaint(), kSwatch, ratio) : layersSwatch(layers, ratio));
  walkable_->setVisible(!content.walkable.empty());
  obstacleEdges_->setVisible(edges);
  connections_->setVisible(connections);

  std::vector<const RemovalStyle*> reasons;
  if (content.firstRemoval) reasons.push_back(content.firstRemoval);
  for (const ViewContent::Removed& removed : content.removed) {
    if (std::find(reasons.begin(), reasons.end(), removed.style) == reasons.end()) reasons.push_back(removed.style);
  }
  removed_->setVisible(!reasons.empty());
  reasons_->setVisible(!reasons.empty());
  if (reasons != shownReasons_) {
    shownReasons_ = reasons;
    delete reasons_->layout();
    qDeleteAll(reasons_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    auto* grid = new QGridLayout(reasons_);
    grid->setContentsMargins(22, 0, 0, 2);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      auto* swatch = new QLabel(reasons_);
      swatch->setPixmap(paintSwatch(reasons[i]->paint, kSwatch, ratio));
      auto* reason = new QLabel(reasons[i]->reason, reasons_);
      grid->addWidget(swatch, static_cast<int>(i), 0);
      grid->addWidget(reason, static_cast<int>(i), 1);
      swatch->show();  // at once: the size of the legend is wanted before the next event
      reason->show();
    }
    grid->activate();
  }
  layout()->activate();
  adjustSize();
}

}  // namespace footfall
