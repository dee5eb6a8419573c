// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/files/recent_files.hpp"

#include <QFileInfo>
#include <QSettings>

namespace footfall::ui {
namespace {

constexpr qsizetype kMost = 10;
const auto kFilesKey = QStringLiteral("recentFiles");

}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

QStringList RecentFiles::paths() const { return QSettings().value(kFilesKey).toStringList(); }

void RecentFiles::add(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList paths = this->paths();
  paths.removeAll(absolute);
  paths.prepend(absolute);
  QSettings().setValue(kFilesKey, QStringList(paths.mid(0, kMost)));
  emit changed();
}

void RecentFiles::remove(const QString& path) {
  QStringList paths = this->paths();
  if (paths.removeAll(path) == 0) return;
  QSettings().setValue(kFilesKey, paths);
  emit changed();
}

void RecentFiles::attachTo(QMenu* menu) {
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& path : paths()) {
      const QFileInfo file(path);
      QString name = file.fileName();
      name.replace(QLatin1Char('&'), QLatin1String("&&"));
      QAction* action = menu->addAction(file.exists() ? name : tr("%1 (missing)").arg(name));
      action->setEnabled(file.exists());
      action->setToolTip(path);
      connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    if (menu->isEmpty()) menu->addAction(tr("(none yet)"))->setEnabled(false);
  });
  menu->setToolTipsVisible(true);
}

}  // namespace footfall::ui
