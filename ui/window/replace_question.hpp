// The question before a file is replaced.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>

namespace footfall::ui {

/// Calls `replace` when there is no such file (devices and pipes are written to, not replaced), or once somebody has
/// said that it may be replaced; else `keep`. Does not wait for the answer.
void askReplacing(QWidget* parent, const QString& path, std::function<void()> replace, std::function<void()> keep = {});

/// The same for all of these files with one question; those that are not there do not count.
void askReplacing(QWidget* parent, const QStringList& paths, std::function<void()> replace,
                  std::function<void()> keep = {});

}  // namespace footfall::ui
