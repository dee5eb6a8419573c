// The question that confirms replacing a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>

namespace footfall::ui {

/// Calls `replace` when there is no such file (devices and pipes are written, not replaced), or when the user agrees;
/// else `keep`. Does not block.
void askReplacing(QWidget* parent, const QString& path, std::function<void()> replace, std::function<void()> keep = {});

/// Asks one question for all of these files; files that do not exist are ignored.
void askReplacing(QWidget* parent, const QStringList& paths, std::function<void()> replace,
                  std::function<void()> keep = {});

}  // namespace footfall::ui
