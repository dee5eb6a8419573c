// What a row of the filter list knows about its step.
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
  std::optional<double> wallMs;  ///< of the last time it ran
  std::optional<std::uint64_t> trianglesIn, trianglesOut;
  QString note;   ///< the filter's own words
  QString error;  ///< when failed
};

QString stateWord(StepState state);
/// Readable on the window colour of `palette`, light or dark.
QColor stateColour(StepState state, const QPalette& palette);
/// A shape for each state, so that colours are not all that tells them apart; `side` in logical pixels.
QPixmap stateMark(StepState state, const QPalette& palette, int side, qreal devicePixelRatio);

}  // namespace footfall::ui
