// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/palette_sources.hpp"

#include <QFileInfo>

#include "footfall/filter.hpp"
#include "ui/base/commands/command_palette.hpp"
#include "ui/base/commands/commands.hpp"
#include "ui/base/files/installed_files.hpp"
#include "ui/base/files/recent_files.hpp"
#include "ui/base/look/icon.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/translated.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_file.hpp"
#include "ui/window/level_opening.hpp"
#include "ui/window/welcome_page.hpp"

namespace footfall::ui {
namespace {

std::vector<PaletteEntry> filterEntries(Document& document, const LevelFile& file) {
  std::vector<PaletteEntry> entries;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    PaletteEntry entry;
    entry.title = tr("Add %1").arg(filterText(filter.label));
    entry.detail = tr("Filter");
    entry.icon = icon(QStringLiteral("add"));
    entry.help = filterText(filter.help);
    entry.run = [&document, &file, &filter] {
      document.addFilter(filter, file.environment() ? file.environment()->metresPerUnit : 1);
    };
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<PaletteEntry> recentEntries(const RecentFiles& recent, LevelOpening& opening) {
  std::vector<PaletteEntry> entries;
  for (const QString& path : recent.paths()) {
    const QFileInfo file(path);
    PaletteEntry entry;
    entry.title = tr("Open %1").arg(file.fileName());
    entry.detail = file.path();
    entry.icon = icon(QStringLiteral("environment"));
    entry.enabled = file.exists();
    entry.help = path;
    entry.run = [&opening, path] { opening.openAsking(path); };
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<PaletteEntry> sampleEntries(LevelOpening& opening) {
  std::vector<PaletteEntry> entries;
  for (const Sample& sample : findSamples(samplesFolder())) {
    PaletteEntry entry;
    entry.title = tr("Open sample %1").arg(sample.title);
    entry.detail = sample.description;
    entry.icon = icon(QStringLiteral("environment"));
    entry.run = [&opening, sample] { opening.openSample(sample.path, sample.pipeline); };
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace

void addPaletteSources(CommandPalette& palette, CommandRegistry& commands, Document& document, const LevelFile& file,
                       RecentFiles& recent, LevelOpening& opening) {
  palette.addSource([&commands] { return commandEntries(commands); });
  palette.addSource([&document, &file] { return filterEntries(document, file); });
  palette.addSource([&recent, &opening] { return recentEntries(recent, opening); });
  palette.addSource([&opening] { return sampleEntries(opening); });
}

}  // namespace footfall::ui
