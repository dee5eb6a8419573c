// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recent_files.hpp"

#include <QFileInfo>
#include <QSettings>

namespace footfall {
namespace {

constexpr qsizetype kMost = 10;
const auto kKey = QStringLiteral("recentFiles");

}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

QStringList RecentFiles::paths() const { return QSettings().value(kKey).toStringList(); }

void RecentFiles::add(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList paths = this->paths();
  paths.removeAll(absolute);
  paths.prepend(absolute);
  QSettings().setValue(kKey, QStringList(paths.mid(0, kMost)));
}

void RecentFiles::attachTo(QMenu* menu) {
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& path : paths()) {
      QAction* action = menu->addAction(QFileInfo(path).fileName());
      action->setToolTip(path);
      connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    if (menu->isEmpty()) menu->addAction(tr("(none yet)"))->setEnabled(false);
  });
  menu->setToolTipsVisible(true);
}

}  // namespace footfall
