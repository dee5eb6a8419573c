// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/step_status.hpp"

#include <QCoreApplication>
#include <QPainter>

#include "ui/base/look/icon.hpp"

namespace footfall::ui {

QString stateWord(StepState state) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("footfall::ui", text); };
  switch (state) {
    case StepState::Fresh:
      return tr("not run yet");
    case StepState::Running:
      return tr("running");
    case StepState::Done:
      return tr("done");
    case StepState::Cached:
      return tr("cached");
    case StepState::Stale:
      return tr("out of date");
    case StepState::Cancelled:
      return tr("cancelled");
    case StepState::Failed:
      return tr("failed");
    case StepState::Off:
      return tr("off");
    case StepState::Skipped:
      return tr("skipped");
  }
  return {};
}

QColor stateColour(StepState state, const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightnessF() < 0.5F;
  switch (state) {
    case StepState::Running:
      return dark ? QColor(86, 180, 233) : QColor(0, 92, 158);
    case StepState::Done:
      return dark ? QColor(60, 200, 155) : QColor(0, 105, 76);
    case StepState::Cached:
      return dark ? QColor(150, 195, 180) : QColor(62, 92, 84);
    case StepState::Stale:
    case StepState::Cancelled:
    case StepState::Skipped:
      return dark ? QColor(240, 190, 70) : QColor(128, 92, 0);
    case StepState::Failed:
      return dark ? QColor(255, 130, 90) : QColor(176, 32, 0);
    case StepState::Fresh:
    case StepState::Off:
      break;
  }
  return dark ? QColor(165, 172, 180) : QColor(104, 110, 118);
}

QPixmap stateMark(StepState state, const QPalette& palette, int side, qreal devicePixelRatio) {
  const auto name = [state] {
    switch (state) {
      case StepState::Running:
        return "state-running";
      case StepState::Done:
        return "state-done";
      case StepState::Cached:
        return "state-cached";
      case StepState::Stale:
        return "state-stale";
      case StepState::Cancelled:
        return "state-cancelled";
      case StepState::Failed:
        return "state-failed";
      case StepState::Off:
      case StepState::Skipped:
        return "state-off";
      case StepState::Fresh:
        break;
    }
    return "state-fresh";
  };
  QPixmap mark = icon(QLatin1String(name())).pixmap(QSize(side, side), devicePixelRatio);
  if (mark.isNull()) return mark;
  QPainter painter(&mark);
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(QRect(0, 0, side, side), stateColour(state, palette));
  return mark;
}

}  // namespace footfall::ui
