// The editor without a user: it writes pictures of the finished result and ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/editor_application.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// Writes a message of the program to standard error and returns `code`.
int failWith(int code, const QString& message);

/// The environment must be about to be opened. Both run the event loop and return the exit code: 0 done, 1 the run
/// failed or a picture cannot be written, 2 usage or input.
int takeScreenshot(EditorWindow& window, const EditorOptions& options);
int writeTurntable(EditorWindow& window, const EditorOptions& options);

}  // namespace footfall::ui
