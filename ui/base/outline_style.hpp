// Fusion with outlines that can be seen on dark ground.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace footfall::ui {

/// Fusion draws outlines darker than the window; in a dark window, check boxes and fields would have none.
class OutlineStyle : public QProxyStyle {
  Q_OBJECT

 public:
  OutlineStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace footfall::ui
