// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/work/guarded_application.hpp"

#include <QMetaObject>
#include <cstdio>
#include <new>

#include "footfall/errors.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/work/frame_watchdog.hpp"

namespace footfall::ui {

GuardedApplication::GuardedApplication(int& argc, char** argv) : QApplication(argc, argv) {}

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  const FrameWatchdog::Handling handling(receiver, event);
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& error) {
    report(errorText(error));
  } catch (...) {
    report(tr("an unknown error occurred; save your session under another name and restart Footfall"));
  }
  return true;
}

// The message is sent later, because its receivers may need objects that the event still uses. When that fails, it goes
// to standard error.
void GuardedApplication::report(const QString& message) noexcept {
  try {
    std::fprintf(stderr, "footfall-editor: %s\n", qPrintable(message));
    QMetaObject::invokeMethod(
        this, [this, message] { emit problemReported(message); }, Qt::QueuedConnection);
  } catch (...) {
    std::fputs("footfall-editor: memory ran out\n", stderr);
  }
}

QString errorText(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) {
    return GuardedApplication::tr(
        "memory ran out; nothing was lost. Close other programs, or open a smaller environment");
  }
  const QString text = coreText(error);
  return dynamic_cast<const TextError*>(&error)
             ? text
             : GuardedApplication::tr("internal error (%1); please report it with what you did").arg(text);
}

}  // namespace footfall::ui
