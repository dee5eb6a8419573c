// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/view_layout.hpp"

#include <algorithm>

namespace footfall::ui {
namespace {

constexpr int kMargin = 12;
constexpr int kGap = 8;

bool shown(const QWidget* widget) { return widget && !widget->isHidden(); }

}  // namespace

void ViewLayout::place(const QSize& view) const {
  int bottom = view.height() - kMargin;  // of what is left on the right
  const bool cellsInCorner = cells && !cells->fitInto(view);
  if (cellsInCorner) {
    cells->move(view.width() - cells->width() - kMargin, view.height() - cells->height() - kMargin);
    if (shown(cells)) bottom = cells->y() - kGap;
  }
  int top = kMargin;
  int right = view.width() - kMargin;
  if (gizmo) {
    gizmo->move(right - gizmo->width(), top);
    if (shown(gizmo)) top = gizmo->geometry().bottom() + kGap;
  }
  if (heights) {
    const QSize wanted = heights->sizeHint();
    if (bottom - top < heights->minimumSizeHint().height() && shown(gizmo)) {
      top = kMargin;
      right = gizmo->x() - kGap;
      bottom = view.height() - kMargin;
      if (cellsInCorner && shown(cells) && cells->x() < right) bottom = cells->y() - kGap;
    }
    // In a small view it leaves more than half of the height free.
    const int most = std::max(heights->minimumSizeHint().height(), std::min(wanted.height(), view.height() * 3 / 8));
    heights->setGeometry(right - wanted.width(), top, wanted.width(), std::clamp(bottom - top, 40, most));
  }
  if (hint) {
    constexpr int kNarrow = 240;  // lines would be broken too often
    int end = shown(heights) ? heights->x() - kGap : right;
    int y = shown(heights) ? heights->y() : top;
    if (shown(heights) && end - kMargin < kNarrow) {
      end = view.width() - kMargin;
      y = heights->geometry().bottom() + kGap;
    }
    hint->fitInto(std::max(1, end - kMargin));
    hint->move(end - hint->width(), std::max(y, shown(cutBar) ? 2 * kMargin + cutBar->height() : 0));
  }
  if (legend && !legend->fitInto(view)) legend->move(kMargin, view.height() - legend->height() - kMargin);
  if (cutBar) {
    // As wide as is handy, but not under what stands on the right.
    constexpr int kHandy = 420;
    const int left = shown(heights) ? heights->x() : shown(gizmo) ? gizmo->x() : view.width();
    const QSize least = cutBar->minimumSizeHint();
    cutBar->setGeometry(kMargin, kMargin, std::max(least.width(), std::min(kHandy, left - kGap - kMargin)),
                        least.height());
  }
}

std::vector<QRect> ViewLayout::covered() const {
  std::vector<QRect> rects;
  for (const QWidget* widget : std::initializer_list<const QWidget*>{legend, gizmo, heights, cells, cutBar}) {
    if (shown(widget)) rects.push_back(widget->geometry());
  }
  return rects;
}

}  // namespace footfall::ui
