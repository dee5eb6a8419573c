// Where words beside places of the view go, so that they can be read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace footfall::ui {

/// Places labels one after the other, in logical pixels of a view. A label stands right above its place, else in
/// another corner of it, else beside what is in the way; where there is no free room, it covers as little as possible.
/// No label leaves a view that is larger than it.
class LabelLayout {
 public:
  /// `taken` is what no label is to cover: widgets over the view, and marks.
  LabelLayout(const QSizeF& view, std::vector<QRectF> taken);

  /// The box of a label of such a size for the place `at`; labels that come later keep off it.
  QRectF place(const QSizeF& size, const QPointF& at);

 private:
  [[nodiscard]] QRectF movedInside(QRectF box) const;
  [[nodiscard]] double covers(const QRectF& box) const;

  QRectF room_;
  std::vector<QRectF> taken_;
};

}  // namespace footfall::ui
