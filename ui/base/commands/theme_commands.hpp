// The commands of the menu View for light, dark and system colours.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/base/commands/commands.hpp"

namespace footfall::ui {

/// Needs Theme::instance(), and does nothing without it.
void addThemeCommands(CommandRegistry& commands);

}  // namespace footfall::ui
