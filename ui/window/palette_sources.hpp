// The entries of the command palette.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::ui {

class CommandPalette;
class CommandRegistry;
class Document;
class LevelFile;
class LevelOpening;
class RecentFiles;

/// Adds commands, filters, recent files and samples. All arguments must outlive the palette.
void addPaletteSources(CommandPalette& palette, CommandRegistry& commands, Document& document, const LevelFile& file,
                       RecentFiles& recent, LevelOpening& opening);

}  // namespace footfall::ui
