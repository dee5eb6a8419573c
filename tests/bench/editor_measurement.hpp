// Measures the response of the editor's own window and widgets to a person: opening, turning, editing, dragging,
// switching agents.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <string>

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

inline constexpr double kEditDueMs = 50;    ///< limit from an edit to the first visible change
inline constexpr double kPauseDueMs = 100;  ///< limit of a pause in which the window answers nothing
inline constexpr QSize kBenchWindow(1100, 800);

struct EditorSubject {
  std::string environment;
  int edits = 12;     ///< edits of each parameter; 0: those parameters do not change the picture
  bool whole = true;  ///< true: with obstacles and agents
};

/// Needs a running GuardedApplication and a display. Members: "environment", "triangles", "opening", "repaint",
/// "turning", "series" (one for each parameter), "obstacle", "agents"; all times in ms, those of which there are
/// several as {"median", "most"}. Throws RunError.
Json measureEditor(const EditorSubject& subject);

}  // namespace footfall::bench
