// File dialogs that do not block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QString>
#include <functional>
#include <string>

#include "ui/level/level_file.hpp"

namespace footfall::ui {

inline std::string toPath(const QString& path) { return QFile::encodeName(path).toStdString(); }
inline QString fromPath(const std::string& path) { return QFile::decodeName(QByteArray::fromStdString(path)); }

/// A path beside the level's file, with its name and `ending`.
QString suggestedPath(const LevelFile& level, const QString& ending = {});

using UsePath = std::function<void(const QString&)>;

/// `use` receives the chosen file, which exists.
QFileDialog* askForFile(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                        UsePath use);

/// `use` receives the chosen name. The dialog does not confirm replacing a file (FileWriter::writeAsking() does).
QFileDialog* askForTarget(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                          const QString& suffix, UsePath use);

}  // namespace footfall::ui
