// A QApplication that continues after an exception in an event handler.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QString>
#include <exception>

namespace footfall::ui {

/// An exception that leaves an event handler ends that event and nothing else. problemReported() then has a message
/// about what happened and what to do, once the event is over. Events are reported to the running FrameWatchdog.
class GuardedApplication : public QApplication {
  Q_OBJECT

 public:
  GuardedApplication(int& argc, char** argv);

  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  void problemReported(const QString& message);

 private:
  void report(const QString& message) noexcept;
};

/// The message of an exception in the user's language; for exhausted memory it says what to do.
QString errorText(const std::exception& error);

/// Calls `work` and returns the message of its exception; empty when there was none. It serves background jobs, which
/// must not throw.
template <typename Work>
QString errorOf(Work&& work) {
  try {
    work();
    return {};
  } catch (const std::exception& error) {
    return errorText(error);
  }
}

}  // namespace footfall::ui
