// Dialogs that ask for a file, without waiting for it.
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

/// Beside the level's file, with its name and `ending`.
QString suggestedPath(const LevelFile& level, const QString& ending = {});

using UsePath = std::function<void(const QString&)>;

/// `use` gets the chosen file, which is there.
QFileDialog* askForFile(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                        UsePath use);

/// `use` gets the chosen name; what is there is not asked about (FileWriter::writeAsking() does).
QFileDialog* askForTarget(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                          const QString& suffix, UsePath use);

}  // namespace footfall::ui
