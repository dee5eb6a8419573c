// Words of functions that belong to no class.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace footfall::ui {

/// Where a class is, its own tr() hides this one; lupdate files what stands in the namespace under the same name.
inline QString tr(const char* text, const char* comment = nullptr, int n = -1) {
  return QCoreApplication::translate("footfall::ui", text, comment, n);
}

}  // namespace footfall::ui
