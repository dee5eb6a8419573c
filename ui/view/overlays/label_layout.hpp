// Places text labels beside places of the view, so that they are readable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace footfall::ui {

/// Places labels one after the other, in logical pixels of a view. A label stands right above its place, else at
/// another corner of it, else beside the obstructing rectangles; where there is no free room, it covers as little as
/// possible. No label leaves a view that is larger than the label.
class LabelLayout {
 public:
  /// `taken` has the rectangles that no label may cover: widgets over the view, and marks.
  LabelLayout(const QSizeF& view, std::vector<QRectF> taken);

  /// The box of a label of this size for the place `at`; later labels avoid it.
  QRectF place(const QSizeF& size, const QPointF& at);

 private:
  [[nodiscard]] QRectF movedInside(QRectF box) const;
  [[nodiscard]] double covers(const QRectF& box) const;

  QRectF room_;
  std::vector<QRectF> taken_;
};

}  // namespace footfall::ui
