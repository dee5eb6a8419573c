// The commands "Floor plan", "Export again" and "Export after each run".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/base/commands/commands.hpp"
#include "ui/window/result_export.hpp"

namespace footfall::ui {

/// The commands stand with the other exports of the File menu; they are enabled once something was exported.
void addExportCommands(CommandRegistry& commands, ResultExport& exports);

}  // namespace footfall::ui
