// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/view_layout.hpp"

#include <QEvent>
#include <algorithm>

namespace footfall::ui {
namespace {

constexpr int kMargin = 12;
constexpr int kGap = 8;

bool shown(const QWidget* widget) { return widget && !widget->isHidden(); }

}  // namespace

ViewLayout::ViewLayout(LevelView& view)
    : QObject(&view), view_(view), legend_(new Legend(&view)), heights_(new HeightSlider(&view)) {
  legend_->hide();
  heights_->hide();
  connect(legend_, &Legend::partsChanged, &view_, &LevelView::setParts);
  connect(legend_, &OverlayFrame::changed, this, &ViewLayout::update);
  connect(heights_, &HeightSlider::rangeChanged, &view_, &LevelView::setHeights);
  view_.installEventFilter(this);
}

void ViewLayout::update() {
  place(view_.size());
  view_.cameraController().setCovered(covered());
}

bool ViewLayout::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &view_ && event->type() == QEvent::Resize) update();
  return QObject::eventFilter(watched, event);
}

void ViewLayout::place(const QSize& view) const {
  int bottom = view.height() - kMargin;  // bottom of the free room on the right
  const bool cellsInCorner = cells_ && !cells_->fitInto(view);
  if (cellsInCorner) {
    cells_->move(view.width() - cells_->width() - kMargin, view.height() - cells_->height() - kMargin);
    if (shown(cells_)) bottom = cells_->y() - kGap;
  }
  int top = kMargin;
  int right = view.width() - kMargin;
  if (gizmo_) {
    gizmo_->move(right - gizmo_->width(), top);
    if (shown(gizmo_)) top = gizmo_->geometry().bottom() + kGap;
  }
  const QSize wanted = heights_->sizeHint();
  if (bottom - top < heights_->minimumSizeHint().height() && shown(gizmo_)) {
    top = kMargin;
    right = gizmo_->x() - kGap;
    bottom = view.height() - kMargin;
    if (cellsInCorner && shown(cells_) && cells_->x() < right) bottom = cells_->y() - kGap;
  }
  // The heights leave more than half of the height free in a small view.
  const int most = std::max(heights_->minimumSizeHint().height(), std::min(wanted.height(), view.height() / 3));
  heights_->setGeometry(right - wanted.width(), top, wanted.width(), std::clamp(bottom - top, 40, most));
  if (hint_) {
    constexpr int kNarrow = 240;  // narrower lines would be broken too often
    // The hint lies at the upper edge, where little of a level is; the gizmo may be wider than the heights.
    int end = shown(heights_) ? heights_->x() - kGap : right;
    int y = shown(heights_) ? kMargin : top;
    if (shown(gizmo_) && y < gizmo_->geometry().bottom()) end = std::min(end, gizmo_->x() - kGap);
    if (shown(heights_) && end - kMargin < kNarrow) {
      end = view.width() - kMargin;
      y = heights_->geometry().bottom() + kGap;
    }
    hint_->fitInto(std::max(1, end - kMargin));
    hint_->move(end - hint_->width(), std::max(y, shown(cutBar_) ? 2 * kMargin + cutBar_->height() : 0));
  }
  if (!legend_->fitInto(view)) legend_->move(kMargin, view.height() - legend_->height() - kMargin);
  if (cutBar_) {
    // The bar has a convenient width, but does not extend under the widgets on the right.
    constexpr int kHandy = 420;
    const int left = shown(heights_) ? heights_->x() : shown(gizmo_) ? gizmo_->x() : view.width();
    const QSize least = cutBar_->minimumSizeHint();
    cutBar_->setGeometry(kMargin, kMargin, std::max(least.width(), std::min(kHandy, left - kGap - kMargin)),
                         least.height());
  }
}

std::vector<QRect> ViewLayout::covered() const {
  std::vector<QRect> rects;
  // The hint is shown for one level only, and a level is framed alike each time it is opened.
  for (const QWidget* widget : std::initializer_list<const QWidget*>{legend_, gizmo_, heights_, cells_, cutBar_}) {
    if (shown(widget)) rects.push_back(widget->geometry());
  }
  return rects;
}

}  // namespace footfall::ui
