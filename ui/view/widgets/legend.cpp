// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/legend.hpp"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr QSize kSwatch(30, 15);
constexpr std::uint32_t kSwatchesOfLayers = 12;

// Adjoining pieces, one for each layer.
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

// Colours from the lower to the upper end, hatched where the limit rejects, with numbers below.
QPixmap scaleSwatch(ViewMode mode, const FieldScale& scale, double factor, const QFont& font, const QColor& ink,
                    qreal ratio) {
  constexpr int kWidth = 216;
  constexpr int kBar = 14;
  constexpr int kEnd = 8;  // room for numbers beyond the bar
  QFont small = font;
  small.setPixelSize(11);
  const int line = QFontMetrics(small).height();
  QPixmap pixmap(QSize(kWidth + 2 * kEnd, kBar + 6 + 2 * line) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setFont(small);
  const double span = scale.upper - scale.lower;
  const auto xOf = [&](double value) { return kEnd + (value - scale.lower) / span * (kWidth - 1); };
  for (int x = 0; x < kWidth; ++x) {
    const double part = static_cast<double>(x) / (kWidth - 1);
    const double value = scale.lower + part * span;
    QColor colour = heatColour(scale.aboveIsRejected ? 1 - part : part);
    for (int y = 0; y < kBar; ++y) {
      const bool rejected = scale.limit && (scale.aboveIsRejected ? value > *scale.limit : value < *scale.limit);
      painter.fillRect(QRectF(x + kEnd, y, 1, 1), rejected && (x + y) % 8 < 2 ? colour.darker(170) : colour);
    }
  }
  painter.setPen(ink);
  const auto text = [&](double value, int row, const QString& words) {
    const int width = QFontMetrics(small).horizontalAdvance(words);
    const double x = std::clamp(xOf(value) - width / 2.0, 0.0, kWidth + 2.0 * kEnd - width);
    painter.drawText(QRectF(x, kBar + 4 + row * line, width + 2, line), Qt::AlignLeft, words);
  };
  const QString unit = mode == ViewMode::Slope ? QStringLiteral("°") : QString();
  constexpr int kTicks = 3;
  for (int i = 0; i <= kTicks; ++i) {
    const double value = scale.lower + span * i / kTicks;
    painter.drawLine(QPointF(xOf(value), kBar), QPointF(xOf(value), kBar + 3));
    const bool open = mode == ViewMode::Clearance && i == kTicks;  // or more
    text(value, 0, (open ? QStringLiteral("≥ ") : QString()) + shortText(value * factor, 4) + unit);
  }
  if (scale.limit) {
    const double x = xOf(std::clamp(*scale.limit, scale.lower, scale.upper));
    painter.setPen(QPen(Qt::white, 4));
    painter.drawLine(QPointF(x, 0), QPointF(x, kBar));
    painter.setPen(QPen(Qt::black, 2));
    painter.drawLine(QPointF(x, 0), QPointF(x, kBar));
    painter.setPen(ink);
    text(*scale.limit, 1, Legend::tr("limit %1").arg(shortText(*scale.limit * factor) + unit));
  }
  return pixmap;
}

void setSwatch(QCheckBox* box, const QPixmap& pixmap) {
  box->setIconSize((QSizeF(pixmap.size()) / pixmap.devicePixelRatio()).toSize());
  box->setIcon(QIcon(pixmap));
}

}  // namespace

