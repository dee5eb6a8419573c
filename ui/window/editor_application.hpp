// The editor as a program: everything after the command line has been read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <optional>
#include <string>

#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "ui/base/theme.hpp"
#include "ui/view/view_mode.hpp"
#include "ui/window/session.hpp"

namespace footfall::ui {

struct EditorOptions {
  std::string environment;  ///< a mesh or a session; empty: none
  std::optional<Pipeline> pipeline;
  ImportOptions import;
  std::string screenshot;            ///< a PNG to write instead of waiting for a user; empty: none
  QSize size;                        ///< of the window; empty: as it was last
  bool top = false;                  ///< look straight down
  std::optional<ViewMode> mode;      ///< of the view; empty: as the session says
  std::optional<CellsShown> cells;   ///< what to show of parallel blocks; empty: as the session says
  std::optional<ThemeChoice> theme;  ///< for this time; empty: as the user chose
  std::string language;              ///< for this time, as a code such as "de"; empty: as the user chose
};

/// Runs the editor until its window is closed, or until the screenshot is written. Returns the exit code: 0 done, 1
/// the run failed, 2 usage or input. Problems are one line on standard error.
int runEditor(int& argc, char** argv, const EditorOptions& options);

/// Why no window can be opened here, in one line; empty when one can. Qt itself would abort.
std::string findDisplayProblem();

/// Names, colours and style sheet of the program; tests call it too. Needs a QApplication.
void prepareApplication();

/// Asks OpenGL for what the view needs; before QApplication is made.
void requestOpenGl();

}  // namespace footfall::ui
