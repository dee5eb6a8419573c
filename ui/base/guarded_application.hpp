// A QApplication that outlives what goes wrong while it handles an event.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QString>
#include <exception>

namespace footfall::ui {

/// An exception that leaves the handling of an event ends that event and nothing else: problemReported() says what
/// happened and what to do, once the event is over. Events are told to the FrameWatchdog that runs.
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

/// An exception in words, in the user's language; where memory ran out, what to do about it.
QString errorText(const std::exception& error);

/// Calls `work` and gives back what went wrong in words; empty when nothing did. For jobs in the background, which must
/// not throw.
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
