// Light, dark, or as the system, in the menu View.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/base/commands.hpp"

namespace footfall::ui {

/// Needs Theme::instance(), and does nothing without.
void addThemeCommands(CommandRegistry& commands);

}  // namespace footfall::ui
