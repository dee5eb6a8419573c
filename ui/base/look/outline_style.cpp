// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/look/outline_style.hpp"

#include <QStyleOption>

namespace footfall::ui {
namespace {

// Fusion draws outlines in the window's colour darkened by 1.4; this palette makes that the Dark colour of the light
// palette.
QPalette withOutline(const QPalette& palette) {
  QPalette changed = palette;
  changed.setColor(QPalette::Window, palette.color(QPalette::WindowText).darker(160));
  return changed;
}

}  // namespace

OutlineStyle::OutlineStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void OutlineStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  const bool dark = option->palette.color(QPalette::Window).lightnessF() < 0.5F;
  if (dark && (element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton)) {
    if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option)) {
      QStyleOptionButton outlined = *button;
      outlined.palette = withOutline(button->palette);
      QProxyStyle::drawPrimitive(element, &outlined, painter, widget);
      return;
    }
  }
  if (dark && element == PE_FrameLineEdit) {
    if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option)) {
      QStyleOptionFrame outlined = *frame;
      outlined.palette = withOutline(frame->palette);
      QProxyStyle::drawPrimitive(element, &outlined, painter, widget);
      return;
    }
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

}  // namespace footfall::ui
