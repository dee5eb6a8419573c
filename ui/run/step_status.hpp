// The status of a step, as its row in the filter list shows it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QPixmap>
#include <QString>
#include <cstdint>
#include <optional>

namespace footfall::ui {

enum class StepState { Fresh, Running, Done, Cached, Stale, Cancelled, Failed, Off, Skipped };

struct StepStatus {
  StepState state = StepState::Fresh;
  double fraction = 0;           ///< while running
  std::optional<double> wallMs;  ///< time of its last run
  std::optional<std::uint64_t> trianglesIn, trianglesOut;
  QString note;   ///< note of the filter
  QString error;  ///< when failed
};

QString stateWord(StepState state);
/// A colour that is readable on the window colour of `palette`, light or dark.
QColor stateColour(StepState state, const QPalette& palette);
/// A mark with a shape of its own for each state, so that states do not differ by colour only; `side` is in logical
/// pixels.
QPixmap stateMark(StepState state, const QPalette& palette, int side, qreal devicePixelRatio);

}  // namespace footfall::ui
