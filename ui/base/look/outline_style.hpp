// The Fusion style with outlines that are visible on a dark background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace footfall::ui {

/// Fusion draws outlines darker than the window, which makes those of check boxes and fields invisible in a dark
/// window.
class OutlineStyle : public QProxyStyle {
  Q_OBJECT

 public:
  OutlineStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace footfall::ui
