// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/overlay_frame.hpp"

#include <QApplication>
#include <QMouseEvent>
#include <QSettings>
#include <algorithm>

namespace footfall::ui {
namespace {

constexpr int kFrameMargin = 12;          // distance to the view's edges
constexpr double kMuchOfView = 0.36;      // share of the view's width or height
constexpr double kMuchOfArea = 1.0 / 12;  // share of both together

}  // namespace

OverlayFrame::OverlayFrame(const QString& title, const QString& setting, QWidget* parent)
    : QFrame(parent), setting_(setting) {
  setAttribute(Qt::WA_StyledBackground);
  setCursor(Qt::ArrowCursor);
  fold_ = new QToolButton(this);
  fold_->setObjectName(QStringLiteral("fold"));
  fold_->setText(title);
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setAutoRaise(true);
  fold_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus in the view
  body_ = new QWidget(this);
  bodyLayout_ = new QVBoxLayout(body_);
  bodyLayout_->setContentsMargins(4, 0, 4, 0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 8, 7);
  layout->setSpacing(2);
  layout->addWidget(fold_, 0, Qt::AlignLeft);
  layout->addWidget(body_);
  const QSettings settings;
  const QVariant kept = settings.value(setting_ + QStringLiteral("/folded"));
  if (kept.isValid()) chosenFold_ = kept.toBool();
  const QVariant place = settings.value(setting_ + QStringLiteral("/place"));
  if (place.canConvert<QPointF>()) place_ = place.toPointF();
  connect(fold_, &QToolButton::clicked, this, [this] { setFolded(!folded()); });
  showFold();
}

bool OverlayFrame::folded() const { return chosenFold_.value_or(crowded_); }

void OverlayFrame::setFolded(bool on) {
  chosenFold_ = on;
  QSettings().setValue(setting_ + QStringLiteral("/folded"), on);
  showFold();
  emit changed();
}

void OverlayFrame::showFold() {
  fold_->setArrowType(folded() ? Qt::RightArrow : Qt::DownArrow);
  fold_->setToolTip(folded() ? tr("Unfold; drag to move, double click to put it back")
                             : tr("Fold; drag to move, double click to put it back"));
  body_->setVisible(!folded());
}

QSize OverlayFrame::roomIn(const QSize& view) const {
  return {std::max(0, view.width() - width() - 2 * kFrameMargin),
          std::max(0, view.height() - height() - 2 * kFrameMargin)};
}

bool OverlayFrame::fitInto(const QSize& view) {
  const QSize full = body_->sizeHint() + QSize(0, fold_->sizeHint().height());
  const bool much = full.width() > kMuchOfView * view.width() || full.height() > kMuchOfView * view.height() ||
                    full.width() * full.height() > kMuchOfArea * view.width() * view.height();
  crowded_ = much || (crowded_ && view == fittedInto_);
  fittedInto_ = view;
  if (body_->isHidden() != folded()) showFold();
  layout()->activate();
  adjustSize();
  if (!place_) return false;
  const QSize room = roomIn(view);
  move(kFrameMargin + qRound(place_->x() * room.width()), kFrameMargin + qRound(place_->y() * room.height()));
  return true;
}

void OverlayFrame::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) grip_ = event->pos();
  event->accept();  // the press was not on the view
}

void OverlayFrame::mouseMoveEvent(QMouseEvent* event) {
  if (!grip_) return;
  dragging_ = dragging_ || (event->pos() - *grip_).manhattanLength() >= QApplication::startDragDistance();
  if (!dragging_) return;
  const QSize view = parentWidget()->size();
  const QSize room = roomIn(view);
  const QPoint to = pos() + event->pos() - *grip_;
  const auto part = [](int at, int all) {
    return all > 0 ? std::clamp((at - kFrameMargin) / double(all), 0.0, 1.0) : 0.0;
  };
  place_ = QPointF(part(to.x(), room.width()), part(to.y(), room.height()));
  fitInto(view);
}

void OverlayFrame::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  grip_.reset();
  if (!std::exchange(dragging_, false)) return;
  QSettings().setValue(setting_ + QStringLiteral("/place"), *place_);
  emit changed();
}

void OverlayFrame::mouseDoubleClickEvent(QMouseEvent* event) {
  event->accept();
  place_.reset();
  QSettings().remove(setting_ + QStringLiteral("/place"));
  emit changed();
}

}  // namespace footfall::ui
