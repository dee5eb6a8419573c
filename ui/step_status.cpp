// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step_status.hpp"

#include <QCoreApplication>

namespace footfall {

QString stateWord(StepState state) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("footfall", text); };
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
  }
  return {};
}

QColor stateColour(StepState state) {
  switch (state) {
    case StepState::Running:
      return {0, 92, 158};
    case StepState::Done:
      return {0, 105, 76};
    case StepState::Cached:
      return {62, 92, 84};
    case StepState::Stale:
      return {128, 92, 0};
    case StepState::Cancelled:
      return {128, 92, 0};
    case StepState::Failed:
      return {176, 32, 0};
    case StepState::Fresh:
    case StepState::Off:
      break;
  }
  return {104, 110, 118};
}

}  // namespace footfall
