// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_commands.hpp"

#include <QAction>

namespace footfall::ui {
void addExportCommands(CommandRegistry& commands, ResultExport& exports) {
  commands
      .add({QStringLiteral("file.plan"), CommandMenu::File, QStringLiteral("save"), ResultExport::tr("&Floor plan..."),
            ResultExport::tr("Draw plans of the storeys or layers to scale, as PDF or SVG")},
           [&exports](bool) { exports.showDialog(exportTarget(QStringLiteral("plan-pdf"))); })
      ->setEnabled(false);
  Command command;
  command.id = QStringLiteral("file.exportAgain");
  command.menu = CommandMenu::File;
  command.group = QStringLiteral("save");
  command.text = ResultExport::tr("Export a&gain");
  command.help = ResultExport::tr("Write to the file of the last export, with the same options");
  command.keys = {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)};
  QAction* again = commands.add(command, [&exports](bool) { exports.exportAgain(); });

  Command after;
  after.id = QStringLiteral("file.exportAfterRuns");
  after.menu = command.menu;
  after.group = command.group;
  after.text = ResultExport::tr("Export after each r&un");
  after.help =
      ResultExport::tr("Write every new result to the file of the last export, for another program that watches it");
  after.checkable = true;
  QAction* live = commands.add(after, [&exports](bool on) { exports.setAfterRuns(on); });

  const auto follow = [&exports, again, live] {
    again->setEnabled(exports.hasLast());
    live->setEnabled(exports.hasLast());
    live->setChecked(exports.afterRuns());
  };
  QObject::connect(&exports, &ResultExport::lastChanged, &exports, follow);
  follow();
}

}  // namespace footfall::ui
