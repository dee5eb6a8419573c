// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_dialogs.hpp"

#include <utility>

namespace footfall::ui {
namespace {

QFileDialog* makeDialog(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                        UsePath use) {
  auto* dialog = new QFileDialog(parent, title, QFileInfo(suggested).path(), nameFilter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, std::move(use));
  return dialog;
}

}  // namespace

QString suggestedPath(const LevelFile& level, const QString& ending) {
  if (!level.environment()) return QStringLiteral("./footfall") + ending;
  const QFileInfo file(QString::fromStdString(level.environment()->source));
  return file.path() + QLatin1Char('/') + file.completeBaseName() + ending;
}

QFileDialog* askForFile(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                        UsePath use) {
  QFileDialog* dialog = makeDialog(parent, title, nameFilter, suggested, std::move(use));
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->open();
  return dialog;
}

QFileDialog* askForTarget(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                          const QString& suffix, UsePath use) {
  QFileDialog* dialog = makeDialog(parent, title, nameFilter, suggested, std::move(use));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  dialog->setDefaultSuffix(suffix);
  dialog->selectFile(QFileInfo(suggested).fileName());
  dialog->open();
  return dialog;
}

}  // namespace footfall::ui
