// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlays/label_layout.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace footfall::ui {
namespace {

constexpr double kEdge = 3;        // distance to the view's edges and to taken rectangles
constexpr double kBeside = 10;     // from a place to its label, sideways
constexpr double kAbove = 4;       // upwards
constexpr double kBelow = 10;      // downwards
constexpr std::size_t kMost = 12;  // the number of obstructing rectangles that are avoided

double area(const QRectF& box) { return box.isEmpty() ? 0 : box.width() * box.height(); }

double distance(const QRectF& box, const QPointF& at) {
  const double x = std::max({box.left() - at.x(), at.x() - box.right(), 0.0});
  const double y = std::max({box.top() - at.y(), at.y() - box.bottom(), 0.0});
  return x * x + y * y;
}

std::array<QRectF, 4> cornersOf(const QSizeF& size, const QPointF& at) {
  const double right = at.x() + kBeside;
  const double left = at.x() - kBeside - size.width();
  const double above = at.y() - kAbove - size.height();
  const double below = at.y() + kBelow;
  return {QRectF(QPointF(right, above), size), QRectF(QPointF(left, above), size), QRectF(QPointF(right, below), size),
          QRectF(QPointF(left, below), size)};
}

}  // namespace

LabelLayout::LabelLayout(const QSizeF& view, std::vector<QRectF> taken)
    : room_(QRectF(QPointF(), view).adjusted(kEdge, kEdge, -kEdge, -kEdge)), taken_(std::move(taken)) {}

QRectF LabelLayout::movedInside(QRectF box) const {
  box.moveLeft(std::max(room_.left(), std::min(box.left(), room_.right() - box.width())));
  box.moveTop(std::max(room_.top(), std::min(box.top(), room_.bottom() - box.height())));
  return box;
}

double LabelLayout::covers(const QRectF& box) const {
  double sum = 0;
  for (const QRectF& other : taken_) sum += area(other.intersected(box));
  return sum;
}

QRectF LabelLayout::place(const QSizeF& size, const QPointF& at) {
  QRectF best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const QRectF& box) {
    const double covered = covers(box);
    if (covered >= least) return;
    least = covered;
    best = box;
  };
  const std::array<QRectF, 4> corners = cornersOf(size, at);
  for (const QRectF& box : corners) {
    if (room_.contains(box)) consider(box);
    if (least == 0) break;
  }
  if (least > 0) {
    const QRectF wanted = movedInside(corners[0]);
    std::vector<QRectF> others{wanted};
    std::size_t gone = 0;
    for (const QRectF& other : taken_) {
      const bool inTheWay =
          std::ranges::any_of(corners, [&](const QRectF& box) { return other.intersects(movedInside(box)); });
      if (!inTheWay || ++gone > kMost) continue;
      const double left = other.left() - kEdge - size.width();
      const double above = other.top() - kEdge - size.height();
      for (const QPointF& corner : {QPointF(left, wanted.top()), QPointF(other.right() + kEdge, wanted.top()),
                                    QPointF(wanted.left(), above), QPointF(wanted.left(), other.bottom() + kEdge)})
        others.push_back(movedInside(QRectF(corner, size)));
    }
    std::ranges::stable_sort(others, {}, [&](const QRectF& box) { return distance(box, at); });
    for (const QRectF& box : others) consider(box);
  }
  taken_.push_back(best);
  return best;
}

}  // namespace footfall::ui
