// Finds the parts of the editor's window, as its child objects.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace footfall::test {

/// The child of a class of which the window has one; the program ends with a message where there is none.
template <class Part>
Part& partOf(const QObject& window) {
  auto* const part = window.findChild<Part*>();
  if (part == nullptr) qFatal("the window has no %s", Part::staticMetaObject.className());
  return *part;
}

}  // namespace footfall::test
