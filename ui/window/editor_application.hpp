// The editor as a program, after the command line has been parsed.
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
  QSize size;                        ///< size of the window; empty: its last size
  bool top = false;                  ///< camera straight down
  std::optional<ViewMode> mode;      ///< mode of the view; empty: that of the session
  std::optional<CellsShown> cells;   ///< where cells of parallel blocks are shown; empty: as in the session
  std::optional<ThemeChoice> theme;  ///< theme of this start; empty: the user's choice
  std::string language;              ///< language of this start, as a code such as "de"; empty: the user's choice
};

/// Runs the editor until its window is closed, or until the screenshot is written. Returns the exit code: 0 done, 1 the
/// run failed, 2 usage or input. A problem is one line on standard error.
int runEditor(int& argc, char** argv, const EditorOptions& options);

/// The reason why no window can be opened, in one line; empty when one can. Qt itself would abort.
std::string findDisplayProblem();

/// Sets names, colours and style sheet of the program; tests call it too. Needs a QApplication.
void prepareApplication();

/// Requests the OpenGL features that the view needs; called before QApplication is made.
void requestOpenGl();

}  // namespace footfall::ui
