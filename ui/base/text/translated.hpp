// tr() for functions that belong to no class.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace footfall::ui {

/// The tr() of a class hides this one inside the class; lupdate files both under the same context.
inline QString tr(const char* text, const char* comment = nullptr, int n = -1) {
  return QCoreApplication::translate("footfall::ui", text, comment, n);
}

}  // namespace footfall::ui