Legend::Legend(QWidget* parent) : OverlayFrame(tr("Legend"), QStringLiteral("legend"), parent) {
  setObjectName(QStringLiteral("legend"));
  body().setSpacing(4);

  mode_ = new QLabel(this);
  mode_->setObjectName(QStringLiteral("modeTitle"));
  mode_->setStyleSheet(QStringLiteral("font-weight: 600"));
  mode_->hide();
  scale_ = new QLabel(this);
  scale_->setObjectName(QStringLiteral("modeScale"));
  scale_->hide();
  body().addWidget(mode_);
  body().addWidget(scale_);
  walkable_ = addEntry(tr("Walkable"), &SceneParts::walkable, tr("Where an agent can stand and walk"));
  obstacleEdges_ = addEntry(tr("Obstacle edge: not to be crossed"), &SceneParts::obstacleEdges,
                            tr("Walkable on both sides, but an agent cannot cross: a wall stands on it"));
  connections_ = addEntry(tr("Connection of two layers"), &SceneParts::connections,
                          tr("An edge on which two layers meet: agents can cross"));
  steps_ = addEntry(tr("Step: can be climbed"), &SceneParts::steps,
                    tr("Two borders above each other that an agent can step between"));
  gaps_ = addEntry(tr("Gap: can be stepped over"), &SceneParts::gaps,
                   tr("Two borders beside each other that an agent can step between"));
  drops_ = addEntry(tr("Drop: one way down"), &SceneParts::drops,
                    tr("A ledge from which an agent drops to a lower place, along the arrows, and does not come back"));
  removed_ = addEntry(tr("Not walkable because:"), &SceneParts::removed, tr("Floors that a filter removed"));
  reasons_ = new QWidget(this);
  reasons_->setObjectName(QStringLiteral("reasons"));
  connect(removed_, &QCheckBox::toggled, reasons_, &QWidget::setEnabled);
  body().addWidget(reasons_);
  environment_ = addEntry(tr("Walls, ceilings and the rest"), &SceneParts::environment, tr("The loaded triangles"));

  notes_ = new QLabel(this);
  notes_->setObjectName(QStringLiteral("legendNotes"));
  notes_->setTextFormat(Qt::RichText);
  notes_->hide();
  body().addWidget(notes_);

  const qreal ratio = devicePixelRatioF();
  setSwatch(obstacleEdges_, lineSwatch(obstacleEdgeColour(), 3, kSwatch, ratio));
  setSwatch(connections_, lineSwatch(connectionColour(), 3, kSwatch, ratio));
  setSwatch(steps_, lineSwatch(stepColour(), 3, kSwatch, ratio));
  setSwatch(gaps_, lineSwatch(gapColour(), 3, kSwatch, ratio, Qt::DashLine));
  setSwatch(drops_, lineSwatch(dropColour(), 3, kSwatch, ratio));
  setSwatch(environment_, paintSwatch(wallPaint(), kSwatch, ratio));
  describe({});
}

QCheckBox* Legend::addEntry(const QString& label, bool SceneParts::*part, const QString& help) {
  auto* box = new QCheckBox(label, this);
  box->setToolTip(help);
  setSwitch(box, parts_.*part, [this, part](bool on) { parts_.*part = on; });
  body().addWidget(box);
  return box;
}

// Makes a box switch a part.
void Legend::setSwitch(QCheckBox* box, bool on, const std::function<void(bool)>& set) {
  box->setChecked(on);
  box->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus in the view
  connect(box, &QCheckBox::clicked, this, [this, set](bool nowOn) {
    set(nowOn);
    emit partsChanged(parts_);
  });
}

void Legend::showCells(bool on) {
  if (std::exchange(parts_.cells, on) != on) emit partsChanged(parts_);
}

void Legend::describe(const ViewContent& content) {
  std::uint32_t layers = 0;
  bool edges = false;
  bool connections = false, steps = false, gaps = false, drops = false;
  for (const auto& mesh : content.walkable) {
    layers = std::max(layers, mesh->layers);
    edges = edges || !mesh->obstacleEdges.empty();
    connections = connections || !mesh->connections.empty();
    steps = steps || !mesh->steps.empty();
    gaps = gaps || !mesh->gaps.empty();
    drops = drops || !mesh->drops.empty();
  }
  if (content.walkable.empty()) forgetCrowding();  // another level
  layers_ = layers;
  anyWalkable_ = !content.walkable.empty();
  obstacleEdges_->setVisible(edges);
  connections_->setVisible(connections);
  steps_->setVisible(steps);
  gaps_->setVisible(gaps);
  drops_->setVisible(drops);

  std::vector<const RemovalStyle*> reasons;
  if (content.firstRemoval) reasons.push_back(content.firstRemoval);
  for (const ViewContent::Removed& removed : content.removed) {
    if (std::find(reasons.begin(), reasons.end(), removed.style) == reasons.end()) reasons.push_back(removed.style);
  }
  describeReasons(reasons);
  fit();
}

void Legend::setUnits(const LevelUnits& units) {
  units_ = units;
  showMode(shownMode_, shownScale_, modeReady_);
}

