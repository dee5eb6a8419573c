// The editor as a program, after the command line has been parsed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <optional>
#include <string>

#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/view/view_mode.hpp"
#include "ui/window/session.hpp"

namespace footfall::ui {

struct EditorOptions {
  std::string environment;  ///< a mesh or a session; empty: none
  std::optional<Pipeline> pipeline;
  ImportOptions import;
  std::string screenshot;            ///< a PNG to write instead of waiting for a user; empty: none
  std::string turntable;             ///< a folder for pictures from all around, instead of waiting; empty: none
  int frames = 72;                   ///< of the turntable
  QSize size;                        ///< of the window and the turntable's frames; empty: as it was last
  bool top = false;                  ///< look straight down
  std::optional<ViewMode> mode;      ///< of the view; empty: as the session says
  std::optional<CellsShown> cells;   ///< what to show of parallel blocks; empty: as the session says
  std::optional<ThemeChoice> theme;  ///< for this time; empty: as the user chose
  std::string language;              ///< for this time, as a code such as "de"; empty: as the user chose
};

/// Runs the editor until its window is closed, or until the screenshot or the turntable is written. Returns the exit
/// code: 0 done, 1 the run failed, 2 usage or input. Problems are one line on standard error.
int runEditor(int& argc, char** argv, const EditorOptions& options);

/// The reason why no window can be opened, in one line; empty when one can. Qt itself would abort.
std::string findDisplayProblem();

/// Sets names, colours and style sheet of the program; tests call it too. Needs a QApplication.
void prepareApplication();

/// Requests the OpenGL features that the view needs; called before QApplication is made.
void requestOpenGl();

}  // namespace footfall::ui
