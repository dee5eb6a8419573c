// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/turntable/turntable_feature.hpp"

#include <QFileInfo>

#include "ui/window/file_dialogs.hpp"
#include "ui/window/turntable/turntable_dialog.hpp"

namespace footfall::ui {

TurntableFeature::TurntableFeature(const Uses& uses)
    : QObject(&uses.window), uses_(uses), turntable_(uses.view, uses.controller, uses.queue, nullptr) {
  setObjectName(QStringLiteral("turntable"));
  QAction* action = uses_.commands.add(
      {QStringLiteral("file.turntable"), CommandMenu::File, QStringLiteral("save"), tr("&Turntable..."),
       tr("Write pictures from all around the level, as a sequence of PNG files")},
      [this](bool) { showDialog(); });
  action->setEnabled(false);
  connect(&uses_.controller, &RunController::finished, action, [action] { action->setEnabled(true); });
  connect(&turntable_, &Turntable::stopped, this,
          [this](const QString& message) { uses_.messages.showErrorOf(MessageSubject::Writing, message); });
  connect(&turntable_, &Turntable::finished, this, [this](const QString& folder, int frames) {
    const QString text = tr("Wrote %n frames to %1", "", frames).arg(folder);
    uses_.messages.finish(MessageSubject::Writing);
    uses_.status.say(StatusSubject::Note, text);
    uses_.log.add(MessageLevel::Note, text);
  });
}

void TurntableFeature::showDialog() {
  if (turntable_.isRunning()) return;
  TurntableSettings suggested = last_;
  suggested.folder = suggestedPath(uses_.level, QStringLiteral("-turntable"));
  auto* dialog = new TurntableDialog(suggested, &uses_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &TurntableDialog::requested, this, [this](const TurntableSettings& settings) {
    last_ = settings;
    turntable_.start(settings);
  });
  dialog->open();
}

}  // namespace footfall::ui