void Legend::showMode(ViewMode mode, const FieldScale& scale, bool ready) {
  if (mode != shownMode_ || ready != modeReady_) forgetCrowding();
  shownMode_ = mode;
  shownScale_ = scale;
  modeReady_ = ready;
  mode_->setVisible(mode != ViewMode::Result);
  const QString title = mode == ViewMode::Slope       ? tr("Slope of floors")
                        : mode == ViewMode::Clearance ? tr("Free height above floors, in %1").arg(units_.name())
                                                      : labelOf(mode);
  mode_->setText(ready ? title : tr("%1 (computing)").arg(title));
  scale_->setVisible(isHeatMap(mode));
  if (isHeatMap(mode)) {
    const double factor = mode == ViewMode::Slope ? 1 : units_.factor();
    scale_->setPixmap(scaleSwatch(mode, scale, factor, font(), palette().color(QPalette::Text), devicePixelRatioF()));
    const QString what = labelOf(mode);
    scale_->setAccessibleName(scale.limit ? tr("%1, limit %2").arg(what, shortText(*scale.limit * factor)) : what);
    scale_->setToolTip(mode == ViewMode::Slope ? tr("Hatched: steeper than the limit of the slope filter")
                                               : tr("Hatched: less than the clearance filter needs"));
  }
  describeReasons(shownReasons_);
  fit();
}

QImage Legend::scaleImage() const {
  const QPixmap scale = scale_->pixmap();
  QImage image(scale.size(), QImage::Format_RGB32);
  image.setDevicePixelRatio(scale.devicePixelRatio());
  image.fill(palette().color(QPalette::Window));
  QPainter(&image).drawPixmap(0, 0, scale);
  return image;
}

// The colours of the reasons, and all entries of the mode.
void Legend::describeReasons(const std::vector<const RemovalStyle*>& reasons) {
  const qreal ratio = devicePixelRatioF();
  const bool vivid = shownMode_ == ViewMode::RejectedBy;
  const bool source = shownMode_ == ViewMode::SourceTriangles;
  walkable_->setText(source         ? tr("Walkable, by source triangle")
                     : layers_ == 0 ? tr("Walkable")
                     : layers_ == 1 ? tr("Walkable, 1 layer")
                                    : tr("Walkable, %1 layers").arg(layers_));
  setSwatch(walkable_, vivid                     ? paintSwatch(paleWalkablePaint(), kSwatch, ratio)
                       : layers_ == 0 && !source ? paintSwatch(walkablePaint(), kSwatch, ratio)
                       : source                  ? layersSwatch(4, ratio)
                                                 : layersSwatch(layers_, ratio));
  walkable_->setVisible(anyWalkable_ && !isHeatMap(shownMode_));
  environment_->setVisible(shownMode_ != ViewMode::WalkableOnly);
  const bool shown = !reasons.empty() && (shownMode_ == ViewMode::Result || vivid);
  removed_->setVisible(shown);
  reasons_->setVisible(shown);
  if (reasons == shownReasons_ && vivid == shownVivid_) return;
  shownReasons_ = reasons;
  shownVivid_ = vivid;
  delete reasons_->layout();
  qDeleteAll(reasons_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
  auto* rows = new QVBoxLayout(reasons_);
  rows->setContentsMargins(22, 0, 0, 2);
  rows->setSpacing(4);
  for (const RemovalStyle* reason : reasons) {
    const RemovalStyle& style = *reason;  // styles live as long as the program
    auto* box = new QCheckBox(style.reason, reasons_);
    setSwatch(box, paintSwatch(vivid ? style.vivid : style.paint, kSwatch, ratio));
    setSwitch(box, parts_.shows(style), [this, &style](bool on) { parts_.show(style, on); });
    rows->addWidget(box);
    box->show();  // at once, because the size of the legend is needed before the next event
  }
  rows->activate();
}

void Legend::setNotes(const std::vector<Note>& notes) {
  QStringList lines;
  for (const Note& note : notes) {
    const QString swatch = QStringLiteral("<span style='color:%1'>■■</span> ").arg(note.colour.name());
    lines << (note.colour.isValid() ? swatch : QString()) + note.text.toHtmlEscaped();
  }
  notes_->setText(lines.join(QStringLiteral("<br>")));
  notes_->setVisible(!notes.empty());
  fit();
}

void Legend::fit() {
  body().activate();
  layout()->activate();
  adjustSize();
}

}  // namespace footfall::ui
