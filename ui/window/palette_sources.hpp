// What the command palette finds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::ui {

class CommandPalette;
class CommandRegistry;
class Document;
class LevelFile;
class LevelOpening;
class RecentFiles;

/// Commands, filters to add, recent files and samples. All of them must outlive the palette.
void addPaletteSources(CommandPalette& palette, CommandRegistry& commands, Document& document, const LevelFile& file,
                       RecentFiles& recent, LevelOpening& opening);

}  // namespace footfall::ui
