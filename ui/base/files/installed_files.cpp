// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/files/installed_files.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace footfall::ui {

QString samplesFolder(const QString& programFolder) {
  const QString installed = QDir::cleanPath(programFolder + QStringLiteral("/../share/footfall/samples"));
  const QString ofSources = QStringLiteral(FOOTFALL_SOURCE_SAMPLES);
  for (const QString& folder : {installed, ofSources}) {
    if (QFileInfo(folder).isDir()) return folder;
  }
  return {};
}

QString samplesFolder() { return samplesFolder(QCoreApplication::applicationDirPath()); }

}  // namespace footfall::ui
